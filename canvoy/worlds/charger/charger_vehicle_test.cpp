// The charging network in its vehicle: with the SDO manager of CiA 419, 6.1, and a clock (CiA 419,
// 4.1).
#include <gtest/gtest.h>

#include <vector>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

namespace canvoy::charger::charging_vehicle_test {
namespace {

constexpr NodeId charger = 5, manager = 1;

ChargerOptions in_vehicle() {
  using namespace std::chrono;
  ChargerOptions options;
  options.manager_id = manager;
  options.begin = sys_days{2026y / November / 21} + 18h;
  return options;
}

template <class What>
std::vector<What> events_of(const ChargerNetwork& network) {
  std::vector<What> found;
  for (const ChargerEvent& event : network.events()) {
    if (const auto* what = std::get_if<What>(&event.what)) found.push_back(*what);
  }
  return found;
}

std::vector<std::string> connections_of(const ChargerNetwork& network) {
  std::vector<std::string> texts;
  for (const auto& it : events_of<SdoConnectionChanged>(network)) {
    texts.push_back(std::to_string(it.client) + (it.is_given ? " -> " : " -/- ") +
                    std::to_string(it.server));
  }
  return texts;
}

/// Counts the frames of each CAN-ID.
struct FrameCount {
  explicit FrameCount(ChargerNetwork& network) {
    network.observe(
        {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
           ++static_cast<FrameCount*>(self)->frames.at(frame.id & Frame::id_max);
         }});
  }
  std::array<unsigned, Frame::id_max + 1> frames{};
};

TEST(ChargerInAVehicle, TheChargerGetsItsConnectionToTheBatteryFromTheManager) {
  ChargerNetwork sut(in_vehicle());
  const FrameCount count(sut);
  sut.run_until(Time(10s));
  EXPECT_EQ(connections_of(sut), (std::vector<std::string>{"5 -> 1", "5 -> 10"}));
  EXPECT_EQ(count.frames[0x6E0], 1U);
  EXPECT_NEAR(sut.snapshot().ampere, 60, 0.1);
  EXPECT_EQ(sut.battery().node().dictionary().number(0x1201, 3), charger);
}

/// Times at which the charger confirmed a write to its 1F10h: it is registered, or connected.
struct Confirmations {
  explicit Confirmations(ChargerNetwork& network) {
    network.observe(
        {.context = this, .on_frame = [](void* self, Time now, ControllerId, const Frame& frame) {
           const bool is_it = frame.id == 0x585 && frame.data[0] == 0x60 && frame.data[1] == 0x10 &&
                              frame.data[2] == 0x1F;
           if (is_it) static_cast<Confirmations*>(self)->times.push_back(now);
         }});
  }
  std::vector<Time> times;
};

TEST(ChargerInAVehicle, ARegistrationAndAConnectionAreToldWhenTheyAreConfirmed) {
  ChargerNetwork sut(in_vehicle());
  const Confirmations confirmations(sut);
  sut.run_until(Time(10s));
  std::vector<Time> told;
  for (const ChargerEvent& event : sut.events()) {
    if (std::holds_alternative<SdoConnectionChanged>(event.what)) told.push_back(event.at);
  }
  EXPECT_EQ(told.size(), 2U);
  EXPECT_EQ(told, confirmations.times);
}

TEST(ChargerInAVehicle, WithoutAManagerTheDefaultChannelDoes) {
  ChargerOptions options = in_vehicle();
  options.manager_id = 0;
  ChargerNetwork sut(options);
  sut.run_until(Time(10s));
  EXPECT_TRUE(connections_of(sut).empty());
  EXPECT_NEAR(sut.snapshot().ampere, 60, 0.1);
}

/// No other controller is on the bus: no frame of the charger is acknowledged (ISO 11898-1).
TEST(ChargerInAVehicle, WithoutAManagerAndABatteryTheChargerIsAlone) {
  ChargerOptions options = in_vehicle();
  options.plays_battery = false;
  for (const NodeId id : {manager, NodeId{0}}) {
    options.manager_id = id;
    ChargerNetwork sut(options);
    const FrameCount count(sut);
    sut.run_until(Time(10s));
    EXPECT_EQ(count.frames[0x705] > 0, id != 0) << unsigned{id};
  }
}

TEST(ChargerInAVehicle, TheConnectionToABatteryThatRestartsEndsAndTheChargeGoesOn) {
  ChargerOptions options = in_vehicle();
  options.faults.faults = {{FaultKind::battery_restart, Time(1min)}};
  ChargerNetwork sut(options);
  sut.run_until(Time(2min));
  const std::vector<std::string> connections = connections_of(sut);
  EXPECT_EQ(std::ranges::count(connections, "5 -/- 10"), 1);
  EXPECT_NEAR(sut.snapshot().ampere, 60, 0.1);
}

TEST(ChargerInAVehicle, TheChargerTellsTheTimeEachMinute) {
  ChargerNetwork sut(in_vehicle());
  const FrameCount count(sut);
  sut.run_until(Time(10min));
  EXPECT_NEAR(count.frames[0x100], 10, 1);
  const auto seen = events_of<TimeSeen>(sut);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].time.days, 15'665);
  EXPECT_GE(seen[0].time.milliseconds, 64'800'000U);
  EXPECT_LT(seen[0].time.milliseconds, 64'800'000U + 61'000U);
}

TEST(ChargerInAVehicle, AChargerWithoutAClockTellsNoTime) {
  ChargerOptions options = in_vehicle();
  options.begin.reset();
  ChargerNetwork sut(options);
  const FrameCount count(sut);
  sut.run_until(Time(10min));
  EXPECT_EQ(count.frames[0x100], 0U);
  EXPECT_TRUE(events_of<TimeSeen>(sut).empty());
}

TEST(ChargerInAVehicle, TheBatteryIsFilledAndEveryInvariantHolds) {
  ChargerOptions options = in_vehicle();
  options.state_of_charge = 0.9;
  ChargerNetwork sut(options);
  sut.run_until(Time(3h));
  EXPECT_TRUE(sut.all_hold());
  EXPECT_EQ(sut.snapshot().reason, cia419::StopReason::battery_full);
  EXPECT_GT(sut.snapshot().state_of_charge, 0.95);
}

}  // namespace
}  // namespace canvoy::charger::charging_vehicle_test
