// Real devices in the simulated bus: each in turn is a simulated device that the test puts on the
// cable. It is started, receives its data, and is supervised; what depends on it is not judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <string>

#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/worlds/bus_line/bus_day_test.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line::bus_real_device_test {
namespace {

using namespace cia407;

template <class... Kind>
constexpr const BusUnit* units[] = {&bus_unit<Kind>...};
template <InformationClass device_class>
using TextDisplay = PassengerInformationKind<device_class, InformationSubclass::text>;
using Units = std::span<const BusUnit* const>;

/// A device without hardware, and the invariants that cannot be judged where it is real.
struct RealCase {
  NodeId id;
  Units units;
  const char* undecided;
};
std::ostream& operator<<(std::ostream& out, const RealCase& it) {
  return out << "node " << unsigned{it.id};
}

/// Where one of two devices is simulated here, that one is judged.
constexpr const char* all_but_presence =
    "next_stop destination information lie texts stop_sign announcements tickets clock passengers "
    "pdo_tables service second_car second_announcements second_stop_sign false_stop_sign ";
const RealCase real_cases[] = {
    {computer_id, units<MainOnBoardComputerKind>, all_but_presence},
    {identification_id, units<IdentificationKind>,
     "next_stop destination information lie texts announcements tickets pdo_tables service "
     "second_car second_announcements "},
    {front_display_id, units<TextDisplay<InformationClass::destination>>, ""},
    {next_stop_id, units<TextDisplay<InformationClass::next_stop>>, "next_stop texts stop_sign "},
    {canceller_id, units<TicketCancellerKind>, ""},
    {printer_id, units<TicketPrinterKind>, ""},
    {information_id, units<TextDisplay<InformationClass::information>>, "information "},
    {announcer_id, units<AcousticAnnouncerKind>, "announcements "},
    {side_display_id, units<TextDisplay<InformationClass::destination>>, ""},
    {vehicle_gateway_id, units<VehicleGatewayKind>,
     "stop_sign passengers service second_stop_sign false_stop_sign early_departure left_behind "},
    {tachograph_id, units<TachographKind>, ""},
    {driver_display_id, units<DriverDisplayKind>, ""},
    {positioning_id, units<PositioningKind, TimeFixingKind>,
     "next_stop lie texts announcements tickets clock pdo_tables service second_car "
     "second_announcements "},
    {first_counter_id, units<PassengerCounterKind>, "passengers "},
    {counting_manager_id, units<CountingManagerKind>, "passengers "},
    {second_counter_id, units<PassengerCounterKind>, "passengers "},
    {train_gateway_id, units<TrainBusGatewayKind>,
     "second_car second_announcements second_stop_sign false_stop_sign "},
    {gateway_of(2), units<TrainBusGatewayKind>,
     "pdo_tables second_car second_announcements second_stop_sign false_stop_sign "},
    {destination_of(2), units<TextDisplay<InformationClass::destination>>, ""},
    {next_stop_of(2), units<TextDisplay<InformationClass::next_stop>>, "second_stop_sign "},
    {announcer_of(2), units<AcousticAnnouncerKind>, "second_announcements "},
};

std::string undecided(const BusNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.is_decided()) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

/// Invariants without a judgement by then even on a bus without real devices: no passenger has
/// pressed a button, or got out.
const std::string& undecided_anyway(Time until) {
  static const std::string names = [until] {
    BusNetworkOptions options;
    options.faults.seed = 1;
    BusNetwork network(options);
    network.run_until(until);
    return undecided(network);
  }();
  return names;
}
/// Union of both lists, in the order of the kinds.
std::string all_of_both(std::string_view first, std::string_view second) {
  std::string names;
  for (const InvariantRow& row : invariant_rows) {
    const std::string name = std::string(row.name) + " ";
    const auto has = [&](std::string_view list) {
      return (" " + std::string(list)).find(" " + name) != std::string::npos;
    };
    if (has(first) || has(second)) names += name;
  }
  return names;
}

/// A line on which one device is real.
class BusWith {
 public:
  explicit BusWith(const RealCase& it)
      : network(options_with(it.id)),
        bus_(car_of(it.id) - 1),
        node(network.world(), bus_, it.units, {.name = "real", .id = it.id}, environment_),
        display_({.columns = 24, .lines = 2}, callback<&BusWith::clock>(*this),
                 callback<&BusWith::changed>(*this), {}) {
    environment_.provide(callback<&ShownDisplay::hardware>(display_));
    environment_.provide(callback<&BusWith::announcer>(*this));
    environment_.provide(callback<&BusWith::gateway>(*this));
    master_ = network.world().bus(bus_).attach({});
  }
  /// Where the master is the real device, the test starts the others.
  void start_all() {
    network.world().bus(bus_).send(master_, Frame::data_frame(can_id::nmt, {1, 0}));
  }
  /// Reading of a vehicle gateway.
  VehicleReading vehicle{};
  const std::string& text() const { return display_.text(); }
  const std::string& announced() const { return announced_; }

 private:
  static BusNetworkOptions options_with(NodeId id) {
    BusNetworkOptions options;
    options.faults.seed = 1;
    options.real = {id};
    return options;
  }
  Time clock() { return network.now(); }
  void changed() {}
  VehicleGatewayHardware gateway() { return {.read = callback<&BusWith::read_vehicle>(*this)}; }
  VehicleReading read_vehicle() { return vehicle; }
  AcousticAnnouncerHardware announcer() {
    return {.announce = callback<&BusWith::announce>(*this)};
  }
  bool announce(std::uint32_t stop_point, std::string_view) {
    announced_ += std::to_string(stop_point) + " ";
    return true;
  }

 public:
  BusNetwork network;

 private:
  BusIndex bus_;
  Environment environment_;

 public:
  BusNode node;

 private:
  ShownDisplay display_;
  ControllerId master_{};
  std::string announced_;
};

class RealBusDevice : public testing::TestWithParam<RealCase> {};

constexpr Duration driven = 6min;  // to the first stops

TEST_P(RealBusDevice, HasItsPlaceAndIsSupervised) {
  BusWith bus(GetParam());
  bus.node.power(true);
  bus.network.run_until(Time(30s));
  if (GetParam().id == computer_id || GetParam().id == gateway_of(2)) bus.start_all();
  bus.network.run_until(Time(driven));
  EXPECT_TRUE(bus.node.is_operational());
  EXPECT_EQ(undecided(bus.network),
            all_of_both(undecided_anyway(Time(driven)), GetParam().undecided));
  EXPECT_EQ(broken(bus.network), "");
  bus.node.power(false);  // its last heartbeat holds for 2.5 s, and 10 s are allowed
  bus.network.run_until(Time(driven + 11s));
  EXPECT_EQ(broken(bus.network), "");
  bus.network.run_until(Time(driven + 14s));
  EXPECT_EQ(broken(bus.network), "device_missing ");
}

TEST_P(RealBusDevice, OneThatNeverComesIsMissingAfterAMinute) {
  BusWith bus(GetParam());
  bus.network.run_until(Time(69s));
  EXPECT_EQ(broken(bus.network), "");
  bus.network.run_until(Time(71s));
  EXPECT_EQ(broken(bus.network), "device_missing ");
}

INSTANTIATE_TEST_SUITE_P(EachNode, RealBusDevice, testing::ValuesIn(real_cases));

const RealCase& case_of(NodeId id) {
  return *std::ranges::find(real_cases, id, &RealCase::id);
}

TEST(RealBusDevices, AllPlacesAreTried) {
  const auto places = places_of(2);
  ASSERT_EQ(std::size(real_cases), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(real_cases[i].id, places[i].id);
}

// Its text follows the simulated vehicle, in both cars; and again after the display returns.
TEST(RealBusDevices, ADisplayFollowsTheVehicle) {
  for (const NodeId id : {next_stop_id, next_stop_of(2)}) {
    BusWith bus(case_of(id));
    bus.node.power(true);
    bus.network.run_until(Time(9min + 30s));
    EXPECT_EQ(bus.text(), bus.network.vehicle().truth().stop->name);
    bus.node.power(false);
    bus.network.run_until(Time(9min + 34s));
    bus.node.power(true);
    bus.network.run_until(Time(12min));
    EXPECT_EQ(bus.text(), bus.network.vehicle().truth().stop->name);
    EXPECT_NE(bus.text(), "");
  }
}

// The vehicle of this world follows a real one: so the displays show the stops of that one.
TEST(RealBusDevices, AVehicleGatewayLeadsTheVehicle) {
  BusWith bus(case_of(vehicle_gateway_id));
  bus.node.power(true);
  bus.network.run_until(Time(1min));
  const auto says = [&](double kmh, bool doors_open, Duration length) {
    bus.vehicle.speed_kmh = kmh;
    bus.vehicle.doors[0] = bus.vehicle.doors[1] = {.is_valid = true, .is_open = doors_open};
    bus.network.run_until(bus.network.now() + length);
  };
  BusVehicle& vehicle = bus.network.vehicle();
  says(0, false, 9min);
  EXPECT_TRUE(vehicle.truth().is_at_stop) << "the real one stands, though it is time to leave";
  EXPECT_EQ(vehicle.truth().place, 0u);
  says(0, true, 1min);
  EXPECT_TRUE(vehicle.door(0).is_open());
  says(0, false, 10s);
  says(36, false, 10s);
  EXPECT_NEAR(vehicle.odometer(), 100, 5);
  EXPECT_EQ(vehicle.truth().place, 1u);
  const Dictionary& display = bus.network.node(next_stop_id).node().dictionary();
  EXPECT_EQ(display.word(stop_point_id_object.index, 0), vehicle.truth().stop->number);
  bus.node.power(false);
  bus.network.run_until(bus.network.now() + 10min);
  EXPECT_GT(vehicle.truth().place, 1u) << "without it, the driver drives";
  EXPECT_EQ(broken(bus.network), "device_missing ");
}

TEST(RealBusDevices, AnAnnouncerHasItsCues) {
  for (const NodeId id : {announcer_id, announcer_of(2)}) {
    BusWith bus(case_of(id));
    bus.node.power(true);
    bus.network.run_until(Time(10min));
    EXPECT_EQ(bus.announced(), "1 2 3 4 ") << "stop points of the first journey";
  }
}

TEST(RealBusDevices, ACancellerKnowsWhatToStamp) {
  BusWith bus(case_of(canceller_id));
  bus.node.power(true);
  bus.network.run_until(Time(10min));
  const BusTruth truth = bus.network.vehicle().truth();
  const Dictionary& has = bus.node.node().dictionary();
  EXPECT_EQ(has.word(fare_zone_object.index, 0), truth.fare.zone);
  EXPECT_EQ(has.word(route_segment_number_object.index, 0), truth.fare.segment);
  EXPECT_EQ(has.word(block_id_object.index, 0), truth.block->number);
  const std::uint64_t without = bus.network.vehicle().riders().statistics().without_ticket;
  EXPECT_EQ(without, 0u) << "who puts a ticket in there has what he wanted";
}

// People see no sign where both devices with one are real: the driver stops for them all the same.
TEST(RealBusDevices, PeopleGetOutWhereNobodyHereSeesTheSign) {
  BusNetworkOptions options;
  options.faults.seed = 1;
  options.real = {next_stop_id, information_id};
  BusNetwork network(options);
  network.run_until(Time(35min));
  EXPECT_EQ(network.vehicle().riders().statistics().carried_past, 0u);
  EXPECT_GE(network.vehicle().riders().statistics().out, 5u);
  EXPECT_EQ(broken(network), "device_missing ");
}

// 6109h of a foreign on-board computer is no false message.
TEST(RealBusDevices, WhatARealComputerSaysIsNotJudgedByOurLine) {
  BusWith bus(case_of(computer_id));
  bus.node.power(true);
  bus.network.run_until(Time(30s));
  bus.start_all();
  bus.network.run_until(Time(2min));
  bus.node.with([&] { bus.node.device().virtual_device(1).tell(stop_point_id, 77); });
  bus.network.run_until(Time(3min));
  const Dictionary& has = bus.network.node(announcer_id).node().dictionary();
  EXPECT_EQ(has.word(stop_point_id_object.index, 0), 77u);
  EXPECT_EQ(broken(bus.network), "");
}

}  // namespace
}  // namespace canvoy::bus_line::bus_real_device_test
