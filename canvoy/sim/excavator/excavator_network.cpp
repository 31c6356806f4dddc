#include "canvoy/sim/excavator/excavator_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::excavator {

namespace {

OperatorOptions shift_of(const ExcavatorOptions& options) {
  OperatorOptions shift = options.shift;
  shift.end = Time(options.length);
  return shift;
}

}  // namespace

ExcavatorNetwork::ExcavatorNetwork(ExcavatorOptions options)
    : options_(std::move(options)),
      bus_(world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed})),
      embedded_bus_(
          world_.add_bus({.bit_rate = options_.bit_rate, .seed = options_.faults.seed + 1})),
      driver_(shift_of(options_), options_.faults.seed, panel_, machine_,
              {.press = [this](Button button, Duration down) { press(button, down); },
               .moved = [this] { hands_moved(); }}),
      seat_module_(world_, embedded_bus_, [this] { node(seat_id).touched(); }),
      bus_watch_(bus_, [this](Time now, const BusEvent& event) { heard(now, event); }),
      embedded_watch_(embedded_bus_,
                      [this](Time now, const BusEvent& event) { heard(now, event); }) {
  driver_.on_change([this](Time now, Activity to) {
    note(now, ActivityChanged{to});
    if (options_.records_shift) recorder_.began(now, static_cast<std::uint8_t>(to));
  });
  if (options_.sabotage.pierced_bucket) machine_.pierce_bucket();
  if (options_.sabotage.burnt_lamp) panel_.burn_out(Lamp::light);
  if (options_.sabotage.frozen_display) panel_.freeze_display();
  add_nodes();
  world_.bus(bus_).observe(
      {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         static_cast<ExcavatorNetwork*>(self)->frame_sent(frame);
       }});
  world_.bus(bus_).observe(bus_watch_.tap());
  world_.bus(embedded_bus_)
      .observe(
          {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
             static_cast<ExcavatorNetwork*>(self)->frame_sent_behind(frame);
           }});
  world_.bus(embedded_bus_).observe(embedded_watch_.tap());
  world_.add_plant(Callback<void(Time)>::to<&ExcavatorNetwork::step>(*this),
                   ExcavatorOperator::step_time);
  plan_faults();
  for (const auto& node : nodes_) power(*node, true);
}

ExcavatorNetwork::~ExcavatorNetwork() = default;

bool ExcavatorNetwork::is_played(NodeId id) const {
  return std::ranges::find(options_.real, id) == options_.real.end();
}

MachineNode& ExcavatorNetwork::node(NodeId id) {
  const auto found =
      std::ranges::find_if(nodes_, [id](const auto& node) { return node->place().id == id; });
  return **found;
}

void ExcavatorNetwork::step(Time now) {
  judge_axes(now);
  driver_.step(now);
  machine_.step(std::chrono::duration<double>(ExcavatorOperator::step_time).count());
  node(valves_id).with([this] { valves_unit_->hardware_changed(); });
  judge(now);
  tell_changes(now);
  check(now);
}

// Hands.

void ExcavatorNetwork::hands_moved() {
  if (options_.records_shift) recorder_.look(now(), panel_);
  node(seat_id).with([this] {
    if (options_.sensing_period == Duration{}) seat_unit_->hardware_changed();
  });
  if (options_.has_armrest) {
    node(armrest_id).with([this] { armrest_unit_->hardware_changed(); });
  }
}

void ExcavatorNetwork::press(Button button, Duration down) {
  note(now(), ButtonPressed{button});
  if (options_.records_shift) recorder_.pressed(now(), button, down);
  referee_.pressed(now(), button);
  panel_.press(button, true);
  hands_moved();
  world_.at(now() + down, [this, button](Time) {
    panel_.press(button, false);
    hands_moved();
  });
}

// The bus.

void ExcavatorNetwork::frame_sent(const Frame& frame) {
  if (frame.id == can_id::error_control + host_id) referee_.heard_host(now());
  if (frame.id == can_id::error_control + seat_id) referee_.heard_seat(now());
  if (!is_played(valves_id)) lead_by_real_valves(frame);
}

/// What the armrest answers.
void ExcavatorNetwork::frame_sent_behind(const Frame& frame) {
  if (frame.id == can_id::sdo_response + armrest_id) referee_.heard_armrest(now());
}

void ExcavatorNetwork::heard(Time now, const BusEvent& event) {
  std::visit([&](const auto& seen) { note(now, seen); }, event);
}

// Judged.

void ExcavatorNetwork::judge(Time now) {
  bool moves = false;
  for (std::size_t i = 0; i < movements; ++i) {
    moves = moves || std::abs(machine_.speed(static_cast<Movement>(i))) > 0;
  }
  if (moves) moved_at_ = now;
  referee_.moves(now, machine_, panel_);
  referee_.look_at_presses(now);
  judge_lamps(now);
  const double heap = machine_.earth().heaped;
  const bool has_dumped = std::exchange(heaped_, heap) != heap;
  const bool is_served = !driver_.is_working() || has_dumped || is_locked_in_sight(now);
  referee_.judge(InvariantKind::service, now, is_served);
  for (const auto& node : nodes_) {
    // Nobody starts what is behind the seat: it is read in NMT state pre-operational.
    if (node->place().id == armrest_id) continue;
    referee_.judge_device(node->place().id, now,
                          is_at_work(world_, *node, bus_watch_, consumer_time));
  }
}

/// Who plays a recording does not press again where a fault has locked the hydraulics, and from
/// then on each of its presses does the opposite. While the lamp says so, that is nobody's failure.
bool ExcavatorNetwork::is_locked_in_sight(Time now) {
  if (options_.shift.recorded.empty()) return false;
  const bool is_locked = !machine_.has_pilot_pressure();
  if (is_locked && had_fault_ && referee_.is_excused(InvariantKind::service, now)) {
    is_out_of_step_ = true;
  }
  return is_out_of_step_ && is_locked && is_lit(panel_.lit(), Lamp::locked);
}

/// With a host they say what is so; without, what 6207h and 6444h say, whatever the faults.
void ExcavatorNetwork::judge_lamps(Time now) {
  constexpr Duration notices = consumer_time + 200ms;
  MachineNode& seat = node(seat_id);
  if (!seat.is_powered()) seat_was_set_up_ = false;
  const bool is_operational = seat.is_powered() && seat.node().state() == NmtState::operational;
  if (is_operational) seat_was_set_up_ = true;
  const bool is_alone = referee_.host_silence(now) > notices && seat_was_set_up_;
  if (is_alone) {
    referee_.judge_always(InvariantKind::indicators, now, is_as_without_host());
    return referee_.judge_always(InvariantKind::display, now, true);
  }
  const bool has_valves = is_at_work(world_, node(valves_id), bus_watch_, consumer_time);
  referee_.judge(InvariantKind::indicators, now, lamps_are_right(has_valves));
  referee_.judge(InvariantKind::display, now, display_is_right(has_valves));
}

bool ExcavatorNetwork::is_as_without_host() const {
  for (std::size_t i = 0; i < shown_parameters; ++i) {
    if (panel_.shown(static_cast<Shown>(i)) != no_value) return false;
  }
  return panel_.lit() == lamps_without_host;
}

bool ExcavatorNetwork::is_armrest_at_work() {
  if (!options_.has_armrest) return true;
  if (!is_played(armrest_id)) return referee_.armrest_silence(now()) <= consumer_time;
  return node(armrest_id).is_powered();
}

/// Of a machine whose module does not work, fuel and oil are not known.
bool ExcavatorNetwork::lamps_are_right(bool has_valves) {
  const Lamps& lit = panel_.lit();
  const auto is_as = [&lit](Lamp lamp, bool is_on) { return is_lit(lit, lamp) == is_on; };
  const auto is_switched = [this](Switched output) { return (outputs_ & bit_of(output)) != 0; };
  const double fuel = machine_.litres() / Excavator::tank_litres * 100;
  constexpr double hardly = 0.5;
  return is_as(Lamp::light, is_switched(Switched::light)) &&
         is_as(Lamp::beacon, is_switched(Switched::beacon)) &&
         is_as(Lamp::fast, machine_.is_fast()) &&
         is_as(Lamp::locked, !machine_.has_pilot_pressure()) && is_as(Lamp::ready, has_valves) &&
         (panel_.has_jam() ||
          is_as(Lamp::fault, panel_.has_broken_wire() || !has_valves || !is_armrest_at_work())) &&
         (!has_valves || std::abs(fuel - low_fuel_percent) < hardly ||
          is_as(Lamp::low_fuel, fuel < low_fuel_percent)) &&
         (!has_valves || std::abs(machine_.oil_celsius() - Excavator::hot) < hardly ||
          is_as(Lamp::hot, machine_.oil_celsius() > Excavator::hot));
}

/// What moves is told a moment later.
bool ExcavatorNetwork::display_is_right(bool has_valves) const {
  if (!has_valves) return panel_.shown(Shown::fuel) == no_value;
  const bool is_still = now() - moved_at_ > 1s;
  const auto is_near = [this](Shown what, double is, double tolerance) {
    return std::abs(panel_.shown(what) - is) <= tolerance;
  };
  const Excavator::Point tip = machine_.tip();
  constexpr double centimetres = 100;
  const double way = is_still ? 10 : 150;
  const double turn = is_still ? 2 : 20;
  const double slew =
      std::remainder(panel_.shown(Shown::slew) - machine_.angle(Movement::slew), 360);
  const std::uint32_t page = panel_.knob() % display_pages;
  constexpr Movement details[] = {Movement::boom, Movement::stick, Movement::bucket};
  const bool is_detail_right =
      page >= std::size(details)
          ? is_near(Shown::detail, machine_.pressure_bar(), is_still ? 5 : 400)
          : is_near(Shown::detail, machine_.angle(details[page]), is_still ? 2 : 45);
  return is_near(Shown::fuel, machine_.litres() / Excavator::tank_litres * 100, 1.5) &&
         is_near(Shown::oil, machine_.oil_celsius(), 2) && std::abs(slew) <= turn &&
         is_near(Shown::height, tip.z * centimetres, way) &&
         is_near(Shown::reach, tip.x * centimetres, way) &&
         is_near(Shown::rpm, machine_.rpm(), 60) && is_near(Shown::page, page, 0) &&
         is_detail_right;
}

/// What a stick was at in one of the last steps has been told by now.
void ExcavatorNetwork::judge_axes(Time now) {
  if (!is_played(host_id)) return;
  for (std::size_t i = 0; i < stick_count; ++i) {
    const auto stick = static_cast<Stick>(i);
    auto& places = axes_[i];
    std::shift_right(places.begin(), places.end(), 1);
    places[0] = panel_.stick(stick) * full_scale;
    double apart = INFINITY;
    for (const double place : places) {
      apart = std::min(apart, std::abs(place - host_->control().axis_value(stick)));
    }
    referee_.compare(now, apart);
  }
}

void ExcavatorNetwork::tell_changes(Time now) {
  if (std::exchange(told_lamps_, panel_.lit()) != panel_.lit()) {
    note(now, LampsChanged{panel_.lit()});
  }
  const double heap = machine_.earth().heaped;
  const bool is_emptied = heap > told_heap_ && machine_.earth().in_bucket < 0.01;
  if (is_emptied) note(now, BucketDumped{heap - std::exchange(told_heap_, heap), heap});
}

bool ExcavatorNetwork::all_hold() const {
  return std::ranges::all_of(invariants(), &Invariant::held);
}

/// Tells of each invariant once that it is broken, when it is.
void ExcavatorNetwork::check(Time now) {
  if (!referee_.has_news()) return;
  for (const Invariant& invariant : invariants()) {
    bool& told = told_.at(static_cast<std::size_t>(invariant.kind));
    if (invariant.held || std::exchange(told, true)) continue;
    note(now, InvariantBroken{invariant});
  }
}

ExcavatorSnapshot ExcavatorNetwork::snapshot() {
  const SimulatedBus& bus = world_.bus(bus_);
  ExcavatorSnapshot look;
  look.at = now();
  look.bus = {bus.load(nodes_.front()->controller()), bus.statistics().frames,
              bus.statistics().error_frames};
  const SimulatedBus& embedded = world_.bus(embedded_bus_);
  look.embedded = {embedded.load(seat_module_.controller()), embedded.statistics().frames,
                   embedded.statistics().error_frames};
  for (const auto& node : nodes_) {
    const BusWatch& watch = node->bus() == bus_ ? bus_watch_ : embedded_watch_;
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
  look.switched = outputs_;
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
