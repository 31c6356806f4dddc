// Settings of a maker for an input and output module (IoSettings), at its wire.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia401/io_device.hpp"

namespace canvoy::cia401::io_settings_test {
namespace {

/// Node 33, operational, with eight contacts and one voltage that the test sets.
class IoSettingsTest : public testing::Test {
 protected:
  void begin(const IoSettings& settings) {
    const IoHardware hardware = {.digital_inputs = callback<&IoSettingsTest::sense_contacts>(*this),
                                 .drive_digital = {},
                                 .analogue_input = callback<&IoSettingsTest::sense_volts>(*this),
                                 .drive_analogue = {}};
    device = std::make_unique<Sensors>(cable.port(0), 33, hardware, settings);
    cable.connect(0, device->node());
    cable.start_all();
    cable.send("000#01 21");
    cable.clear();
  }
  void write(std::string_view request) {
    cable.send("621#" + std::string(request));
    ASSERT_EQ(cable.last(0x5A1).substr(4, 2), "60") << request;
  }

  using Sensors = IoDevice<IoOptions{.digital_inputs = 8, .analogue_inputs = 1}>;
  std::uint8_t contacts = 0;
  std::int32_t volts = 0;
  Cable cable;
  std::unique_ptr<Sensors> device;

 private:
  std::uint8_t sense_contacts(unsigned) { return contacts; }
  std::int32_t sense_volts(unsigned) { return volts; }
};

/// From the start on, again and again.
TEST_F(IoSettingsTest, InputsAreLookedAtEachPeriod) {
  begin({.sensing_period = Duration(10ms)});
  contacts = 0x01;
  cable.run_until(Time(10ms) - Duration(1us));
  EXPECT_EQ(cable.count(0x1A1), 0u);
  cable.run_until(Time(10ms));
  EXPECT_EQ(cable.last(0x1A1), "1A1#01");
  contacts = 0x03;
  cable.run_until(Time(20ms) - Duration(1us));
  EXPECT_EQ(cable.count(0x1A1), 1u);
  cable.run_until(Time(20ms));
  EXPECT_EQ(cable.last(0x1A1), "1A1#03");
  contacts = 0x00;
  cable.run_until(Time(30ms));
  EXPECT_EQ(cable.last(0x1A1), "1A1#00");
}

/// 6426h in units of 6401h, or of all 32 bits of the converter.
TEST_F(IoSettingsTest, DeltasCountInTheUnitsThatTheMakerSays) {
  for (const bool is_left_adjusted : {false, true}) {
    begin({.sensing_period = Duration(1ms),
           .analogue = {.limits_are_left_adjusted = is_left_adjusted}});
    write("2F 23 64 00 01 00 00 00");
    write("2F 21 64 01 04 00 00 00");
    write(is_left_adjusted ? "23 26 64 01 00 00 0A 00" : "23 26 64 01 0A 00 00 00");  // 10
    cable.clear();
    volts = 10 << 16;
    cable.run_for(1ms);
    EXPECT_EQ(cable.count(0x2A1), 0u) << is_left_adjusted;
    volts = 11 << 16;
    cable.run_for(1ms);
    EXPECT_EQ(cable.last(0x2A1), "2A1#0B 00") << is_left_adjusted;
    volts = 0;
  }
}

// Outputs in objects of several widths.

/// Node 33, operational, with an input and an output.
class AnalogueOutput : public testing::Test {
 protected:
  AnalogueOutput() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 21");
  }
  std::string ask(std::string_view request) {
    cable.send("621#" + std::string(request));
    return cable.last(0x5A1).substr(4);
  }

  Cable cable;
  std::int32_t driven = 0;  ///< full scale is that of 32 bits

 private:
  void drive(unsigned /*channel*/, std::int32_t value) { driven = value; }
  IoDevice<IoOptions{.analogue_inputs = 1, .analogue_outputs = 1, .all_widths = true}> device{
      cable.port(0),
      33,
      {.drive_analogue = callback<&AnalogueOutput::drive>(*this)},
      {.sensing_period = Duration::zero()}};
};

/// 2 is reserved.
TEST_F(AnalogueOutput, AnErrorModeThatIsNoneIsRefused) {
  EXPECT_EQ(ask("2F 43 64 01 02 00 00 00"), "80 43 64 01 30 00 09 06");
  EXPECT_EQ(ask("2F 43 64 01 FF 00 00 00"), "80 43 64 01 30 00 09 06");
  EXPECT_EQ(ask("40 43 64 01 00 00 00 00"), "4F 43 64 01 01 00 00 00");
  EXPECT_EQ(ask("2F 43 64 01 00 00 00 00"), "60 43 64 01 00 00 00 00");
}

/// 6410h, 6411h, 6412h and 6413h are one output: each of them shows its value, whichever was
/// written.
TEST_F(AnalogueOutput, IsReadInEachWidthWhateverItWasWrittenBy) {
  const auto write = [this](const std::string& request) {
    EXPECT_EQ(ask(request).substr(0, 2), "60") << request;
  };
  const auto expect_all = [this](const char* of_8, const char* of_16, const char* of_32,
                                 const char* real) {
    EXPECT_EQ(ask("40 10 64 01 00 00 00 00"), of_8);
    EXPECT_EQ(ask("40 11 64 01 00 00 00 00"), of_16);
    EXPECT_EQ(ask("40 12 64 01 00 00 00 00"), of_32);
    EXPECT_EQ(ask("40 13 64 01 00 00 00 00"), real);
  };
  write("23 13 64 01 00 00 00 3F");  // 0.5
  expect_all("4F 10 64 01 40 00 00 00", "4B 11 64 01 00 40 00 00", "43 12 64 01 00 00 00 40",
             "43 13 64 01 00 00 00 3F");
  write("2B 11 64 01 00 C0 00 00");  // -16384
  expect_all("4F 10 64 01 C0 00 00 00", "4B 11 64 01 00 C0 00 00", "43 12 64 01 00 00 00 C0",
             "43 13 64 01 00 00 00 BF");
  write("2F 10 64 01 20 00 00 00");
  expect_all("4F 10 64 01 20 00 00 00", "4B 11 64 01 00 20 00 00", "43 12 64 01 00 00 00 20",
             "43 13 64 01 00 00 80 3E");
  write("23 12 64 01 00 00 00 60");
  expect_all("4F 10 64 01 60 00 00 00", "4B 11 64 01 00 60 00 00", "43 12 64 01 00 00 00 60",
             "43 13 64 01 00 00 40 3F");
  cable.send("000#02 21");  // 6444h, which is 0
  cable.send("000#80 21");
  expect_all("4F 10 64 01 00 00 00 00", "4B 11 64 01 00 00 00 00", "43 12 64 01 00 00 00 00",
             "43 13 64 01 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia401::io_settings_test
