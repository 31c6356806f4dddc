// Entries of 6200h in a lift controller of a building: the outputs of its panels and their states,
// as a tool on the bus reads them (CiA 417-4, 4.4.1).
#include <gtest/gtest.h>

#include <optional>

#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::lift::lift_outputs_test {
namespace {

/// A tool on the bus of a lift that reads the outputs of node 1 by SDO.
class OutputReader {
 public:
  explicit OutputReader(LiftNetwork& network) : network_(network) {
    const SlotIndex slot = network.world().add_slot(0, {.accept_all = true});
    port_ = network.world().port(slot);
    network.world().occupy(slot, *this);
    network.world().start(slot);
  }

  void start(Time) {}
  void receive(const Frame& frame, Time) {
    if (frame.id == 0x581) answer_ = frame;
  }
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {}
  void overrun(Time) {}

  /// Reads 6200h:sub in two segments; empty where it is refused.
  std::optional<std::array<std::uint8_t, 6>> read(unsigned sub) {
    const Frame header = ask({0x40, 0x00, 0x62, static_cast<std::uint8_t>(sub), 0, 0, 0, 0});
    if (header.data[0] != 0x41) return std::nullopt;
    const Frame segment = ask({0x60, 0, 0, 0, 0, 0, 0, 0});
    std::array<std::uint8_t, 6> record{};
    std::copy_n(segment.data.begin() + 1, 6, record.begin());
    return record;
  }
  /// The function data of the output with these first five bytes.
  std::optional<unsigned> shown(std::array<std::uint8_t, 5> wanted) {
    for (unsigned sub = 1; sub <= 254; ++sub) {
      const auto record = read(sub);
      if (!record) return std::nullopt;
      if (std::equal(wanted.begin(), wanted.end(), record->begin())) return record->at(5);
    }
    return std::nullopt;
  }

 private:
  Frame ask(std::array<std::uint8_t, 8> request) {
    answer_ = {};
    port_.send(port_.context, Frame::data_frame(0x601, request));
    network_.run_until(network_.now() + 5ms);
    return answer_;
  }

  LiftNetwork& network_;
  Port port_{};
  Frame answer_{};
};

TEST(OutputsOfALiftInABuilding, AreThoseOfItsPanelsWithWhatTheyShow) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(20s), .from = 4, .to = 2, .mass_kg = 80}};
  LiftNetwork network(description);
  OutputReader reader(network);
  network.run_until(Time(10s));
  constexpr std::array<std::uint8_t, 5> down_at_4 = {0x02, 0x02, 0x01, 0x04, 0x10};
  constexpr std::array<std::uint8_t, 5> up_at_1 = {0x02, 0x01, 0x01, 0x01, 0x10};
  constexpr std::array<std::uint8_t, 5> car_at_1 = {0x40, 0x01, 0x01, 0x04, 0x10};
  constexpr std::array<std::uint8_t, 5> to_2 = {0x05, 0x02, 0x01, 0x00, 0x11};
  EXPECT_EQ(reader.shown(down_at_4), 0x00U);
  EXPECT_EQ(reader.shown(up_at_1), 0x00U);
  EXPECT_EQ(reader.shown(car_at_1), 0x01U) << "the display at landing 4";
  EXPECT_EQ(reader.shown(to_2), 0x00U);
  network.run_until(Time(22s));
  EXPECT_EQ(reader.shown(down_at_4), 0x81U) << "affirmed";
  EXPECT_EQ(reader.shown(up_at_1), 0x00U);
  network.run_until(Time(90s));
  EXPECT_EQ(reader.shown(down_at_4), 0x00U) << "served";
  EXPECT_EQ(network.summary().served, 1U);
}

}  // namespace
}  // namespace canvoy::lift::lift_outputs_test
