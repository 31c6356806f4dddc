#include "canvoy/sim/taxi/taxi_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::taxi {

namespace {

constexpr double cents = 10;            ///< in 0,001 of the currency unit
constexpr std::size_t paper_lines = 4;  ///< that hang out of the printer

std::int64_t local_seconds(CivilTime time) {
  return std::chrono::floor<std::chrono::seconds>(time.time_since_epoch()).count();
}

ShiftOptions shift_options(const TaxiOptions& options) {
  ShiftOptions made = options.shift;
  // The hands at a real meter take the time that they take.
  const bool has_hands = std::ranges::find(options.real, taximeter_id) != options.real.end();
  if (has_hands) made.presses_max = UINT32_MAX;
  constexpr Duration evening = 1h;  // for the way home, sleep and waking
  made.end = Time{} + std::max<Duration>(options.length - evening, options.length / 2);
  return made;
}

}  // namespace

TaxiNetwork::TaxiNetwork(TaxiOptions options)
    : options_(std::move(options)),
      bus_(world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed})),
      drive_(options_.record.get()),
      shift_(shift_options(options_), options_.faults.seed, drive_, keys()),
      bus_watch_(bus_, [this](Time now, const BusEvent& event) { heard(now, event); }),
      fares_(options_.tariff_of_town, local_seconds(options_.begin)) {
  add_nodes();
  hear_real_devices();
  world_.bus(bus_).observe(
      {.context = this,
       .on_frame = [](void* self, Time, ControllerId,
                      const Frame&) { static_cast<TaxiNetwork*>(self)->frame_sent(); },
       .on_state = nullptr});
  world_.bus(bus_).observe(bus_watch_.tap());
  shift_.on_change([this](Time now, Activity from, Activity to) { shift_changed(now, from, to); });
  world_.add_plant(Callback<void(Time)>::to<&TaxiNetwork::step>(*this), Shift::step_time);
  plan_faults();
  world_.at(Time{} + std::min(options_.alarm, options_.length / 3),
            [this](Time now) { press_alarm(now); });
  for (const auto& node : nodes_) power(*node, true);
}

TaxiNetwork::~TaxiNetwork() = default;

void TaxiNetwork::add(std::span<const cia447::CarUnit* const> units, const Site& site) {
  const auto id = static_cast<NodeId>(nodes_.size() + 1);
  const car::CarNode::Place place = {
      .name = device_names.at(nodes_.size()),
      .id = id,
      .serial_number = 1000U + id,
      // Whom a real gateway calls how, nobody knows.
      .is_named_by_lss = id != cia447::gateway_node_id && !is_real(cia447::gateway_node_id),
      .is_played = !is_real(id)};
  nodes_.push_back(std::make_unique<car::CarNode>(world_, bus_, units, place, site));
}

/// What all devices of a car are told.
Site& TaxiNetwork::add_site() {
  Site& site = sites_.emplace_back();
  site.offer(Callback<cia447::CarNetworkSettings()>::to<&TaxiNetwork::network_settings>(*this));
  site.offer(Callback<cia447::CarMasterSettings()>::to<&TaxiNetwork::master_settings>(*this));
  site.offer(Callback<cia447::CarSleepSettings()>::to<&TaxiNetwork::sleep_settings>(*this));
  return site;
}

/// The gateway knows its devices from before: so they have the same node-IDs in each run.
void TaxiNetwork::add_nodes() {
  Site& car = add_site();
  car.offer(Callback<cia447::CarHardware()>::to<&TaxiNetwork::car_hardware>(*this));
  car.offer(Callback<cia447::CarSettings()>::to<&TaxiNetwork::car_settings>(*this));
  car.offer(Callback<cia447::CarMemory()>::to<&TaxiNetwork::memory>(*this));
  car.watch(Callback<void(cia447::IvnGatewayUnit&, Node&)>::to<&TaxiNetwork::is_gateway>(*this));
  car.watch(
      Callback<void(cia447::CarNetwork&, Node&)>::to<&TaxiNetwork::is_network_of_reader>(*this));
  add(car::units_of<cia447::IvnGatewayKind>, car);
  Site& meter = add_site();
  meter.offer(Callback<cia447::TaximeterHardware()>::to<&TaxiNetwork::meter_hardware>(*this));
  meter.offer(Callback<cia447::TaximeterSettings()>::to<&TaxiNetwork::meter_settings>(*this));
  meter.watch(Callback<void(cia447::TaximeterUnit&, Node&)>::to<&TaxiNetwork::is_meter>(*this));
  meter.offer(Callback<FareDisplaySettings()>::to<&TaxiNetwork::fare_display_settings>(*this));
  meter.watch(Callback<void(FareDisplay&, Node&)>::to<&TaxiNetwork::is_fare_display>(*this));
  add(car::units_of<cia447::TaximeterKind, FareDisplayKind>, meter);
  meter.watch(
      Callback<void(cia447::CarNetwork&, Node&)>::to<&TaxiNetwork::is_network_of_meter>(*this));
  Site& others = add_site();
  others.offer(Callback<cia447::PrinterHardware()>::to<&TaxiNetwork::printer_hardware>(*this));
  others.offer(
      Callback<cia447::DriverIdentificationHardware()>::to<&TaxiNetwork::reader_hardware>(*this));
  others.offer(Callback<cia447::RealTimeClockHardware()>::to<&TaxiNetwork::clock_hardware>(*this));
  others.watch(Callback<void(cia447::PrinterUnit&, Node&)>::to<&TaxiNetwork::is_printer>(*this));
  others.watch(
      Callback<void(cia447::DriverIdentificationUnit&, Node&)>::to<&TaxiNetwork::is_driver_reader>(
          *this));
  others.offer(Callback<cia447::TariffDisplayHardware()>::to<&TaxiNetwork::sign_hardware>(*this));
  others.watch(Callback<void(cia447::TaxiAlarmUnit&, Node&)>::to<&TaxiNetwork::is_alarm>(*this));
  others.offer(Callback<cia447::TerminalHardware()>::to<&TaxiNetwork::terminal_hardware>(*this));
  others.offer(Callback<cia447::TerminalSettings()>::to<&TaxiNetwork::terminal_settings>(*this));
  others.offer(Callback<RouteDisplaySettings()>::to<&TaxiNetwork::route_display_settings>(*this));
  others.watch(Callback<void(RouteDisplay&, Node&)>::to<&TaxiNetwork::is_route_display>(*this));
  add(car::units_of<cia447::PrinterKind>, others);
  add(car::units_of<cia447::DriverIdentificationKind, cia447::RealTimeClockKind, RouteDisplayKind>,
      others);
  add(car::units_of<cia447::TariffDisplayKind>, others);
  add(car::units_of<cia447::TerminalKind>, others);
  Site& navigation = add_site();
  navigation.offer(Callback<cia447::GpsHardware()>::to<&TaxiNetwork::gps_hardware>(*this));
  navigation.offer(
      Callback<cia447::NavigationHardware()>::to<&TaxiNetwork::navigation_hardware>(*this));
  navigation.watch(
      Callback<void(cia447::NavigationUnit&, Node&)>::to<&TaxiNetwork::is_navigation>(*this));
  add(car::units_of<cia447::GpsKind, cia447::NavigationKind>, navigation);
  navigation.watch(
      Callback<void(cia447::CarNetwork&, Node&)>::to<&TaxiNetwork::is_network_of_navigation>(
          *this));
  add(car::units_of<cia447::TaxiAlarmKind>, others);
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    known_.addresses.at(i - 1) = nodes_[i]->address();
    known_.is_known.at(i - 1) = true;
  }
  for (const auto& node : nodes_) bus_watch_.name(node->controller(), node->place().id);
}

cia447::CarMemory TaxiNetwork::memory() {
  return {.load = Callback<cia447::KnownDevices()>::to<&TaxiNetwork::known>(*this),
          .store = Callback<void(const cia447::KnownDevices&)>::to<&TaxiNetwork::keep>(*this)};
}

void TaxiNetwork::power(car::CarNode& node, bool is_on) {
  const bool is_meter = node.place().id == taximeter_id;
  // Its supply sinks slowly enough for that.
  if (!is_on && is_meter && node.is_powered()) meter_->power_fails();
  if (is_meter) outputs_.reset();
  if (is_meter) fare_display_ = nullptr;
  if (node.place().id == driver_id) route_display_ = nullptr;
  if (node.place().id == trip_reader_id()) {
    trip_reader_.reset();
    totals_reader_.reset();
  }
  if (!is_on) darken(node.place().id);
  node.power(is_on);
  // A unit that comes back has forgotten it; the driver types it anew.
  if (node.place().id == driver_id && route_display_ != nullptr && destination_) {
    route_display_->guide(*destination_);
  }
  if (cia447::CarMaster* master = node.device().master()) {
    master->on_event(Callback<void(const cia447::CarEvent&)>::to<&TaxiNetwork::car_event>(*this));
  }
}

/// Lamps and displays of a device without power.
void TaxiNetwork::darken(NodeId id) {
  if (id == sign_id) {
    lamps_.fill(cia447::Lamp::off);
    vacant_light_ = false;
  }
  if (id == terminal_id) screens_ = {};
}

cia447::CarHardware TaxiNetwork::car_hardware() {
  cia447::CarHardware car = cia447::parked_car();
  car.speed = cia447::Sensor::to<&TaxiNetwork::speed>(*this);
  car.distance = cia447::Sensor::to<&TaxiNetwork::distance>(*this);
  return car;
}

/// What the wheels tell; what they have turned meanwhile is not lost to it.
std::optional<double> TaxiNetwork::distance() {
  if (wheel_is_lost_) return std::nullopt;
  return drive_.metres();
}

cia447::TaximeterHardware TaxiNetwork::meter_hardware() {
  return {
      .clock = Callback<std::optional<cia447::LocalTime>()>::to<&TaxiNetwork::meter_clock>(*this),
      .seal_is_open = Callback<bool()>([](void*) { return false; }, nullptr),
      .show = Callback<void(const cia447::TaximeterDisplay&)>::to<&TaxiNetwork::show>(*this),
      .turned_off = {},
      .flash = &meter_flash_.flash()};
}

cia447::TaximeterSettings TaxiNetwork::meter_settings() {
  cia447::TaximeterSettings settings = options_.meter;
  settings.clock_node = driver_id;
  return settings;
}

cia447::LocalTime TaxiNetwork::local_time(Duration ahead) const {
  const auto passed = std::chrono::floor<std::chrono::seconds>(now() - Time{} + ahead);
  return {.seconds = local_seconds(options_.begin) + passed.count()};
}

/// Its chip has a battery.
cia447::RealTimeClockHardware TaxiNetwork::clock_hardware() {
  return {.read = Callback<std::optional<cia447::ChipTime>()>::to<&TaxiNetwork::chip_time>(*this),
          .write = {}};
}
std::optional<cia447::ChipTime> TaxiNetwork::chip_time() {
  return cia447::ChipTime{.since_1970 = std::chrono::seconds(local_seconds(options_.begin)) +
                                        (now() - Time{}) + options_.clock_ahead};
}

/// What the meter has others do.
void TaxiNetwork::is_network_of_meter(cia447::CarNetwork& network, Node& /*node*/) {
  outputs_.emplace(network, cia447::MeterOutputs::Settings{.printer = printer_id, .sign = sign_id});
}

cia447::DriverIdentificationHardware TaxiNetwork::reader_hardware() {
  return {
      .clock = Callback<std::optional<cia447::LocalTime>()>::to<&TaxiNetwork::reader_clock>(*this),
      .knows = {}};
}

cia447::TariffDisplayHardware TaxiNetwork::sign_hardware() {
  return {.drive = Callback<void(unsigned, cia447::Lamp)>::to<&TaxiNetwork::drive_lamp>(*this)};
}
void TaxiNetwork::drive_lamp(unsigned lamp, cia447::Lamp wanted) {
  constexpr unsigned vacant = 2;  // 4.2.16.4
  if (sabotage_.cuts_sign) return;
  if (lamp >= 1 && lamp <= lamps_.size()) lamps_[lamp - 1] = wanted;
  if (lamp == vacant) vacant_light_ = wanted == cia447::Lamp::on;
}

cia447::GpsHardware TaxiNetwork::gps_hardware() {
  return {.read = Callback<cia447::GpsReading()>::to<&TaxiNetwork::gps_reading>(*this)};
}

/// The driver has the meter in his hands: a key of one without power does nothing.
MeterKeys TaxiNetwork::keys() {
  if (is_real(taximeter_id)) return real_keys();
  const auto press = [this](auto key) {
    return [this, key](auto... with) {
      car::CarNode& meter = node(taximeter_id);
      if (!meter.is_powered() || sabotage_.blocks_keys) return false;
      return (meter_->*key)(with...);
    };
  };
  return {.sign_on = press(&cia447::TaximeterUnit::sign_on),
          .hire = press(&cia447::TaximeterUnit::hire),
          .stop = press(&cia447::TaximeterUnit::stop),
          .add_supplement = press(&cia447::TaximeterUnit::add_supplement),
          .for_hire = press(&cia447::TaximeterUnit::for_hire),
          .sign_off = press(&cia447::TaximeterUnit::sign_off)};
}

TaxiSnapshot TaxiNetwork::snapshot() {
  const SimulatedBus& bus = world_.bus(bus_);
  TaxiSnapshot look{.at = now(),
                    .bus = {bus.load(nodes_.front()->controller()), bus.statistics().frames,
                            bus.statistics().error_frames},
                    .nodes = {},
                    .names = {},
                    .meter = display_.state,
                    .trip = display_.trip,
                    .driver = shift_.activity(),
                    .is_asleep = all_sleep(),
                    .carried = shift_.carried(),
                    .paid = paid_ / money_unit,
                    .lamps = lamps_,
                    .screens = screens_,
                    .paper = paper_.last_lines(paper_lines),
                    .metres = drive_.metres(),
                    .speed = drive_.speed()};
  for (const auto& node : nodes_) {
    look.nodes.push_back(
        snapshot_of(world_, *node, bus_watch_, options_.car_network.nodes.time_out));
    look.names.push_back(node->place().name);
  }
  return look;
}

std::vector<Invariant> TaxiNetwork::invariants() const {
  double fare = 0;
  double distance = 0;
  double duration = 0;
  for (const Trip& trip : trips_) {
    if (trip.is_disturbed) continue;
    fare = std::max(fare, trip.fare_excess() / cents);
    distance = std::max(distance, trip.distance_excess());
    duration = std::max(duration, trip.time_excess());
  }
  const auto none = [](InvariantKind kind, double worst) {
    return Invariant{.kind = kind, .worst = worst, .allowed = 0, .held = worst <= 0};
  };
  const auto in_time = [](InvariantKind kind, Duration worst, Duration allowed) {
    return Invariant{.kind = kind,
                     .worst = std::chrono::duration<double>(worst).count(),
                     .allowed = std::chrono::duration<double>(allowed).count(),
                     .held = worst <= allowed};
  };
  // Whose hands a real meter and a real car are in, nobody knows here.
  const bool is_led = is_real(taximeter_id) || is_real(cia447::gateway_node_id);
  const bool was_long_enough = !is_led && now() - Time{} >= long_enough;
  std::vector<Invariant> all = {
      none(InvariantKind::fare, fare),
      none(InvariantKind::distance, distance),
      none(InvariantKind::duration, duration),
      none(InvariantKind::totals, totals_error_ / cents),
      none(InvariantKind::receipts, receipts_error_ / cents),
      in_time(InvariantKind::roof_sign, sign_was_wrong_, sign_bound),
      in_time(InvariantKind::terminal_fare, screen_was_wrong_[0], screen_bound),
      in_time(InvariantKind::terminal_place, screen_was_wrong_[1], screen_bound),
      none(InvariantKind::silence, static_cast<double>(frames_asleep_)),
      in_time(InvariantKind::no_service, waited_, wait_bound),
      {.kind = InvariantKind::carried,
       .worst = was_long_enough && shift_.carried() == 0 ? 1.0 : 0.0,
       .held = !was_long_enough || shift_.carried() != 0 || is_excused_all_along(),
       .decided = was_long_enough},
      in_time(InvariantKind::device_missing, missing_, return_bound)};
  for (Invariant& each : all) each.decided = each.decided && can_be_judged(each.kind);
  return all;
}

bool TaxiNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

}  // namespace canvoy::taxi
