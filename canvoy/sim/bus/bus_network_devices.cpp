// The devices of a bus, what they find there, and how their messages are linked.
#include <algorithm>
#include <cmath>
#include <string>

#include "canvoy/devices/cia407/motion_recognition.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/sim/device_name.hpp"

namespace canvoy::bus {

namespace {

using namespace cia407;

template <class... Kind>
constexpr const BusUnit* units_of[] = {&bus_unit<Kind>...};

template <InformationClass device_class>
using TextDisplay = PassengerInformationKind<device_class, InformationSubclass::text>;

/// What stands at each place.
struct PlaceUnits {
  NodeId id;
  std::span<const BusUnit* const> units;
};
constexpr PlaceUnits place_units[] = {
    {computer_id, units_of<MainOnBoardComputerKind, LineControlKind>},
    {identification_id, units_of<IdentificationKind>},
    {front_display_id, units_of<TextDisplay<InformationClass::destination>>},
    {next_stop_id, units_of<TextDisplay<InformationClass::next_stop>>},
    {canceller_id, units_of<TicketCancellerKind>},
    {printer_id, units_of<TicketPrinterKind>},
    {information_id, units_of<TextDisplay<InformationClass::information>>},
    {announcer_id, units_of<AcousticAnnouncerKind>},
    {side_display_id, units_of<TextDisplay<InformationClass::destination>>},
    {vehicle_gateway_id, units_of<VehicleGatewayKind>},
    {tachograph_id, units_of<TachographKind>},
    {driver_display_id, units_of<DriverDisplayKind>},
    {positioning_id, units_of<PositioningKind, TimeFixingKind>},
    {first_counter_id, units_of<PassengerCounterKind>},
    {counting_manager_id, units_of<CountingManagerKind>},
    {second_counter_id, units_of<PassengerCounterKind>},
    {train_gateway_id, units_of<TrainBusGatewayKind>},
    {second_gateway_id, units_of<TrainBusGatewayKind, MirrorControlKind>},
    {second_destination_id, units_of<TextDisplay<InformationClass::destination>>},
    {second_next_stop_id, units_of<TextDisplay<InformationClass::next_stop>>},
    {second_announcer_id, units_of<AcousticAnnouncerKind>},
};
static_assert(std::size(place_units) == device_places.size());

std::span<const BusUnit* const> units_at(NodeId id) {
  return std::ranges::find(place_units, id, &PlaceUnits::id)->units;
}

// CAN-IDs beside those of 8.1.4.3: by the pre-defined connection set. The stop request has one in
// the data sheets of who sends and receives it.
constexpr std::uint32_t motion_id = 0x180 + vehicle_gateway_id;
constexpr std::uint32_t mileage_id = 0x280 + vehicle_gateway_id;
constexpr std::uint32_t position_id = 0x180 + positioning_id;
constexpr std::uint32_t movement_id = 0x280 + positioning_id;
constexpr std::uint32_t universal_time_id = 0x380 + positioning_id;
constexpr std::uint32_t first_count_id = 0x280 + first_counter_id;
constexpr std::uint32_t second_count_id = 0x280 + second_counter_id;
constexpr std::uint32_t aboard_id = 0x280 + counting_manager_id;
constexpr std::uint16_t train_stop_request_id = 0x180 + train_gateway_id;

constexpr std::uint16_t heartbeat_consumer = 0x1016;
constexpr std::uint16_t heartbeat_producer = 0x1017;
constexpr std::uint32_t short_heartbeat_ms = 500;
constexpr double pulses_a_metre = 8;
constexpr double ambient = 11.5;
constexpr double hdop = 1.1;
constexpr std::string_view driver_card = "D  1234567890123456";
constexpr std::uint8_t false_zone = 99;
constexpr std::size_t few_octets = 40;

}  // namespace

std::string device_name_of(NodeId id) {
  return canvoy::device_name<BusUnit>(units_at(id), application);
}

void BusNetwork::add(NodeId id) {
  const auto place = std::ranges::find(device_places, id, &DevicePlace::id);
  nodes_.push_back(std::make_unique<BusNode>(
      world_, bus_of(id), units_at(id),
      BusNode::Place{
          .name = place->name, .id = id, .serial_number = 4000U + id, .is_played = is_played(id)},
      sites_.back()));
  by_id_.at(id) = nodes_.back().get();
  watch_of(id).name(nodes_.back()->controller(), id);
}

/// In the order of their node-IDs.
void BusNetwork::add_nodes() {
  add_computer();
  add_displays();
  add_tickets();
  add_vehicle_devices();
  add_counters();
  add_second_car();
  std::ranges::sort(nodes_, {}, [](const auto& node) { return node->place().id; });
  configure();
}

void BusNetwork::add_computer() {
  Site& site = add_site();
  site.offer(Callback<MainOnBoardComputerHardware()>::to<&BusNetwork::computer_hardware>(*this));
  site.offer(Callback<MainOnBoardComputerSettings()>::to<&BusNetwork::computer_settings>(*this));
  site.watch(Callback<void(MainOnBoardComputerUnit&, Node&)>::to<&BusNetwork::is_computer>(*this));
  site.offer(Callback<LineControlHardware()>::to<&BusNetwork::line_control_hardware>(*this));
  site.offer(Callback<LineControlSettings()>::to<&BusNetwork::line_control_settings>(*this));
  site.watch(Callback<void(LineControl&, Node&)>::to<&BusNetwork::is_line_control>(*this));
  add(computer_id);
  Site& driver = add_site();
  driver.offer(Callback<IdentificationHardware()>::to<&BusNetwork::identification_hardware>(*this));
  driver.watch(
      Callback<void(IdentificationUnit&, Node&)>::to<&BusNetwork::is_identification>(*this));
  add(identification_id);
}

void BusNetwork::add_display(NodeId id, const ShownDisplay::Sabotage& sabotage) {
  displays_.at(id) = std::make_unique<ShownDisplay>(
      Callback<Time()>::to<&BusNetwork::clock>(*this),
      Callback<void()>::to<&BusNetwork::displays_changed>(*this), sabotage);
  add_site().offer(Callback<DisplayHardware()>::to<&ShownDisplay::hardware>(*displays_.at(id)));
  add(id);
}

void BusNetwork::add_displays() {
  const Sabotage& sabotage = options_.sabotage;
  add_display(front_display_id, {.is_cut = sabotage.cuts_destination});
  add_display(side_display_id, {.is_frozen = sabotage.freezes_destination});
  add_display(next_stop_id, {.is_cut = sabotage.cuts_next_stop,
                             .has_no_sign = sabotage.no_sign_lamp,
                             .has_stuck_sign = sabotage.stuck_sign});
  ShownDisplay::Sabotage memory{.is_cut = sabotage.cuts_information};
  if (sabotage.short_memory) memory.octets_max = few_octets;
  add_display(information_id, memory);
}

void BusNetwork::add_tickets() {
  Site& canceller = add_site();
  canceller.offer(Callback<TicketCancellerHardware()>::to<&BusNetwork::canceller_hardware>(*this));
  canceller.watch(
      Callback<void(TicketCancellerUnit&, Node&)>::to<&BusNetwork::is_canceller>(*this));
  add(canceller_id);
  Site& printer = add_site();
  printer.offer(Callback<TicketPrinterHardware()>::to<&BusNetwork::printer_hardware>(*this));
  printer.watch(Callback<void(TicketPrinterUnit&, Node&)>::to<&BusNetwork::is_printer>(*this));
  add(printer_id);
  add_site().offer(
      Callback<AcousticAnnouncerHardware()>::to<&BusNetwork::announcer_hardware>(*this));
  add(announcer_id);
}

void BusNetwork::add_vehicle_devices() {
  add_site().offer(Callback<VehicleGatewayHardware()>::to<&BusNetwork::gateway_hardware>(*this));
  add(vehicle_gateway_id);
  add_site().offer(Callback<TachographHardware()>::to<&BusNetwork::tachograph_hardware>(*this));
  add(tachograph_id);
  add_site();
  add(driver_display_id);
  Site& satellites = add_site();
  satellites.offer(Callback<PositioningHardware()>::to<&BusNetwork::positioning_hardware>(*this));
  satellites.offer(Callback<TimeFixingHardware()>::to<&BusNetwork::time_hardware>(*this));
  add(positioning_id);
}

void BusNetwork::add_counters() {
  Site& first = add_site();
  first.offer(Callback<PassengerCounterSettings()>::to<&BusNetwork::first_counter>(*this));
  first.watch(
      Callback<void(PassengerCounterUnit&, Node&)>::to<&BusNetwork::is_first_counter>(*this));
  add(first_counter_id);
  Site& manager = add_site();
  manager.watch(
      Callback<void(CountingManagerUnit&, Node&)>::to<&BusNetwork::is_counting_manager>(*this));
  add(counting_manager_id);
  Site& second = add_site();
  second.offer(Callback<PassengerCounterSettings()>::to<&BusNetwork::second_counter>(*this));
  second.watch(
      Callback<void(PassengerCounterUnit&, Node&)>::to<&BusNetwork::is_second_counter>(*this));
  add(second_counter_id);
}

/// A gateway in each car, and displays and loudspeakers in a segment of their own.
void BusNetwork::add_second_car() {
  Site& first = add_site();
  first.offer(Callback<TrainBusGatewayHardware()>::to<&TrainLink::first_hardware>(train_));
  first.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainLink::is_first>(train_));
  add(train_gateway_id);
  Site& second = add_site();
  second.offer(Callback<BusSegment()>::to<&BusNetwork::second_segment>(*this));
  second.offer(Callback<TrainBusGatewayHardware()>::to<&TrainLink::second_hardware>(train_));
  second.offer(Callback<MirrorControlHardware()>::to<&BusNetwork::mirror_hardware>(*this));
  second.offer(Callback<MirrorControlSettings()>::to<&BusNetwork::mirror_settings>(*this));
  second.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainLink::is_second>(train_));
  add(second_gateway_id);
  train_.join(node(train_gateway_id), node(second_gateway_id));
  add_display(second_destination_id, {});
  add_display(second_next_stop_id, {.is_cut = options_.sabotage.cuts_second_car,
                                    .is_frozen = options_.sabotage.freezes_second_car,
                                    .has_no_sign = options_.sabotage.no_second_sign_lamp});
  add_site().offer(
      Callback<AcousticAnnouncerHardware()>::to<&BusNetwork::second_announcer_hardware>(*this));
  add(second_announcer_id);
}

MirrorControlHardware BusNetwork::mirror_hardware() {
  return {.is_coupled = Callback<bool()>::to<&TrainLink::is_coupled>(train_)};
}

MirrorControlSettings BusNetwork::mirror_settings() {
  return {.nodes = {second_destination_id, second_next_stop_id, second_announcer_id},
          .displays = {{second_destination_id, DisplayUse::destination},
                       {second_next_stop_id, DisplayUse::next_stop}}};
}

// 8.1.5: configured before they are mounted.

void BusNetwork::link(NodeId sender, std::span<const std::uint32_t> sent, std::uint32_t can_id,
                      std::span<const std::uint32_t> received,
                      std::initializer_list<NodeId> receivers) {
  node(sender).preset_tpdo(sent, can_id);
  for (const NodeId receiver : receivers) node(receiver).preset_rpdo(received, can_id);
}

void BusNetwork::configure() {
  link(vehicle_gateway_id, motion_mapping, motion_id, motion_mapping, {computer_id});
  link(vehicle_gateway_id, motion_mapping, motion_id, doors_only_mapping,
       {driver_display_id, first_counter_id, counting_manager_id, second_counter_id});
  link(vehicle_gateway_id, mileage_mapping, mileage_id, mileage_mapping, {computer_id});
  link(positioning_id, position_mapping, position_id, position_mapping, {computer_id});
  link(positioning_id, movement_mapping, movement_id, movement_mapping, {computer_id});
  link(positioning_id, universal_time_mapping, universal_time_id, universal_time_mapping,
       {computer_id});
  link(counting_manager_id, aboard_mapping, aboard_id, aboard_mapping, {computer_id});
  node(first_counter_id).preset_tpdo(door_count_mapping, first_count_id);
  node(second_counter_id).preset_tpdo(door_count_mapping, second_count_id);
  node(counting_manager_id).preset_rpdo(door_count_mapping, first_count_id, 0);
  node(counting_manager_id).preset_rpdo(door_count_mapping, second_count_id, 1);
  for (const auto& node : nodes_) {
    const NodeId id = node->place().id;
    if (id == computer_id || id == identification_id || id == second_gateway_id) {
      node->preset({heartbeat_producer, 0, short_heartbeat_ms});
    }
    if (id == computer_id || id == second_gateway_id) continue;
    const NodeId master = bus_of(id) == bus_ ? computer_id : second_gateway_id;
    const auto time =
        std::chrono::duration_cast<std::chrono::milliseconds>(heartbeat_time_out(master));
    node->preset({heartbeat_consumer, 1,
                  std::uint32_t{master} << 16 | static_cast<std::uint32_t>(time.count())});
  }
}

void BusNetwork::power(BusNode& node, bool is_on) {
  const NodeId id = node.place().id;
  if (!is_on && displays_.at(id)) displays_.at(id)->power_off();
  node.power(is_on);
}

// What each finds.

LineControlHardware BusNetwork::line_control_hardware() {
  return {.computer = computer_,
          .odometer = Callback<double()>::to<&BusNetwork::pulses_as_metres>(*this),
          .has_open_door = Callback<bool()>::to<&BusNetwork::has_open_door>(*this),
          .clock = Callback<std::optional<cia407::CivilTime>()>::to<&BusNetwork::own_clock>(*this)};
}

LineControlSettings BusNetwork::line_control_settings() {
  LineControlSettings settings{.line = &options_.line,
                               .displays = {{front_display_id, DisplayUse::destination},
                                            {side_display_id, DisplayUse::destination},
                                            {next_stop_id, DisplayUse::next_stop},
                                            {information_id, DisplayUse::information},
                                            {train_gateway_id, DisplayUse::train}},
                               .identification = identification_id,
                               .identification_time_out = heartbeat_time_out(identification_id),
                               .positioning = positioning_id,
                               .doors = vehicle_gateway_id,
                               .train_stop_request_id = train_stop_request_id};
  for (const DevicePlace& place : device_places) {
    if (place.id != computer_id && place.car == 1) settings.nodes.push_back(place.id);
  }
  return settings;
}

double BusNetwork::pulses_as_metres() {
  return std::floor(vehicle_->odometer() * pulses_a_metre) / pulses_a_metre;
}

bool BusNetwork::has_open_door() {
  return !all_doors_closed();
}

/// A clock of the on-board computer, which knows no satellites.
std::optional<cia407::CivilTime> BusNetwork::own_clock() {
  constexpr std::int64_t slow = 600;
  const std::int64_t wrong = (is_present(FaultKind::wrong_clock) ? cia447::seconds_an_hour : 0) -
                             (options_.sabotage.slow_clocks ? slow : 0);
  return cia447::civil_time(cia447::seconds_since_1970(true_time()) + wrong);
}

std::optional<cia407::CivilTime> BusNetwork::computer_clock() {
  return line_control_ == nullptr ? std::nullopt : line_control_->local_time();
}

MainOnBoardComputerHardware BusNetwork::computer_hardware() {
  line_control_ = nullptr;  // of the device that is made now there is none yet
  return {.clock =
              Callback<std::optional<cia407::CivilTime>()>::to<&BusNetwork::computer_clock>(*this)};
}

MainOnBoardComputerSettings BusNetwork::computer_settings() {
  return {.vehicle_id = 407, .body_id = 12, .garage_id = 1, .vehicle_id_text = "C-AN 407"};
}

IdentificationHardware BusNetwork::identification_hardware() {
  return {.remembered = Callback<Assignment()>::to<&BusNetwork::remembered>(*this)};
}

TicketCancellerHardware BusNetwork::canceller_hardware() {
  return {.stamp = Callback<void(const TicketData&)>::to<&BusNetwork::stamp>(*this)};
}

void BusNetwork::stamp(const TicketData& ticket) {
  TicketData stamped = ticket;
  if (options_.sabotage.stuck_zone_wheel) stamped.fare_zone = false_zone;
  count_ticket(stamped, false);
}

TicketPrinterHardware BusNetwork::printer_hardware() {
  return {.print = Callback<bool(const TicketData&)>::to<&BusNetwork::print>(*this),
          .has_paper = Callback<bool()>::to<&BusNetwork::has_paper>(*this)};
}

bool BusNetwork::print(const TicketData& ticket) {
  if (has_paper()) count_ticket(ticket, true);
  return has_paper();
}

AcousticAnnouncerHardware BusNetwork::announcer_hardware() {
  return {.announce =
              Callback<bool(std::uint32_t, std::string_view)>::to<&BusNetwork::announce>(*this)};
}

AcousticAnnouncerHardware BusNetwork::second_announcer_hardware() {
  return {
      .announce =
          Callback<bool(std::uint32_t, std::string_view)>::to<&BusNetwork::announce_in_second_car>(
              *this)};
}

bool BusNetwork::announce(std::uint32_t stop_point, std::string_view) {
  return announce_in(1, stop_point, options_.sabotage.mute_announcer);
}

bool BusNetwork::announce_in_second_car(std::uint32_t stop_point, std::string_view) {
  return announce_in(2, stop_point, options_.sabotage.mute_second_announcer);
}

bool BusNetwork::announce_in(unsigned car, std::uint32_t stop_point, bool is_mute) {
  const auto stop = std::ranges::find(options_.line.stops, stop_point, &BusStop::number);
  const bool is_known = stop != options_.line.stops.end();
  if (is_mute) return is_known;
  note(now(), Announced{stop_point, is_known ? stop->name : "", car});
  if (car == 1) ++counted_.announced;
  const bool is_right =
      truth_.is_true(now(), [&](const TrueData& data) { return data.stop_point == stop_point; });
  if (!is_right) referee_.count(announcements_in(car), now());
  std::optional<std::uint32_t>& expected = to_announce_.at(car - 1);
  if (expected == stop_point) expected.reset();
  return is_known;
}

VehicleGatewayHardware BusNetwork::gateway_hardware() {
  return {.read = Callback<VehicleReading()>::to<&BusNetwork::read_vehicle>(*this)};
}

VehicleReading BusNetwork::read_vehicle() {
  VehicleReading reading;
  reading.speed_kmh = vehicle_->speed() * kmh_of_metres_per_second;
  reading.mileage_metres = vehicle_->odometer();
  reading.bearing_degrees = vehicle_->heading();
  reading.ambient_celsius = ambient;
  reading.direction = Direction::forward;
  for (std::size_t i = 0; i < vehicle_->door_count() && i < VehicleReading::doors_max; ++i) {
    reading.doors[i] = {.is_valid = true, .is_open = !vehicle_->door(i).is_closed()};
  }
  return reading;
}

TachographHardware BusNetwork::tachograph_hardware() {
  return {.read = Callback<TachographReading()>::to<&BusNetwork::read_tachograph>(*this)};
}

TachographReading BusNetwork::read_tachograph() {
  return {.speed_kmh = vehicle_->speed() * kmh_of_metres_per_second,
          .direction = Direction::forward,
          .distance_metres = vehicle_->odometer(),
          .utc = satellite_time(),
          .cards = {driver_card, ""}};
}

PositioningHardware BusNetwork::positioning_hardware() {
  return {.read = Callback<cia447::GpsReading()>::to<&BusNetwork::read_position>(*this)};
}

cia447::GpsReading BusNetwork::read_position() {
  if (is_present(FaultKind::no_satellites)) return {.fix = cia447::GpsFix::none};
  const GeoPoint place = vehicle_->position();
  return {.fix = cia447::GpsFix::fix_3d,
          .latitude = place.latitude,
          .longitude = place.longitude,
          .velocity = vehicle_->speed(),
          .heading = vehicle_->heading(),
          .hdop = hdop};
}

TimeFixingHardware BusNetwork::time_hardware() {
  return {
      .utc = Callback<std::optional<cia407::CivilTime>()>::to<&BusNetwork::satellite_time>(*this),
      .local_offset = Callback<std::chrono::minutes()>::to<&BusNetwork::local_offset>(*this)};
}

std::chrono::minutes BusNetwork::local_offset() {
  const std::chrono::seconds offset(options_.clock.offset_at(true_utc()));
  return std::chrono::duration_cast<std::chrono::minutes>(offset);
}

std::optional<cia407::CivilTime> BusNetwork::satellite_time() {
  if (is_present(FaultKind::no_satellites)) return std::nullopt;
  constexpr std::int64_t slow = 600;
  return cia447::civil_time(true_utc() - (options_.sabotage.slow_clocks ? slow : 0));
}

/// Sensors at the doors.
void BusNetwork::passed(Time, std::size_t door, bool is_in) {
  if (door >= counters_.size() || (door == 0 && options_.sabotage.blind_counter)) return;
  node(door == 0 ? first_counter_id : second_counter_id).with([&] {
    is_in ? counters_.at(door)->count_in() : counters_.at(door)->count_out();
  });
}

}  // namespace canvoy::bus
