// Node-IDs that a gateway reserves for devices: by identity (1018h), or by the virtual device that
// an unknown device provides.
#include "canvoy/devices/cia447/kit/car_places.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/remote/identity.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"

namespace canvoy::cia447::car_places_test {
namespace {

constexpr std::uint32_t other_maker = 0x2F0;

LssPattern maker_is(std::uint32_t vendor) {
  LssPattern pattern;
  pattern.address.parts[LssAddress::vendor] = vendor;
  pattern.known[LssAddress::vendor] = true;
  return pattern;
}

struct AddOn {
  AddOn(Cable& cable, std::size_t place, std::span<const CarUnit* const> units,
        const IdentityValues& values)
      : device(units, cable.port(place), node_id_unconfigured, environment),
        identity(device.node(), values),
        lss(device.node()) {
    cable.connect(place, device.node());
  }
  NodeId id() { return device.node().id(); }
  bool is_at_work() { return device.node().state() == NmtState::operational; }

  Environment environment;
  CarDevice device;
  Identity identity;
  LssSlave lss;
};

class CarWithPlaces : public testing::Test {
 protected:
  explicit CarWithPlaces(std::vector<CarPlace> kept = {}) : places(std::move(kept)) {
    cable.connect(0, device.node());
  }
  AddOn& add(std::span<const CarUnit* const> units, std::uint32_t vendor = other_maker) {
    const auto serial = static_cast<std::uint32_t>(add_ons.size());
    return add_ons.emplace_back(cable, add_ons.size() + 1, units,
                                IdentityValues{.vendor_id = vendor, .serial_number = serial});
  }
  void run() {
    cable.start_all();
    cable.run_for(20s);
  }

  std::vector<CarPlace> places;
  Cable cable;
  Environment environment;
  CarDevice device{only_unit<BlueLightKind>, cable.port(0), 1, environment};
  CarMaster master{device.network(), device.sleep(), {}, {.places = places}};
  std::deque<AddOn> add_ons;
};

struct ForOneMaker : CarWithPlaces {
  ForOneMaker() : CarWithPlaces({{.id = 5, .identity = maker_is(other_maker)}}) {}
};
TEST_F(ForOneMaker, APlaceIsForTheIdentityThatIsKnown) {
  AddOn& another = add(only_unit<PrinterKind>, 7);
  AddOn& his = add(only_unit<PrinterKind>);
  AddOn& his_second = add(only_unit<PrinterKind>);
  run();
  EXPECT_EQ(another.id(), 2);
  // Fastscan decides which of the maker's two devices is found first.
  EXPECT_TRUE((his.id() == 5 && his_second.id() == 3) || (his.id() == 3 && his_second.id() == 5))
      << unsigned{his.id()} << " " << unsigned{his_second.id()};
}

struct ForAnyPrinter : CarWithPlaces {
  ForAnyPrinter() : CarWithPlaces({{.id = 3, .provides = &printer_device}}) {}
};
TEST_F(ForAnyPrinter, TheOnlyPlaceIsForWhoeverComes) {
  AddOn& printer = add(only_unit<PrinterKind>);
  run();
  EXPECT_EQ(printer.id(), 3);
  EXPECT_TRUE(printer.is_at_work());
  EXPECT_EQ(cable.count(0x7E5) > 0, true);
  for (const Cable::Heard& heard : cable.heard) {
    EXPECT_NE(wire_text(heard.frame), "000#82 03") << "it is named once";
  }
}

TEST_F(ForAnyPrinter, WhoTurnsOutToBeNoneLeavesIt) {
  AddOn& alarm = add(only_unit<TaxiAlarmKind>);
  run();
  EXPECT_EQ(alarm.id(), 2);
  EXPECT_TRUE(alarm.is_at_work());
  AddOn& printer = add(only_unit<PrinterKind>);
  printer.device.node().start(cable.now);
  cable.run_for(20s);
  EXPECT_EQ(printer.id(), 3);
  EXPECT_TRUE(printer.is_at_work());
}

struct ForSeveral : CarWithPlaces {
  ForSeveral()
      : CarWithPlaces({{.id = 3, .provides = &printer_device},
                       {.id = 4, .provides = &driver_identification_device},
                       {.id = 8, .provides = &taxi_alarm_system_device}}) {}
};
TEST_F(ForSeveral, EachSaysWhatItIsAndIsNamedOnceMore) {
  AddOn& alarm = add(only_unit<TaxiAlarmKind>);
  AddOn& driver = add(only_unit<DriverIdentificationKind>);
  AddOn& printer = add(only_unit<PrinterKind>);
  AddOn& light = add(only_unit<BlueLightKind>);
  run();
  EXPECT_EQ(printer.id(), 3);
  EXPECT_EQ(driver.id(), 4);
  EXPECT_EQ(alarm.id(), 8);
  EXPECT_TRUE(light.id() == 2 || (light.id() >= 5 && light.id() <= 7))
      << "one that no place is kept for: " << unsigned{light.id()};
  for (AddOn& each : add_ons) EXPECT_TRUE(each.is_at_work()) << unsigned{each.id()};
  EXPECT_EQ(master.known().find(LssAddress{{other_maker, 44710, 0, 2}}).has_value(), true);
}

TEST_F(ForSeveral, ThePlaceIsKeptWhileItsDeviceIsAway) {
  AddOn& printer = add(only_unit<PrinterKind>);
  run();
  ASSERT_EQ(printer.id(), 3);
  cable.cut(1);
  cable.run_for(10s);
  AddOn& light = add(only_unit<BlueLightKind>);
  light.device.node().start(cable.now);
  cable.run_for(20s);
  EXPECT_EQ(light.id(), 2);
  printer.device.node().set_power_on_id(node_id_unconfigured);
  printer.device.node().set_pending_id(node_id_unconfigured);
  printer.device.node().start(cable.now);
  cable.cut(1, false);
  cable.run_for(20s);
  EXPECT_EQ(printer.id(), 3);
  EXPECT_TRUE(printer.is_at_work());
}

/// 4.2.13.1 and 4.2.13.2 are mapped by TPDO 72, 4.2.17.1 by TPDO 71.
TEST(DeviceMark, IsATpdoThatPart4Predefines) {
  EXPECT_EQ(mark_of(printer_device).index, 0x1800 + 71);
  EXPECT_EQ(mark_of(taxi_alarm_system_device).index, 0x1800 + 70);
  EXPECT_EQ(mark_of(printer_device).sub, 1);
}

const VirtualDeviceInfo* provided_by(const DeviceKind& kind) {
  return kind.car_unit->provides;
}

/// No other virtual device of ours would be taken for it.
TEST(DeviceMark, TellsEachVirtualDeviceFromAllOthers) {
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->car_unit == nullptr) continue;
    const DeviceMark mark = mark_of(*provided_by(*kind));
    for (const DeviceKind* other : device_catalogue()) {
      if (other->car_unit == nullptr) continue;
      const CarUnit* const units[] = {other->car_unit};
      const std::vector<Part> parts = car_parts(units);
      const bool has = std::ranges::any_of(parts, [mark](const Part& part) {
        return mark.index >= part.index() && mark.index - part.index() < part.count();
      });
      EXPECT_EQ(has, other == kind) << other->info.name << " as " << kind->info.name;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia447::car_places_test
