#include "canvoy/worlds/excavator/excavator_network.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::excavator {

namespace {

using Kind = InvariantKind;

constexpr double lost_share = 0.05;  ///< lost_frames: share of the frames of a node
constexpr Duration frame_delay = 20ms;

InvariantSet set_of(std::initializer_list<Kind> kinds) {
  InvariantSet set;
  for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

Stick axis_of(const ScheduledFault& fault) {
  return static_cast<Stick>(spot_of(fault) - 1);
}

}  // namespace

/// Sensors that disagree are found by the seat.
InvariantSet affected_at_first(FaultKind kind) {
  return kind == FaultKind::drifting_axis ? set_of({Kind::axis_delta}) : InvariantSet{};
}

/// Never the invariant of motion: the machine stops, whatever happens.
InvariantSet affected_by(FaultKind kind) {
  switch (kind) {
    case FaultKind::corrupted_frames:
      return {};
    case FaultKind::delayed_frames:
      return set_of({Kind::axis_delta});
    case FaultKind::stuck_axis:
    case FaultKind::broken_wire:
      return set_of({Kind::axis_delta, Kind::service, Kind::spilled});
    case FaultKind::drifting_axis:
      return set_of({Kind::service, Kind::spilled});
    case FaultKind::vanished_armrest:
    case FaultKind::emergency_stop:
    case FaultKind::seat_switch:
      return set_of({Kind::presses, Kind::service, Kind::spilled});
    default:
      return set_of({Kind::presses, Kind::axis_delta, Kind::indicators, Kind::display,
                     Kind::throttle, Kind::service, Kind::spilled, Kind::device_missing});
  }
}

ExcavatorFaults::ExcavatorFaults(World& world, BusIndex bus, const ExcavatorOptions& options,
                                 ExcavatorDevices& devices, SeatPanel& panel,
                                 ExcavatorReferees& referees, std::vector<ExcavatorEvent>& events)
    : world_(&world),
      bus_(bus),
      options_(&options),
      devices_(&devices),
      panel_(&panel),
      referees_(&referees),
      events_(&events),
      trouble_(world.bus(bus)),
      faults_(options.faults.faults, Engine::of(*this)),
      cuts_(PowerCuts::Switch::to<&ExcavatorFaults::power>(*this)) {
  if (faults_.has_any(FaultKind::babbling_node)) trouble_.attach_babbler();
  faults_.plan(world);
}

void ExcavatorFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const NodeId id = node_of(it);
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_begins(now, it.kind);
}

void ExcavatorFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const NodeId id = node_of(it);
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_ends(now, it.kind);
}

void ExcavatorFaults::set(std::size_t number, bool present) {
  const ScheduledFault& fault = faults_[number];
  SimulatedBus& bus = world_->bus(bus_);
  const NodeId id = node_of(fault);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return cuts_.set_power(id, !present);
    case FaultKind::restart:
      return present ? cuts_.restart(id) : void();
    case FaultKind::bus_off:
      bus.set_bit_rate(devices_->node(id).controller(),
                       present ? options_->bit_rate / 2 : options_->bit_rate);
      return present ? void() : bus.recover(devices_->node(id).controller());
    case FaultKind::cable_cut:
      return cut_cables();
    case FaultKind::babbling_node:
      return trouble_.babble(present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(present ? corrupted_share : 0);
    case FaultKind::lost_frames:
      return devices_->node(id).port().lose(Probability(present ? lost_share : 0));
    case FaultKind::delayed_frames:
      return devices_->node(id).port().delay(present ? frame_delay : Duration{});
    case FaultKind::stuck_axis:
      panel_->jam(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::broken_wire:
      panel_->break_wire(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::drifting_axis:
      panel_->drift(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::vanished_armrest:
      return cuts_.set_power(armrest_id, !present);
    case FaultKind::emergency_stop:
      panel_->press_stop(present);
      return devices_->hands_moved();
    case FaultKind::seat_switch:
      panel_->break_seat_switch(present);
      return devices_->hands_moved();
  }
}

/// Cuts all cables of present faults.
void ExcavatorFaults::cut_cables() {
  SimulatedBus& bus = world_->bus(bus_);
  bus.mend_cable();
  for (const auto& node : devices_->nodes()) {
    const bool is_cut = faults_.is_present(FaultKind::cable_cut, node->place().id);
    if (is_cut) bus.cut_cable(node->controller());
  }
}

namespace {

constexpr Duration lesson_each = 3min;
constexpr Duration comes_to_rest_in = 1500ms;
constexpr Duration asks_for = 300ms;
constexpr Duration asks_again = 1s;
constexpr Duration stops_asking = 8s;
constexpr Duration moves_for = 2s;
/// Longer than an unwanted motion may last.
constexpr Duration pulls_for = 3s;
constexpr double slew_place = 0.3;
constexpr double pull_place = 0.5;

}  // namespace

void Trainer::enter(Time now, Step step) {
  step_ = step;
  since_ = now;
}

void Trainer::step(Time now) {
  const std::uint64_t before = own_.hand_changes() + panel_.hand_changes();
  act(now, now - since_);
  if (own_.hand_changes() + panel_.hand_changes() != before) moved_();
}

bool Trainer::has_asked(SeatPanel& seat, std::size_t number, Duration passed) {
  const bool is_shown = panel_.commanding_seat() == number;
  seat.ask_for_command(!is_shown && passed % asks_again < asks_for);
  return is_shown;
}

void Trainer::act(Time now, Duration passed) {
  const bool is_over = passed >= moves_for;
  switch (step_) {
    case Step::waits:
      if (passed < lesson_each || !driver_.is_working()) return;
      driver_.hold_back(0);
      return enter(now, Step::comes_to_rest);
    case Step::comes_to_rest:
      if (passed >= comes_to_rest_in && panel_.is_at_rest()) enter(now, Step::takes);
      return;
    case Step::takes:
      if (has_asked(own_, 1, passed)) return enter(now, Step::slews);
      if (passed >= stops_asking) enter(now, Step::gives);
      return;
    case Step::slews:
      own_.move_stick(Stick::left_x, is_over ? 0 : slew_place);
      if (is_over) enter(now, Step::looks_on);
      return;
    case Step::looks_on:
      driver_.hold_back(passed < pulls_for ? pull_place : 0);
      if (passed >= pulls_for) enter(now, Step::slews_back);
      return;
    case Step::slews_back:
      own_.move_stick(Stick::left_x, is_over ? 0 : -slew_place);
      if (is_over) enter(now, Step::rests);
      return;
    case Step::rests:
      if (passed >= comes_to_rest_in) enter(now, Step::gives);
      return;
    case Step::gives:
      own_.ask_for_command(false);
      if (!has_asked(panel_, 0, passed) && passed < stops_asking) return;
      if (passed < stops_asking) ++lessons_;
      panel_.ask_for_command(false);
      driver_.hold_back(std::nullopt);
      return enter(now, Step::waits);
  }
}

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
      stepping_(
          world_.add_plant(callback<&ExcavatorNetwork::step>(*this), ExcavatorOperator::step_time)),
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
  report_changes(now);
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

void ExcavatorNetwork::report_changes(Time now) {
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
