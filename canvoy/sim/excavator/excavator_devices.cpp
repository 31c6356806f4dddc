// The devices of an excavator, and what they find there.
#include <cmath>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/devices/cia401/kinds.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/sim/excavator/excavator_network.hpp"

namespace canvoy::excavator {

namespace {

constexpr unsigned unused_bits = 16;  ///< values of converters are adjusted to the left
constexpr Duration patience = 3s;
constexpr std::uint16_t coarse_delta = 6'400;
constexpr Duration slow_filter = 40ms;

InvariantSet of_kinds(std::initializer_list<InvariantKind> kinds) {
  InvariantSet set;
  for (const InvariantKind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

/// What cannot be told where a device is not played: its hands, or what it shows, are elsewhere.
InvariantSet unknown_without(NodeId id) {
  using Kind = InvariantKind;
  const InvariantSet of_seat = of_kinds({Kind::unwanted_motion, Kind::presses, Kind::axis_delta,
                                         Kind::indicators, Kind::display, Kind::service});
  if (id == seat_id) return of_seat;
  if (id == valves_id) return of_kinds({Kind::display, Kind::indicators, Kind::service});
  // Its lever is elsewhere, and may be up.
  if (id == armrest_id) return of_kinds({Kind::presses, Kind::service});
  // A real host may do without the armrest.
  return of_kinds({Kind::axis_delta, Kind::lost_armrest});
}

}  // namespace

HostSettings ExcavatorNetwork::host_settings() const {
  const Sabotage& sabotage = options_.sabotage;
  HostSettings settings;
  settings.checks_contacts = !sabotage.trusting_host;
  if (sabotage.patient_host) settings.seat_time_out = patience;
  if (sabotage.patient_valves) settings.host_time_out = patience;
  // The armrest is heard through the seat: whoever waits for this one misses neither.
  settings.checks_armrest = !sabotage.old_lever && !sabotage.patient_host;
  settings.has_armrest = options_.has_armrest;
  settings.counts_edges = !sabotage.counts_levels;
  settings.filters_buttons = sabotage.slow_buttons;
  if (sabotage.coarse_deltas) settings.delta = coarse_delta;
  settings.sets_error_values = !sabotage.keeps_lamps;
  settings.restarts_others = !sabotage.forgetful_host;
  return settings;
}

void ExcavatorNetwork::add_nodes() {
  seat_site_.offer(Callback<cia852::OperatorEnvironment()>::to<&ExcavatorNetwork::elements>(*this));
  seat_site_.offer(
      Callback<cia852::OperatorHardware()>::to<&ExcavatorNetwork::seat_hardware>(*this));
  seat_site_.offer(
      Callback<cia852::OperatorSettings()>::to<&ExcavatorNetwork::seat_settings>(*this));
  seat_site_.watch(
      Callback<void(cia852::OperatorUnit&, Node&)>::to<&ExcavatorNetwork::is_seat>(*this));
  valves_site_.offer(Callback<cia401::IoHardware()>::to<&ExcavatorNetwork::valves_hardware>(*this));
  valves_site_.offer(Callback<cia401::IoSettings()>::to<&ExcavatorNetwork::valves_settings>(*this));
  valves_site_.watch(
      Callback<void(cia401::IoUnit&, Node&)>::to<&ExcavatorNetwork::is_valves>(*this));
  using Make = MachineNode::Made (ExcavatorNetwork::*)(const Port&);
  constexpr Make makes[] = {&ExcavatorNetwork::make_host, &ExcavatorNetwork::make_seat,
                            &ExcavatorNetwork::make_valves};
  for (std::size_t i = 0; i < device_places.size(); ++i) {
    add_node(device_places[i], bus_,
             [this, make = makes[i]](const Port& port) { return (this->*make)(port); });
    bus_watch_.name(nodes_.back()->controller(), device_places[i].id);
  }
  if (options_.has_armrest) return add_armrest();
  referee_.has_no_armrest();
  referee_.cannot_judge(of_kinds({InvariantKind::lost_armrest}));
}

void ExcavatorNetwork::add_node(const DevicePlace& place, BusIndex bus, MachineNode::Make make) {
  nodes_.push_back(std::make_unique<MachineNode>(
      world_, bus, MachineNode::Place{place.name, place.id, is_played(place.id)},
      options_.faults.seed + place.id, std::move(make)));
  if (!is_played(place.id)) referee_.cannot_judge(unknown_without(place.id));
}

void ExcavatorNetwork::add_armrest() {
  armrest_site_.offer(
      Callback<cia401::IoHardware()>::to<&ExcavatorNetwork::armrest_hardware>(*this));
  armrest_site_.offer(
      Callback<cia401::IoSettings()>::to<&ExcavatorNetwork::armrest_settings>(*this));
  armrest_site_.watch(
      Callback<void(cia401::IoUnit&, Node&)>::to<&ExcavatorNetwork::is_armrest>(*this));
  add_node(armrest_place, embedded_bus_, [this](const Port& port) { return make_armrest(port); });
  embedded_watch_.name(nodes_.back()->controller(), armrest_id);
}

MachineNode::Made ExcavatorNetwork::make_host(const Port& port) {
  host_.reset();
  host_ = std::make_unique<MachineHost>(port, host_settings());
  return host_->node();
}

MachineNode::Made ExcavatorNetwork::make_seat(const Port& port) {
  seat_module_.disconnect();
  seat_.reset();
  seat_ = std::make_unique<CatalogueDevice>(cia852::operator_kind, port, seat_id, seat_site_);
  if (!options_.has_armrest) return seat_->node();
  return {seat_->node(), seat_module_.connect(seat_->node())};
}

MachineNode::Made ExcavatorNetwork::make_armrest(const Port& port) {
  armrest_.reset();
  armrest_ = std::make_unique<CatalogueDevice>(cia401::io_kind, port, armrest_id, armrest_site_);
  return armrest_->node();
}

MachineNode::Made ExcavatorNetwork::make_valves(const Port& port) {
  valves_.reset();
  valves_ = std::make_unique<CatalogueDevice>(cia401::io_kind, port, valves_id, valves_site_);
  return valves_->node();
}

/// What has no power is dark, and its valves close.
void ExcavatorNetwork::power(MachineNode& node, bool is_on) {
  const NodeId id = node.place().id;
  if (!is_on && id == seat_id) panel_.go_dark();
  if (!is_on && id == valves_id) release_outputs();
  if (id == seat_id) seat_was_set_up_ = false;
  node.power(is_on);
  if (id == seat_id) seat_module_.power(node.is_powered());
}

// The seat.

cia852::OperatorSettings ExcavatorNetwork::seat_settings() {
  cia852::OperatorSettings settings{.sensing_period = options_.sensing_period};
  if (options_.sabotage.slow_buttons) settings.digital.filter_time = slow_filter;
  return settings;
}

// The armrest behind it.

cia401::IoHardware ExcavatorNetwork::armrest_hardware() {
  return {.digital_inputs =
              Callback<std::uint8_t(unsigned)>::to<&ExcavatorNetwork::sense_lever>(*this)};
}

std::uint8_t ExcavatorNetwork::sense_lever(unsigned group) {
  return group == 1 && panel_.is_lever_lowered() ? lever_bit : std::uint8_t{0};
}

// The module on the valves.

cia401::IoSettings ExcavatorNetwork::valves_settings() {
  return {.sensing_period = Duration::zero()};
}

cia401::IoHardware ExcavatorNetwork::valves_hardware() {
  using Self = ExcavatorNetwork;
  return {
      .digital_inputs = Callback<std::uint8_t(unsigned)>::to<&Self::sense_digital>(*this),
      .drive_digital = Callback<void(unsigned, std::uint8_t)>::to<&Self::drive_digital>(*this),
      .analogue_input = Callback<std::int32_t(unsigned)>::to<&Self::sense_analogue>(*this),
      .drive_analogue = Callback<void(unsigned, std::int32_t)>::to<&Self::drive_analogue>(*this)};
}

std::uint8_t ExcavatorNetwork::sense_digital(unsigned) {
  return 0;
}

std::int32_t ExcavatorNetwork::sense_analogue(unsigned channel) {
  if (channel > sensors) return 0;
  const auto sensor = static_cast<Sensor>(channel);
  const auto value = [&]() -> double {
    switch (sensor) {
      case Sensor::boom:
        return machine_.angle(Movement::boom);
      case Sensor::stick:
        return machine_.angle(Movement::stick);
      case Sensor::bucket:
        return machine_.angle(Movement::bucket);
      case Sensor::slew:
        return machine_.angle(Movement::slew);
      case Sensor::fuel:
        return machine_.litres() / Excavator::tank_litres * 100;
      case Sensor::oil:
        return machine_.oil_celsius();
      case Sensor::rpm:
        return machine_.rpm();
      case Sensor::pressure:
        return machine_.pressure_bar();
    }
    return 0;
  };
  return static_cast<std::int32_t>(std::lround(value() * digits_of(sensor))) * (1 << unused_bits);
}

void ExcavatorNetwork::drive_digital(unsigned group, std::uint8_t outputs) {
  if (group == 1) switch_outputs(outputs);
}

void ExcavatorNetwork::switch_outputs(unsigned outputs) {
  const unsigned changed = outputs ^ outputs_;
  outputs_ = outputs;
  machine_.set_fast_travel((outputs & bit_of(Switched::fast_travel)) != 0);
  machine_.set_pilot_pressure((outputs & bit_of(Switched::pilot_pressure)) != 0);
  for (std::size_t i = 0; i < button_count; ++i) {
    const unsigned bit = 1U << i;
    const auto button = static_cast<Button>(i);
    if ((changed & bit) == 0) continue;
    note(now(), SwitchChanged{button, (outputs & bit) != 0});
    // A toot is heard once, at its begin; and what the lever locks, nobody has pressed.
    const bool is_toot_over = button == Button::horn && (outputs & bit) == 0;
    const bool is_by_lever = button == Button::lock && !panel_.is_lever_lowered();
    if (!is_toot_over && !is_by_lever) referee_.has_effect(now(), button);
  }
}

void ExcavatorNetwork::drive_analogue(unsigned channel, std::int32_t value) {
  set_valve(channel, (value >> unused_bits) / valve_digits);
}

void ExcavatorNetwork::set_valve(unsigned channel, double share) {
  const double limited = std::clamp(share, -1.0, 1.0);
  if (channel == throttle_output) machine_.set_throttle(std::max(limited, 0.0));
  if (channel <= movements) machine_.command(static_cast<Movement>(channel - 1), limited);
}

void ExcavatorNetwork::release_outputs() {
  switch_outputs(0);
  for (unsigned channel = 1; channel <= throttle_output; ++channel) set_valve(channel, 0);
}

/// A real module has its own valves: here they follow what the host tells it.
void ExcavatorNetwork::lead_by_real_valves(const Frame& frame) {
  if (!frame.is_plain() || frame.length != Frame::length_max) return;
  if (frame.id == switches_id) return switch_outputs(frame.data[0]);
  const bool is_first = frame.id == valve_id;
  if (!is_first && frame.id != more_valves_id) return;
  for (unsigned i = 0; i < 4; ++i) {
    const auto value =
        static_cast<std::int16_t>(load<std::uint16_t>(&frame.data[2 * std::size_t{i}]));
    set_valve((is_first ? 1 : 5) + i, value / valve_digits);
  }
}

}  // namespace canvoy::excavator
