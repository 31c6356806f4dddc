// Writes of parameters of analogue inputs of CiA 401 while the inputs move: changes that the host
// has not yet received are still sent. Objects are those of public sources (facts 6.1).
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia401/io_device.hpp"

namespace canvoy::cia401::analogue_parameters_test {
namespace {

constexpr std::uint32_t analogue_pdo = 0x2A1;

/// Node 33, operational, with a stick of two axes that may cause events.
class AnalogueParameters : public testing::Test {
 protected:
  AnalogueParameters() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 21");
    write("2F 23 64 00 01 00 00 00");
    cable.clear();
  }
  void move(unsigned axis, std::int16_t value) {
    axes.at(axis - 1) = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << 16);
  }
  void look() {
    device.unit().hardware_changed();
    cable.run_for(0s);
  }
  std::string ask(std::string_view request) {
    cable.send("621#" + std::string(request));
    return cable.last(0x5A1).substr(4);
  }
  void write(std::string_view request) { ASSERT_EQ(ask(request).substr(0, 2), "60") << request; }

  std::array<std::int32_t, 2> axes{};
  Cable cable;

 private:
  std::int32_t sense(unsigned channel) { return axes.at(channel - 1); }
  IoDevice<IoOptions{.analogue_inputs = 2, .all_widths = true}> device{
      cable.port(0),
      33,
      {.analogue_input = callback<&AnalogueParameters::sense>(*this)},
      {.sensing_period = Duration::zero()}};
};

/// All parameters, of the other axis and of none.
constexpr const char* writes_beside[] = {
    "2F 21 64 02 07 00 00 00",  // trigger
    "23 24 64 02 0A 00 00 00",  // limits
    "23 25 64 02 0A 00 00 00",
    "23 26 64 02 0A 00 00 00",  // deltas
    "23 27 64 02 0A 00 00 00", "23 28 64 02 0A 00 00 00",
    "23 29 64 02 00 00 80 3F",  // limits and deltas of floating-point values
    "23 2D 64 02 00 00 80 3F",
    "23 2E 64 02 00 00 80 3F",  // offset and scaling
    "23 2F 64 02 00 00 00 40",
    "23 30 64 01 00 00 01 00",  // SI unit
    "23 31 64 02 0A 00 00 00", "23 32 64 02 02 00 00 00", "2F 23 64 00 01 00 00 00",
};

/// It snaps back to its centre at the moment when the host writes.
TEST_F(AnalogueParameters, AWriteSwallowsNoChange) {
  for (const char* request : writes_beside) {
    move(1, 1000);
    look();
    ASSERT_EQ(cable.last(analogue_pdo).substr(0, 9), "2A1#E8 03") << request;
    move(1, 0);
    write(request);
    look();
    EXPECT_EQ(cable.last(analogue_pdo).substr(0, 9), "2A1#00 00") << request;
  }
}

/// Deltas count from the last value that the host has received.
TEST_F(AnalogueParameters, AWriteLeavesWhatWasToldLast) {
  write("2F 21 64 01 04 00 00 00");
  write("23 26 64 01 64 00 00 00");  // 100
  for (const char* request : {"23 26 64 02 0A 00 00 00", "23 26 64 01 64 00 00 00"}) {
    move(1, 0);
    look();
    cable.clear();
    move(1, 60);
    look();
    write(request);
    EXPECT_EQ(cable.count(analogue_pdo), 0U);
    move(1, 120);
    look();
    EXPECT_EQ(cable.last(analogue_pdo).substr(0, 9), "2A1#78 00") << request;
  }
}

TEST_F(AnalogueParameters, AWriteLeavesTheSources) {
  for (const char* request : writes_beside) {
    move(1, 1000);
    look();
    write(request);
    EXPECT_EQ(ask("40 22 64 01 00 00 00 00"), "43 22 64 01 01 00 00 00") << request;
    move(1, 0);
    look();
    ask("40 22 64 01 00 00 00 00");
  }
}

/// The value read follows offset and scaling at once, without an event; it is that of the last
/// check.
TEST_F(AnalogueParameters, ScalingIsThatOfOneInput) {
  move(1, 1000);
  move(2, 500);
  look();
  cable.clear();
  move(1, 0);
  move(2, 0);
  write("23 32 64 01 02 00 00 00");  // times 2
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 D0 07 00 00");
  EXPECT_EQ(ask("40 01 64 02 00 00 00 00"), "4B 01 64 02 F4 01 00 00");
  EXPECT_EQ(cable.count(analogue_pdo), 0U);
  look();
  EXPECT_EQ(cable.last(analogue_pdo), "2A1#00 00 00 00");
}

/// Events are off for a moment: a host that configures again.
TEST_F(AnalogueParameters, WhatMovedWhileEventsWereOffIsReadNotTold) {
  move(1, 1000);
  look();
  cable.clear();
  write("2F 23 64 00 00 00 00 00");
  move(1, 500);
  look();
  write("2F 23 64 00 01 00 00 00");
  look();
  EXPECT_EQ(cable.count(analogue_pdo), 0U);
  EXPECT_EQ(ask("40 01 64 01 00 00 00 00"), "4B 01 64 01 F4 01 00 00");
}

}  // namespace
}  // namespace canvoy::cia401::analogue_parameters_test
