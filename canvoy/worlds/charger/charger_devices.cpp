#include "canvoy/worlds/charger/charger_devices.hpp"

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"

namespace canvoy::charger {

namespace {

/// The default of other SDO managers.
constexpr std::uint32_t first_can_id = 0x680;

}  // namespace

constexpr ServiceHandlers VehicleManager::service_calls = {.reset = method<&VehicleManager::reset>};

VehicleManager::VehicleManager(const Port& port, NodeId id, Duration heartbeat_time_out)
    : device_(port, id),
      nodes_(device_.node(), remote_nodes_),
      manager_(device_.node(), connections_, {}) {
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    nodes_.set_time_out(node, heartbeat_time_out);
  }
  nodes_.on_change(callback<&SdoManager::remote_changed>(manager_));
  device_.node().attach(service_);
}

/// Its connections depend on the vehicle, not on the manager's manufacturer.
void VehicleManager::reset(ResetScope) {
  for (std::uint8_t number = 0; number < detail::vehicle_cob_ids; ++number) {
    std::array<std::uint8_t, 4> value{};
    store(value.data(), first_can_id + number);
    device_.dictionary().write(object_index::sdo_cob_ids, static_cast<std::uint8_t>(number + 1),
                               value, Source::application);
  }
}

namespace {

std::array<std::uint32_t, 3> can_ids(const Dictionary& dictionary, std::uint16_t parameters) {
  std::array<std::uint32_t, 3> ids{};
  for (std::uint32_t& id : ids) {
    const auto raw = static_cast<std::uint32_t>(dictionary.number(parameters++, pdo_sub::cob_id));
    id = CobId{raw}.can_id();
  }
  return ids;
}

}  // namespace

ChargerOptions with_drawn_meter(ChargerOptions options) {
  Random random(options.faults.seed);
  const double share = static_cast<double>(random.below(2001)) / 1000 - 1;  // from -1 to 1
  options.stage.meter_gain *= 1 + share * options.meter_tolerance;
  return options;
}

ChargerDevices::ChargerDevices(World& world, const ChargerOptions& options, BusIndex bus)
    : world_(&world),
      options_(&options),
      bus_(bus),
      charger_slot_(world.add_slot(bus_)),
      battery_slot_(world.add_slot(bus_)),
      battery_port_(world.port(battery_slot_)),
      plant_(options.battery, options.state_of_charge, options.ambience_celsius, options.stage),
      charger_(world.port(charger_slot_), options.charger_id, charger_hardware(), options.charger),
      battery_(battery_port_.port(), options.battery_id, plant_.battery.hardware(),
               battery_settings()) {
  world.occupy(charger_slot_, charger_.node());
  world.occupy(battery_slot_, battery_.node());
}

cia418::BatterySettings ChargerDevices::battery_settings() const {
  const BatteryDesign& battery = options_->battery;
  return {.capacity_ampere_hours = battery.capacity_ampere_hour,
          .current_max_ampere = battery.charge_current_ampere,
          .cells = static_cast<std::uint16_t>(battery.cells),
          .requests_current = battery.asks};
}

cia419::ChargerHardware ChargerDevices::charger_hardware() {
  cia419::ChargerHardware hardware = plant_.stage.hardware();
  power_stage_ = hardware.deliver;
  hardware.deliver = callback<&ChargerDevices::deliver>(*this);
  if (!options_->begin) return hardware;
  clock_.emplace(*world_, *options_->begin);
  hardware.time_of_day = callback<&WallClock::now>(*clock_);
  return hardware;
}

void ChargerDevices::deliver(double ampere) {
  set_point_(ampere);
  power_stage_(ampere);
}

void ChargerDevices::power_battery(bool is_on) {
  has_battery_power_ = is_on;
  switch_battery();
}

void ChargerDevices::plug(bool is_in) {
  plant_.is_plugged = is_in_bay_ = is_in;
  // The pilot signal changes at once, and without a voltage nothing is taken from the mains.
  plant_.stage.step(ChargingPlant::step_time, 0, is_in);
  switch_battery();
}

void ChargerDevices::switch_battery() {
  if (!options_->plays_battery) return;
  has_battery_power_&& is_in_bay_ ? world_->start(battery_slot_) : world_->stop(battery_slot_);
}

void ChargerDevices::start() {
  start_manager();
  switch_battery();
  if (options_->plays_charger) world_->start(charger_slot_);
}

void ChargerDevices::start_manager() {
  if (options_->manager_id == 0) return;
  const SlotIndex slot = world_->add_slot(bus_);
  const auto time_out =
      options_->charger.battery_heartbeat * options_->charger.heartbeat_periods_max;
  manager_ = std::make_unique<VehicleManager>(world_->port(slot), options_->manager_id, time_out);
  manager_->on_change(connections_changed_);
  world_->occupy(slot, manager_->node());
  world_->start(slot);
}

std::span<const SdoConnection> ChargerDevices::connections() const {
  return manager_ ? manager_->connections() : std::span<const SdoConnection>();
}

HandshakeRules ChargerDevices::rules() const {
  const Dictionary& dictionary = battery_.node().dictionary();
  const auto heartbeat =
      std::chrono::milliseconds(dictionary.number(object_index::heartbeat_producer, 0));
  const auto event_time = std::chrono::milliseconds(
      dictionary.number(object_index::tpdo_parameter, pdo_sub::event_timer));
  return {.charger = options_->charger_id,
          .battery = options_->battery_id,
          .battery_tpdos = can_ids(dictionary, object_index::tpdo_parameter),
          .charger_tpdos = can_ids(dictionary, object_index::rpdo_parameter),
          .heartbeat_time = heartbeat * options_->charger.heartbeat_periods_max,
          .data_time = event_time * options_->charger.pdo_periods_max,
          .has_request = options_->battery.asks};
}

}  // namespace canvoy::charger
