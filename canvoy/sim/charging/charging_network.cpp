#include "canvoy/sim/charging/charging_network.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/sim/charging/imposter.hpp"

namespace canvoy::charging {

namespace {

/// Enough for a frame to wait for others and be sent again a few times.
constexpr Duration frame_time_max = 50ms;

constexpr double percent = 100;
/// Energy and ampere-hours must agree to this share.
constexpr double count_bound_percent = 1;
/// What went in is taken as so much at least, lest the first seconds decide.
constexpr double ampere_hours_floor = 1;
constexpr double watt_hours_floor = 50;

double error_percent(double counted, double truth, double floor) {
  return std::abs(counted - truth) / std::max(truth, floor) * percent;
}

Invariant count_invariant(InvariantKind kind, double value) {
  return {.kind = kind,
          .worst = value,
          .allowed = count_bound_percent,
          .held = value <= count_bound_percent};
}

std::array<std::uint32_t, 3> can_ids(const Dictionary& dictionary, std::uint16_t parameters) {
  std::array<std::uint32_t, 3> ids{};
  for (std::uint32_t& id : ids) {
    const auto raw = static_cast<std::uint32_t>(dictionary.number(parameters++, pdo_sub::cob_id));
    id = CobId{raw}.can_id();
  }
  return ids;
}

}  // namespace

ChargingOptions ChargingNetwork::with_meter_of_seed(ChargingOptions options) {
  Random random(options.faults.seed);
  const double share = static_cast<double>(random.below(2001)) / 1000 - 1;  // from -1 to 1
  options.stage.meter_gain *= 1 + share * options.meter_tolerance;
  return options;
}

cia418::BatterySettings ChargingNetwork::battery_settings() const {
  return {.capacity_ampere_hours = options_.battery.capacity_ampere_hour,
          .current_max_ampere = options_.battery.charge_current_ampere,
          .cells = static_cast<std::uint16_t>(options_.battery.cells)};
}

ChargingNetwork::ChargingNetwork() : ChargingNetwork(ChargingOptions()) {}

ChargingNetwork::ChargingNetwork(const ChargingOptions& options)
    : options_(with_meter_of_seed(options)),
      bus_(world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed})),
      charger_slot_(world_.add_slot(bus_)),
      battery_slot_(world_.add_slot(bus_)),
      battery_port_(world_.port(battery_slot_)),
      plant_(options_.battery, options_.state_of_charge, options_.ambience_celsius, options_.stage),
      charger_(world_.port(charger_slot_), options_.charger_id, charger_hardware(),
               options_.charger),
      battery_(battery_port_.port(), options_.battery_id, plant_.battery.hardware(),
               battery_settings()),
      handshake_(rules()),
      fault_watch_(options_.faults, promises()),
      bus_watch_(bus_, [this](Time now, const BusEvent& event) { heard(now, event); }) {
  world_.bus().observe({.context = this,
                        .on_frame =
                            [](void* self, Time now, ControllerId, const Frame& frame) {
                              static_cast<ChargingNetwork*>(self)->hear(now, frame);
                            },
                        .on_state = nullptr});
  bus_watch_.name(charger_controller(), options_.charger_id);
  bus_watch_.name(battery_controller(), options_.battery_id);
  world_.bus().observe(bus_watch_.tap());
  charger_.charger().on_event(
      Callback<void(cia419::Charger::Event)>::to<&ChargingNetwork::charger_said>(*this));
  world_.add_plant(Callback<void(Time)>::to<&ChargingNetwork::step>(*this),
                   ChargingPlant::step_time);
  world_.occupy(charger_slot_, charger_.node());
  world_.occupy(battery_slot_, battery_.node());
  plan_faults();
  add_manager();
  if (options_.plays_battery) world_.start(battery_slot_);
  if (options_.plays_charger) world_.start(charger_slot_);
}

cia419::ChargerHardware ChargingNetwork::charger_hardware() {
  cia419::ChargerHardware hardware = plant_.stage.hardware();
  power_stage_ = hardware.deliver;
  hardware.deliver = Callback<void(double)>::to<&ChargingNetwork::deliver>(*this);
  if (!options_.begin) return hardware;
  clock_.emplace(world_, *options_.begin);
  hardware.time_of_day = Callback<std::optional<TimeOfDay>()>::to<&WallClock::now>(*clock_);
  return hardware;
}

void ChargingNetwork::deliver(double ampere) {
  handshake_.on_set_point(ampere);
  power_stage_(ampere);
}

/// It is there before the others, as the vehicle is.
void ChargingNetwork::add_manager() {
  if (options_.manager_id == 0) return;
  const SlotIndex slot = world_.add_slot(bus_);
  const auto time_out = options_.charger.battery_heartbeat * options_.charger.heartbeat_periods_max;
  manager_ = std::make_unique<VehicleManager>(world_.port(slot), options_.manager_id, time_out);
  manager_->on_change(Callback<void(Time)>::to<&ChargingNetwork::watch_connections>(*this));
  world_.occupy(slot, manager_->node());
  world_.start(slot);
}

/// What the nodes are configured to, as it stands in their dictionaries at power-on.
HandshakeRules ChargingNetwork::rules() const {
  const Dictionary& dictionary = battery_.node().dictionary();
  const auto heartbeat =
      std::chrono::milliseconds(dictionary.number(object_index::heartbeat_producer, 0));
  const auto event_time = std::chrono::milliseconds(
      dictionary.number(object_index::tpdo_parameter, pdo_sub::event_timer));
  return {.charger = options_.charger_id,
          .battery = options_.battery_id,
          .battery_tpdos = can_ids(dictionary, object_index::tpdo_parameter),
          .charger_tpdos = can_ids(dictionary, object_index::rpdo_parameter),
          .heartbeat_time = heartbeat * options_.charger.heartbeat_periods_max,
          .data_time = event_time * options_.charger.pdo_periods_max};
}

Promises ChargingNetwork::promises() const {
  const HandshakeRules agreed = rules();
  return {.heartbeat_time = agreed.heartbeat_time,
          .data_time = agreed.data_time,
          .value_time = battery_settings().sensing_period +
                        agreed.data_time / options_.charger.pdo_periods_max,
          .reaction_time = options_.charger.control_period + frame_time_max};
}

ChargingSnapshot ChargingNetwork::snapshot() {
  const SimulatedBus& bus = world_.bus(bus_);
  const cia419::Charger& charger = charger_.charger();
  const Values charger_values(charger_.node().dictionary());
  return {.at = now(),
          .bus = {bus.load(charger_controller()), bus.statistics().frames,
                  bus.statistics().error_frames},
          .charger = played_snapshot(world_, bus_, charger_slot_, charger_.node()),
          .battery = played_snapshot(world_, bus_, battery_slot_, battery_.node()),
          .phase = charger.phase(),
          .reason = charger.reason(),
          .charger_is_ready = charger_values[cia419::charger_status].is(Readiness::ready),
          .set_point_ampere = charger.set_point_ampere(),
          .measured_ampere = plant_.stage.measured_ampere(),
          .counted_ampere_hours = charger.ampere_hours_total(),
          .counted_watt_hours = charger.energy_total_watt_hours(),
          .readings = battery_.unit().readings(),
          .ampere = plant_.ampere(),
          .volt = plant_.battery.terminal_volt(),
          .celsius = plant_.battery.celsius(),
          .state_of_charge = plant_.battery.state_of_charge(),
          .ampere_hours = plant_.ampere_hours(),
          .watt_hours = plant_.energy_watt_hour()};
}

Invariant ChargingNetwork::handshake_invariant() const {
  // It may take one period until the charger looks, and as long as the stage needs to fall; the
  // referee sees both in steps of the plant.
  const Duration bound =
      options_.charger.control_period + plant_.stage.fall_time_max() + 2 * ChargingPlant::step_time;
  const Duration value = handshake_.outside_max();
  return {.kind = InvariantKind::current_outside_handshake,
          .worst = std::chrono::duration<double>(value).count(),
          .allowed = std::chrono::duration<double>(bound).count(),
          .held = value <= bound};
}

Invariant ChargingNetwork::service_invariant() const {
  const Duration value = service_.waiting_max();
  return {.kind = InvariantKind::battery_left_waiting,
          .worst = std::chrono::duration<double>(value).count(),
          .allowed = std::chrono::duration<double>(ServiceWatch::bound).count(),
          .held = value <= ServiceWatch::bound};
}

std::array<Invariant, 5> ChargingNetwork::lasting_invariants() const {
  const cia419::Charger& charger = charger_.charger();
  return {count_invariant(InvariantKind::ampere_hours,
                          error_percent(charger.ampere_hours_total(), plant_.ampere_hours(),
                                        ampere_hours_floor)),
          count_invariant(InvariantKind::energy,
                          error_percent(charger.energy_total_watt_hours(),
                                        plant_.energy_watt_hour(), watt_hours_floor)),
          handshake_invariant(),
          {.kind = InvariantKind::current_before_ready,
           .worst = static_cast<double>(handshake_.begun_before_ready()),
           .held = handshake_.begun_before_ready() == 0},
          service_invariant()};
}

std::vector<Invariant> ChargingNetwork::invariants() const {
  const std::array<Invariant, 5> lasting = lasting_invariants();
  const std::vector<Invariant> seen = fault_watch_.invariants();
  std::vector<Invariant> all(lasting.begin(), lasting.end());
  all.insert(all.end(), seen.begin(), seen.end());
  return all;
}

bool ChargingNetwork::all_hold() const {
  const std::vector<Invariant> all = invariants();
  return std::all_of(all.begin(), all.end(),
                     [](const Invariant& invariant) { return invariant.held; });
}

}  // namespace canvoy::charging
