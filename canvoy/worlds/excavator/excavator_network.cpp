#include "canvoy/worlds/excavator/excavator_network.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::excavator {

namespace {

OperatorOptions shift_of(const ExcavatorOptions& options) {
  OperatorOptions shift = options.shift;
  shift.end = Time(options.length);
  return shift;
}

ExcavatorBuses add_buses(World& world, const ExcavatorOptions& options) {
  const std::uint64_t seed = options.faults.seed;
  const BusIndex machine = world.add_bus({.bit_rate = options.bit_rate, .seed = seed});
  return {machine, world.add_bus({.bit_rate = options.bit_rate, .seed = seed + 1})};
}

}  // namespace

ExcavatorNetwork::ExcavatorNetwork(ExcavatorOptions options)
    : options_(std::move(options)),
      buses_(add_buses(world_, options_)),
      machine_(options_.faults.seed),
      driver_(shift_of(options_), options_.faults.seed, panel_, machine_,
              {.press = [this](Button button, Duration down) { press(button, down); },
               .moved = [this] { hands_moved(); }}),
      trainer_(trainer_panel_, panel_, driver_, [this] { hands_moved(); }),
      valves_(machine_, [this](Button button, bool is_on) { switched(button, is_on); }),
      devices_(world_, buses_, options_, panel_, trainer_panel_, valves_),
      bus_watch_(buses_.machine, [this](Time now, const BusEvent& event) { heard(now, event); }),
      embedded_watch_(buses_.embedded,
                      [this](Time now, const BusEvent& event) { heard(now, event); }),
      referees_(world_, options_, {machine_, panel_, trainer_panel_, valves_, driver_}, devices_,
                bus_watch_),
      stepping_(world_.add_plant(Callback<void(Time)>::to<&ExcavatorNetwork::step>(*this),
                                 ExcavatorOperator::step_time)),
      faults_(world_, buses_.machine, options_, devices_, panel_, referees_, events_) {
  driver_.on_change([this](Time now, Activity to) {
    note(now, ActivityChanged{to});
    if (options_.records_shift) recorder_.began(now, static_cast<std::uint8_t>(to));
  });
  if (options_.sabotage.pierced_bucket) machine_.pierce_bucket();
  name_nodes();
  observe_buses();
  devices_.start();
}

void ExcavatorNetwork::name_nodes() {
  for (const auto& node : nodes()) {
    BusWatch& watch = node->bus() == buses_.machine ? bus_watch_ : embedded_watch_;
    watch.name(node->controller(), node->place().id);
  }
}

void ExcavatorNetwork::observe_buses() {
  SimulatedBus& machine = world_.bus(buses_.machine);
  machine.observe(
      {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         static_cast<ExcavatorNetwork*>(self)->hear(frame);
       }});
  machine.observe(bus_watch_.tap());
  SimulatedBus& embedded = world_.bus(buses_.embedded);
  embedded.observe(
      {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         auto& network = *static_cast<ExcavatorNetwork*>(self);
         network.referees_.hear_behind(network.now(), frame);
       }});
  embedded.observe(embedded_watch_.tap());
}

void ExcavatorNetwork::step(Time now) {
  referees_.look_at_axes(now);
  driver_.step(now);
  if (options_.has_trainer) trainer_.step(now);
  machine_.step(std::chrono::duration<double>(ExcavatorOperator::step_time).count());
  devices_.machine_moved();
  referees_.look(now);
  tell_changes(now);
  for (const Invariant& broken : referees_.take_broken()) note(now, InvariantBroken{broken});
}

void ExcavatorNetwork::hear(const Frame& frame) {
  referees_.hear(now(), frame);
  if (!options_.plays(valves_id)) valves_.follow(frame);
}

void ExcavatorNetwork::heard(Time now, const BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

void ExcavatorNetwork::hands_moved() {
  if (options_.records_shift) recorder_.look(now(), panel_);
  devices_.hands_moved();
}

void ExcavatorNetwork::press(Button button, Duration down) {
  note(now(), ButtonPressed{button});
  if (options_.records_shift) recorder_.pressed(now(), button, down);
  referees_.pressed(now(), button);
  panel_.press(button, true);
  hands_moved();
  world_.at(now() + down, [this, button](Time) {
    panel_.press(button, false);
    hands_moved();
  });
}

void ExcavatorNetwork::switched(Button button, bool is_on) {
  note(now(), SwitchChanged{button, is_on});
  referees_.switched(now(), button, is_on);
}

void ExcavatorNetwork::tell_changes(Time now) {
  if (std::exchange(told_lamps_, panel_.lit()) != panel_.lit()) {
    note(now, LampsChanged{panel_.lit()});
  }
  const double heap = machine_.earth().heaped;
  const bool is_emptied = heap > told_heap_ && machine_.earth().in_bucket <= 0;
  if (is_emptied) note(now, BucketDumped{heap - std::exchange(told_heap_, heap), heap});
}

bool ExcavatorNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

ExcavatorSnapshot ExcavatorNetwork::snapshot() {
  const SimulatedBus& bus = world_.bus(buses_.machine);
  ExcavatorSnapshot look;
  look.at = now();
  look.bus = {bus.load(nodes().front()->controller()), bus.statistics().frames,
              bus.statistics().error_frames};
  const SimulatedBus& embedded = world_.bus(buses_.embedded);
  look.embedded = {embedded.load(devices_.module_controller()), embedded.statistics().frames,
                   embedded.statistics().error_frames};
  for (const auto& node : nodes()) {
    const BusWatch& watch = node->bus() == buses_.machine ? bus_watch_ : embedded_watch_;
    look.nodes.push_back(snapshot_of(world_, *node, watch, consumer_time));
    look.names.push_back(node->place().name);
  }
  look.activity = driver_.activity();
  look.wishes = driver_.wishes();
  look.statistics = {
      .cycles = driver_.cycles(),
      .presses = driver_.presses(),
      .earth = machine_.earth(),
      .metres = (machine_.angle(Movement::left_track) + machine_.angle(Movement::right_track)) / 2};
  for (std::size_t i = 0; i < movements; ++i) {
    const auto movement = static_cast<Movement>(i);
    look.angles[i] = machine_.angle(movement);
    look.speeds[i] = machine_.speed(movement);
    look.hands[i] = panel_.wanted(movement);
  }
  look.arm = {machine_.joint(Movement::boom), machine_.joint(Movement::stick),
              machine_.joint(Movement::bucket), machine_.tip()};
  for (std::size_t i = 0; i < button_count; ++i) {
    look.pressed[i] = panel_.is_pressed(static_cast<Button>(i));
  }
  look.is_lever_lowered = panel_.is_lever_lowered();
  look.switched = valves_.outputs();
  look.lit = panel_.lit();
  for (std::size_t i = 0; i < shown_parameters; ++i) {
    look.display[i] = panel_.shown(static_cast<Shown>(i));
  }
  look.rpm = machine_.rpm();
  look.fuel_percent = machine_.litres() / Excavator::tank_litres * 100;
  look.oil_celsius = machine_.oil_celsius();
  return look;
}

}  // namespace canvoy::excavator
