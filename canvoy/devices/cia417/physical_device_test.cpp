// Physical devices for an SDO client: their virtual devices and lifts (CiA 417-4, 4.1.1, 4.2.1 and
// 4.2.2).
#include <gtest/gtest.h>

#include <bit>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417::physical_device_test {
namespace {

/// One node on a cable, accessed by SDO.
template <const auto& layout>
class SdoBench {
 public:
  SdoBench() {
    cable.connect(0, device.node());
    cable.start_all();
  }
  /// The frame that answers.
  std::string ask(std::string_view request) {
    cable.clear();
    cable.send("605#" + std::string(request));
    return cable.last(0x585);
  }
  std::uint64_t number(unsigned index, unsigned sub) {
    return device.dictionary().number(static_cast<std::uint16_t>(index),
                                      static_cast<std::uint8_t>(sub));
  }
  bool has(unsigned index, unsigned sub = 0) {
    return static_cast<bool>(device.dictionary().find(static_cast<std::uint16_t>(index),
                                                      static_cast<std::uint8_t>(sub)));
  }

  Cable cable;
  DeviceNode<layout> device{cable.port(0), 5};
};

// Several virtual devices

constexpr auto controller = describe(
    physical_device<PhysicalOptions{}, VirtualDevice::call_controller,
                    VirtualDevice::car_door_controller, VirtualDevice::car_drive_controller>(
        {0x6010, 0x6011, {0x6300, 4}, {0x6301, 4}, {0x6302, 4}, 0x6400, 0x6401, 0x6406, 0x6420}),
    cia301::identity({}));
constexpr auto controller_layout = partial(lay_out_device<controller>());

TEST(PhysicalDevice, SeveralVirtualDevicesAreListedIn6000h) {
  SdoBench<controller_layout> bench;
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "585#43 00 10 00 A1 01 00 00") << "code 00";
  EXPECT_EQ(bench.ask("40 00 60 00 00 00 00 00"), "585#4F 00 60 00 03 00 00 00");
  EXPECT_EQ(bench.ask("40 00 60 01 00 00 00 00"), "585#4B 00 60 01 00 01 00 00");
  EXPECT_EQ(bench.ask("40 00 60 02 00 00 00 00"), "585#4B 00 60 02 00 04 00 00");
  EXPECT_EQ(bench.ask("40 00 60 03 00 00 00 00"), "585#4B 00 60 03 00 08 00 00");
  EXPECT_EQ(bench.ask("40 00 60 04 00 00 00 00"), "585#80 00 60 04 11 00 09 06");
  EXPECT_EQ(bench.ask("2B 00 60 01 00 02 00 00"), "585#80 00 60 01 02 00 01 06") << "ro";
}

TEST(PhysicalDevice, ItHasThePdosOfAllItsVirtualDevices) {
  SdoBench<controller_layout> bench;
  EXPECT_EQ(bench.number(0x1900, 1), 0x400u) << "of the call controller";
  EXPECT_EQ(bench.number(0x1908, 1), 0x200u) << "of the door controller";
  EXPECT_EQ(bench.number(0x1904, 1), 0x180u) << "of the drive controller";
  EXPECT_EQ(bench.number(0x150A, 1), 0x201u);
  EXPECT_EQ(bench.number(0x1505, 1), 0x181u);
  EXPECT_FALSE(bench.has(0x150B)) << "6310h is not there";
}

constexpr auto one_unit = describe(
    physical_device<PhysicalOptions{}, VirtualDevice::load_measuring_unit>({{0x6480, 2}, 0x6482}),
    cia301::identity({}));
constexpr auto one_unit_layout = partial(lay_out_device<one_unit>());

TEST(PhysicalDevice, OneVirtualDeviceIsNamedBy1000hAlone) {
  SdoBench<one_unit_layout> bench;
  EXPECT_EQ(bench.number(0x1000, 0), 0x0A00'01A1u);
  EXPECT_EQ(bench.ask("40 00 60 00 00 00 00 00"), "585#80 00 60 00 00 00 02 06");
}

constexpr auto landing =
    describe(panel<PanelOptions{.inputs = 2, .outputs = 3}>(), cia301::identity({}));
constexpr auto landing_layout = partial(lay_out_device<landing>());

TEST(PhysicalDevice, APanelOfInputsAndOutputsIsTwoVirtualDevicesWithoutALiftNumber) {
  SdoBench<landing_layout> bench;
  EXPECT_EQ(bench.number(0x1000, 0), 0x0000'01A1u);
  EXPECT_EQ(bench.number(0x6000, 0), 2u);
  EXPECT_EQ(bench.number(0x6000, 1), 0x0200u);
  EXPECT_EQ(bench.number(0x6000, 2), 0x0300u);
  EXPECT_FALSE(bench.has(0x6001));
  EXPECT_EQ(bench.number(0x1881, 1), 0x485u);
  EXPECT_EQ(bench.number(0x1500, 1), 0x400u);
}

constexpr auto small_landing = describe(
    panel<PanelOptions{.inputs = 2, .outputs = 3, .low_pdo_numbers = true, .valid_tpdo = false}>(),
    cia301::identity({}));
constexpr auto small_landing_layout = partial(lay_out_device<small_landing>());

TEST(PhysicalDevice, ASmallPanelMayHaveItsPdosAtLowNumbers) {
  SdoBench<small_landing_layout> bench;
  EXPECT_EQ(bench.number(0x1800, 1), 0x8000'0485u) << "and invalid until somebody makes it valid";
  EXPECT_EQ(bench.number(0x1A00, 1), 0x6010'0030u);
  EXPECT_EQ(bench.number(0x1400, 1), 0x400u);
  EXPECT_EQ(bench.number(0x1600, 1), 0x6011'0030u);
  EXPECT_FALSE(bench.has(0x1881));
  EXPECT_EQ(sizeof(DeviceNode<small_landing_layout>), sizeof(DeviceNode<landing_layout>))
      << "numbers below its own take no memory";
}

// Lifts

constexpr auto third_lift = describe(
    physical_device<PhysicalOptions{.lifts = lift_bit(3)}, VirtualDevice::load_measuring_unit>(
        {{0x6480, 2}, 0x6482}),
    cia301::identity({}));
constexpr auto third_lift_layout = partial(lay_out_device<third_lift>());

TEST(PhysicalDevice, ObjectsOfLift3Stand1000hAboveThoseOfLift1) {
  SdoBench<third_lift_layout> bench;
  EXPECT_EQ(bench.number(0x6001, 0), 0x04u);
  EXPECT_TRUE(bench.has(0x7480, 2));
  EXPECT_FALSE(bench.has(0x6480));
  EXPECT_FALSE(bench.has(0x7001)) << "6001h is there once";
  EXPECT_EQ(bench.number(0x1922, 1), 0x1A8u) << "load signaling of lift 3";
  EXPECT_EQ(bench.number(0x1B22, 1), 0x7482'0108u);
}

constexpr auto gateway = describe(
    physical_device<PhysicalOptions{.lifts = lift_bit(1) | lift_bit(2) | lift_bit(8)},
                    VirtualDevice::car_door_controller>({{0x6300, 4}, {0x6301, 4}, {0x6302, 4}}),
    cia301::identity({}));
constexpr auto gateway_layout = partial(lay_out_device<gateway>());

TEST(PhysicalDevice, ADeviceOfSeveralLiftsHasTheObjectsAndPdosOfEach) {
  SdoBench<gateway_layout> bench;
  EXPECT_EQ(bench.number(0x6001, 0), 0x83u);
  for (const unsigned index : {0x6300U, 0x6B00U, 0x9B00U}) EXPECT_TRUE(bench.has(index, 4));
  EXPECT_FALSE(bench.has(0x7300));
  EXPECT_EQ(bench.number(0x1908, 1), 0x200u);
  EXPECT_EQ(bench.number(0x1918, 1), 0x210u);
  EXPECT_EQ(bench.number(0x1978, 1), 0x270u);
}

// Lift number

/// 0609 0030h is the abort for 6001h.
std::string refused() {
  return "585#80 01 60 00 30 00 09 06";
}
template <class Bench>
std::string write_lifts(Bench& bench, unsigned lifts) {
  char request[32];
  std::snprintf(request, sizeof request, "2F 01 60 00 %02X 00 00 00", lifts);
  return bench.ask(request);
}

TEST(LiftNumber, ADeviceOfOneLiftRefusesSeveralAndThoseWhoseObjectsItHasNot) {
  SdoBench<third_lift_layout> bench;
  const LiftNumber sut(bench.device.node(), {});
  for (unsigned lifts = 1; lifts <= 0xFF; ++lifts) {
    const bool expected = lifts == 0x04;
    EXPECT_EQ(write_lifts(bench, lifts), expected ? "585#60 01 60 00 00 00 00 00" : refused());
    EXPECT_EQ(sut.lifts(), 0x04);
  }
  EXPECT_EQ(write_lifts(bench, 0).substr(0, 8), "585#80 0") << "00h is reserved";
}

TEST(LiftNumber, ADeviceThatCanBeBuiltAnewTakesAnyOneLiftAndTellsItsOwner) {
  SdoBench<one_unit_layout> bench;
  unsigned told = 0;
  auto changed = [&told](std::uint8_t lifts) { told = lifts; };
  const LiftNumber sut(bench.device.node(), {.changed = Callback<void(std::uint8_t)>::of(changed)});
  for (unsigned lifts = 1; lifts <= 0xFF; ++lifts) {
    told = 0;
    const bool expected = std::popcount(lifts) == 1;
    EXPECT_EQ(write_lifts(bench, lifts), expected ? "585#60 01 60 00 00 00 00 00" : refused());
    EXPECT_EQ(told, expected ? lifts : 0);
  }
  bench.cable.send("000#81 05");
  EXPECT_EQ(sut.lifts(), 0x01) << "the default of 4.2.2, where nothing is stored";
}

TEST(LiftNumber, ADeviceOfSeveralLiftsTakesThoseWhoseObjectsItHas) {
  SdoBench<gateway_layout> bench;
  const LiftNumber sut(bench.device.node(), {.several = true});
  for (unsigned lifts = 1; lifts <= 0xFF; ++lifts) {
    const bool expected = (lifts & ~0x83U) == 0;
    EXPECT_EQ(write_lifts(bench, lifts), expected ? "585#60 01 60 00 00 00 00 00" : refused())
        << lifts;
  }
}

}  // namespace
}  // namespace canvoy::cia417::physical_device_test
