// Emergency 0010h of each kind of device (CiA 417-1, 8.4): an error counter of its CAN controller
// has reached the warning limit.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"
#include "canvoy/devices/testing/every_device.hpp"
#include "canvoy/profiles/cia417.hpp"

namespace canvoy::cia417::bus_warning_test {
namespace {

/// A device on a cable, and the errors that it reports.
struct BusWarningTest : testing::TestWithParam<const DeviceKind*>, DeviceOnCable<DeviceOfKind> {
  BusWarningTest() : DeviceOnCable(*GetParam()) { start(); }
  void bus(BusState state) {
    device.node().bus_state(state, cable.now);
    cable.run_for(10ms);
  }
  /// Emergencies of communication errors, and of their ends, since the last call.
  std::vector<std::string> told() {
    const std::uint32_t id = 0x080U + device.node().id();
    std::vector<std::string> all;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == id) all.push_back(wire_text(heard.frame).substr(4));
    }
    cable.clear();
    return all;
  }
};
using Told = std::vector<std::string>;
constexpr const char* warning = "10 00 11 00 00 00 00 00";
constexpr const char* passive = "20 81 11 00 00 00 00 00";
constexpr const char* gone = "00 00 00 00 00 00 00 00";
constexpr const char* one_gone = "00 00 11 00 00 00 00 00";

TEST_P(BusWarningTest, TheWarningLimitAndItsEndAreTold) {
  bus(BusState::error_warning);
  EXPECT_EQ(told(), Told{warning});
  bus(BusState::error_active);
  EXPECT_EQ(told(), Told{gone});
}

TEST_P(BusWarningTest, ItHoldsWhileTheControllerIsErrorPassive) {
  bus(BusState::error_warning);
  bus(BusState::error_passive);
  EXPECT_EQ(told(), (Told{warning, passive}));
  bus(BusState::error_warning);
  EXPECT_EQ(told(), Told{one_gone});
  bus(BusState::error_active);
  EXPECT_EQ(told(), Told{gone});
}

TEST_P(BusWarningTest, ItIsToldWhereTheControllerSkipsIt) {
  bus(BusState::error_passive);
  EXPECT_EQ(told(), (Told{passive, warning}));
  bus(BusState::error_active);
  EXPECT_EQ(told(), (Told{one_gone, gone}));
}

TEST_P(BusWarningTest, ItEndsWithTheRecoveryFromBusOff) {
  bus(BusState::error_warning);
  told();
  bus(BusState::bus_off);
  EXPECT_EQ(told(), Told{});
  bus(BusState::error_active);
  EXPECT_EQ(told(), (Told{"40 81 11 00 00 00 00 00", one_gone, gone}));
}

TEST_P(BusWarningTest, ItIsToldAgainAfterAResetWhileItLasts) {
  for (const char* reset : {"000#81 00", "000#82 00"}) {
    bus(BusState::error_warning);
    told();
    cable.send(reset);
    cable.run_for(100ms);
    EXPECT_EQ(told(), Told{warning}) << reset;
    bus(BusState::error_active);
    EXPECT_EQ(told(), Told{gone}) << reset;
  }
}

std::vector<const DeviceKind*> of_lifts() {
  std::vector<const DeviceKind*> kinds = every_device_kind();
  std::erase_if(kinds, [](const DeviceKind* kind) { return kind->profile != &profile; });
  return kinds;
}
INSTANTIATE_TEST_SUITE_P(Every, BusWarningTest, testing::ValuesIn(of_lifts()),
                         [](const auto& each) { return test_name(*each.param); });

}  // namespace
}  // namespace canvoy::cia417::bus_warning_test
