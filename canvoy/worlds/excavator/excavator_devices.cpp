#include "canvoy/worlds/excavator/excavator_devices.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/devices/cia401/kinds.hpp"

namespace canvoy::excavator {

namespace {

constexpr Duration patience = 3s;
constexpr std::uint16_t coarse_delta = 6'400;
constexpr Duration slow_filter = 40ms;

}  // namespace

HostSettings host_settings(const ExcavatorOptions& options) {
  const Sabotage& sabotage = options.sabotage;
  HostSettings settings;
  settings.checks_contacts = !sabotage.trusting_host;
  if (sabotage.patient_host) settings.seat_time_out = patience;
  if (sabotage.patient_valves) settings.host_time_out = patience;
  // The armrest is read through the seat: a host that waits for the seat for longer misses neither.
  settings.checks_armrest = !sabotage.old_lever && !sabotage.patient_host;
  settings.has_armrest = options.has_armrest;
  settings.has_trainer = options.has_trainer;
  settings.obeys_all_seats = sabotage.obeys_all_seats;
  settings.counts_edges = !sabotage.counts_levels;
  settings.filters_buttons = sabotage.slow_buttons;
  if (sabotage.coarse_deltas) settings.delta = coarse_delta;
  settings.sets_error_values = !sabotage.keeps_lamps;
  settings.restarts_others = !sabotage.forgetful_host;
  return settings;
}

ExcavatorDevices::ExcavatorDevices(World& world, ExcavatorBuses buses,
                                   const ExcavatorOptions& options, SeatPanel& panel,
                                   SeatPanel& trainer, ValvesHardware& valves)
    : world_(world),
      buses_(buses),
      options_(options),
      panel_(panel),
      trainer_(trainer),
      valves_hardware_(valves),
      seat_module_(world, buses.embedded, [this] { node(seat_id).touched(); }) {
  if (options.sabotage.burnt_lamp) panel.burn_out(Lamp::light);
  if (options.sabotage.frozen_display) panel.freeze_display();
  add_nodes();
  if (options_.has_armrest) add_armrest();
}

void ExcavatorDevices::add_nodes() {
  using Self = ExcavatorDevices;
  seat_site_.provide(callback<&Self::elements>(*this));
  seat_site_.provide(callback<&Self::seat_hardware>(*this));
  seat_site_.provide(callback<&Self::seat_settings>(*this));
  seat_site_.watch(callback<&Self::is_seat>(*this));
  valves_site_.provide(callback<&Self::valves_hardware>(*this));
  valves_site_.provide(callback<&Self::io_settings>(*this));
  valves_site_.watch(valves_unit_);
  using Make = MachineNode::Made (Self::*)(const Port&);
  constexpr Make makes[] = {&Self::make_host, &Self::make_seat, &Self::make_valves};
  for (std::size_t i = 0; i < device_places.size(); ++i) {
    add_node(device_places[i],
             [this, make = makes[i]](const Port& port) { return (this->*make)(port); });
  }
}

void ExcavatorDevices::add_armrest() {
  using Self = ExcavatorDevices;
  armrest_site_.provide(callback<&Self::armrest_hardware>(*this));
  armrest_site_.provide(callback<&Self::io_settings>(*this));
  armrest_site_.watch(armrest_unit_);
  add_node(armrest_place, [this](const Port& port) { return make_armrest(port); });
}

void ExcavatorDevices::add_node(const DevicePlace& place, MachineNode::Make make) {
  nodes_.push_back(std::make_unique<MachineNode>(
      world_, bus_of(place.id), MachineNode::Place{place.name, place.id, options_.plays(place.id)},
      options_.faults.seed + place.id, std::move(make)));
}

MachineNode::Made ExcavatorDevices::make_host(const Port& port) {
  host_.reset();
  host_ = std::make_unique<MachineHost>(port, host_settings(options_));
  return host_->node();
}

MachineNode::Made ExcavatorDevices::make_seat(const Port& port) {
  seat_module_.disconnect();
  seat_.reset();
  seat_ = std::make_unique<CatalogueDevice>(cia852::operator_kind, port, seat_id, seat_site_);
  if (!options_.has_armrest) return seat_->node();
  return {seat_->node(), seat_module_.connect(seat_->node())};
}

MachineNode::Made ExcavatorDevices::make_valves(const Port& port) {
  valves_.reset();
  valves_ = std::make_unique<CatalogueDevice>(cia401::io_kind, port, valves_id, valves_site_);
  return valves_->node();
}

MachineNode::Made ExcavatorDevices::make_armrest(const Port& port) {
  armrest_.reset();
  armrest_ = std::make_unique<CatalogueDevice>(cia401::io_kind, port, armrest_id, armrest_site_);
  return armrest_->node();
}

/// A seat that gets power compares both sensors of each axis again from the start.
cia852::OperatorHardware ExcavatorDevices::seat_hardware() {
  using Self = ExcavatorDevices;
  using Sense = cia852::TwoChannelAxes::Sense;
  cia852::OperatorHardware hardware = panel_.hardware();
  hardware.joystick_axis = Sense::to<&Self::first_axis>(*this);
  hardware.joystick_buttons = callback<&Self::joystick_buttons>(*this);
  if (options_.sabotage.single_channel) return hardware;
  axes_.emplace(hardware.joystick_axis, Sense::to<&Self::second_axis>(*this),
                cia852::TwoChannelSettings{});
  hardware.joystick_axis = axes_->checked();
  return hardware;
}

cia852::OperatorEnvironment ExcavatorDevices::elements() {
  cia852::OperatorEnvironment elements = cia852::usual_elements;
  if (options_.has_trainer) elements.joysticks = 2 * seats_max;
  return elements;
}

std::int16_t ExcavatorDevices::first_axis(unsigned joystick, unsigned axis) {
  return seat_of(joystick).joystick_axis(of_seat(joystick), axis);
}
std::int16_t ExcavatorDevices::second_axis(unsigned joystick, unsigned axis) {
  return seat_of(joystick).second_joystick_axis(of_seat(joystick), axis);
}
std::uint8_t ExcavatorDevices::joystick_buttons(unsigned joystick) {
  return seat_of(joystick).joystick_buttons(of_seat(joystick));
}

void ExcavatorDevices::is_seat(cia852::OperatorUnit& unit, Node& node) {
  seat_unit_ = &unit;
  if (axes_) axes_->connect(node, unit);
}

cia852::OperatorSettings ExcavatorDevices::seat_settings() {
  cia852::OperatorSettings settings{.sensing_period = options_.sensing_period};
  if (options_.sabotage.slow_buttons) settings.digital.filter_time = slow_filter;
  return settings;
}

cia401::IoHardware ExcavatorDevices::armrest_hardware() {
  return {.digital_inputs = callback<&ExcavatorDevices::sense_contacts>(*this)};
}

std::uint8_t ExcavatorDevices::sense_contacts(unsigned group) {
  return group == 1 ? panel_.contacts() : std::uint8_t{0};
}

void ExcavatorDevices::start() {
  for (const auto& node : nodes_) power(*node, true);
}

void ExcavatorDevices::power(MachineNode& node, bool is_on) {
  const NodeId id = node.place().id;
  if (!is_on && id == seat_id) panel_.go_dark();
  if (!is_on && id == valves_id) valves_hardware_.release();
  node.power(is_on);
  if (id == seat_id) seat_module_.power(node.is_powered());
}

void ExcavatorDevices::hands_moved() {
  node(seat_id).with([this] {
    if (options_.sensing_period == Duration{}) seat_unit_->hardware_changed();
  });
  if (options_.has_armrest) {
    node(armrest_id).with([this] { armrest_unit_->hardware_changed(); });
  }
}

void ExcavatorDevices::machine_moved() {
  node(valves_id).with([this] { valves_unit_->hardware_changed(); });
}

MachineNode& ExcavatorDevices::node(NodeId id) {
  const auto found =
      std::ranges::find_if(nodes_, [id](const auto& node) { return node->place().id == id; });
  return **found;
}

}  // namespace canvoy::excavator
