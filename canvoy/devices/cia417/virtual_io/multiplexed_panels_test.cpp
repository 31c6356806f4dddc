// Controllers that receive panels by PDOs and by multiplexed PDOs: frames of CiA 301, 7.2.3 in both
// modes. The panel is node 22 (16h).
#include "canvoy/devices/cia417/virtual_io/multiplexed_panels.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"

namespace canvoy::cia417::multiplexed_panels_test {
namespace {

constexpr std::int32_t heights[] = {0, 4'000'000, 7'000'000, 10'000'000};
constexpr CallControllerSettings calls = {.served = {FloorSet::between(1, 4)}};

template <MpdoMode mode>
struct CallController : CallControllerDevice<multiplexed_call_controller_layout<mode>> {
  explicit CallController(const Port& port)
      : CallControllerDevice<multiplexed_call_controller_layout<mode>>(port, 1, calls) {}
};
template <LiftControllerOptions options>
struct LiftController : LiftControllerDevice<options> {
  explicit LiftController(const Port& port)
      : LiftControllerDevice<options>(port, 1, {.calls = calls, .lift = {.floors = heights}}) {}
};

template <class Device>
class MultiplexedPanels : public testing::Test {
 protected:
  MultiplexedPanels() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(1s);
    cable.clear();
  }
  /// The panel sends a call up at floor 3 in both parts, in destination address mode.
  void send_call() {
    cable.send("516#80 11 5F 2B 02 01 01 03");
    cable.send("516#80 11 5F 2C 10 01 01 11");
  }
  /// Number of acknowledgements to panels of the call up at floor 3.
  std::size_t told(const std::string& record = "02 01 01 03 10 81") {
    cable.run_for(10ms);
    return static_cast<std::size_t>(std::ranges::count_if(
        cable.heard, [&](const auto& heard) { return wire_text(heard.frame) == "400#" + record; }));
  }
  Cable cable;
  Device device{cable.port(0)};
};

template <class Device>
using InDestinationAddressMode = MultiplexedPanels<Device>;
using DestinationDevices =
    testing::Types<CallController<MpdoMode::destination>, LiftController<LiftControllerOptions{}>>;
TYPED_TEST_SUITE(InDestinationAddressMode, DestinationDevices);

TYPED_TEST(InDestinationAddressMode, ARecordIsACall) {
  this->cable.send("516#80 11 5F 2B 02 01 01 03");
  EXPECT_EQ(this->told(), 0u) << "half of it";
  this->cable.send("516#80 11 5F 2C 10 01 01 11");
  EXPECT_EQ(this->told(), 1u);
}

TYPED_TEST(InDestinationAddressMode, TheRpdosAreThoseOfPart3) {
  const Dictionary& dictionary = this->device.node().dictionary();
  EXPECT_EQ(dictionary.number(0x1401, 1), 0x8000'0501u) << "that would be the node itself";
  EXPECT_EQ(dictionary.number(0x1416, 1), 0x516u);
  EXPECT_EQ(dictionary.number(0x1616, 0), 0xFFu);
  EXPECT_EQ(dictionary.number(0x147F, 1), 0x57Fu);
}

TYPED_TEST(InDestinationAddressMode, APanelWithAPdoOfItsOwnIsHeardAsWell) {
  this->cable.send("496#02 01 01 03 10 01");
  EXPECT_EQ(this->told(), 1u);
}

TYPED_TEST(InDestinationAddressMode, APartThatDoesNotBelongToTheOtherIsNoCall) {
  this->cable.send("516#80 11 5F 2B 02 01 01 02");
  this->cable.send("516#80 11 5F 2C 10 01 01 11");
  EXPECT_EQ(this->told(), 0u);
  EXPECT_EQ(this->told("02 01 01 02 10 81"), 0u);
}

TYPED_TEST(InDestinationAddressMode, APanelOfAnotherModeIsConfigured) {
  this->cable.send("601#23 16 14 01 16 05 00 80");
  this->cable.send("601#2F 16 16 00 FE 00 00 00");
  EXPECT_EQ(this->cable.last(0x581), "581#60 16 16 00 00 00 00 00");
  this->cable.send("601#23 16 14 01 16 05 00 00");
  this->cable.send("516#16 10 5F 01 02 01 01 03");
  this->cable.send("516#16 10 5F 02 10 01 01 11");
  EXPECT_EQ(this->told(), 1u);
}

TYPED_TEST(InDestinationAddressMode, AResetOfTheNodeKeepsThem) {
  this->cable.send("000#81 01");
  this->cable.send("000#01 01");
  this->cable.run_for(1s);
  this->cable.clear();
  this->send_call();
  EXPECT_EQ(this->told(), 1u);
}

TYPED_TEST(InDestinationAddressMode, InAnotherLiftTheyAreTheSame) {
  this->cable.send("601#2F 01 60 00 04 00 00 00");
  ASSERT_EQ(this->cable.last(0x581), "581#60 01 60 00 00 00 00 00");
  EXPECT_EQ(this->device.node().dictionary().number(0x1416, 1), 0x516u);
  this->cable.send("516#80 11 5F 2B 02 01 04 03");
  this->cable.send("516#80 11 5F 2C 10 01 01 14");
  EXPECT_EQ(this->told("02 01 04 03 10 81"), 1u);
}

template <class Device>
using InSourceAddressMode = MultiplexedPanels<Device>;
using SourceDevices =
    testing::Types<CallController<MpdoMode::source>,
                   LiftController<LiftControllerOptions{.multiplexed = MpdoMode::source}>>;
TYPED_TEST_SUITE(InSourceAddressMode, SourceDevices);

TYPED_TEST(InSourceAddressMode, ARecordIsACall) {
  this->cable.send("516#16 10 5F 01 02 01 01 03");
  EXPECT_EQ(this->told(), 0u) << "half of it";
  this->cable.send("516#16 10 5F 02 10 01 01 11");
  EXPECT_EQ(this->told(), 1u);
}

TYPED_TEST(InSourceAddressMode, EachNodeHasItsOwnParts) {
  this->cable.send("516#16 10 5F 01 02 01 01 03");
  this->cable.send("57F#7F 10 5F 01 02 02 01 04");
  this->cable.send("516#16 10 5F 02 10 01 01 11");
  EXPECT_EQ(this->told(), 1u);
  this->cable.send("57F#7F 10 5F 02 10 01 01 15");
  EXPECT_EQ(this->told("02 02 01 04 10 81"), 1u);
}

TEST(MultiplexedPanelsOfALift, OneThatIsNotAskedToHearThemIgnoresThem) {
  Cable cable;
  LiftController<LiftControllerOptions{.outputs = 0, .multiplexed = MpdoMode::none}> device(
      cable.port(0));
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("601#40 01 14 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#80 01 14 01 00 00 02 06");
  cable.send("601#40 00 62 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#80 00 62 01 00 00 02 06");
}

}  // namespace
}  // namespace canvoy::cia417::multiplexed_panels_test
