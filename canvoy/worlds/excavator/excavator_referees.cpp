#include "canvoy/worlds/excavator/excavator_referees.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/sim/snapshot.hpp"

namespace canvoy::excavator {

namespace {

InvariantSet of_kinds(std::initializer_list<InvariantKind> kinds) {
  InvariantSet set;
  for (const InvariantKind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

/// Invariants that cannot be judged where a device is not simulated here: its hands, or its
/// outputs, are elsewhere.
InvariantSet unknown_without(NodeId id) {
  using Kind = InvariantKind;
  const InvariantSet of_seat =
      of_kinds({Kind::unwanted_motion, Kind::presses, Kind::axis_delta, Kind::indicators,
                Kind::display, Kind::throttle, Kind::service, Kind::spilled});
  if (id == seat_id) return of_seat;
  if (id == valves_id) {
    return of_kinds({Kind::display, Kind::indicators, Kind::service, Kind::spilled});
  }
  // Its lever is elsewhere, and may be up.
  if (id == armrest_id) return of_kinds({Kind::presses, Kind::service, Kind::spilled});
  // A real host may run without the armrest.
  return of_kinds({Kind::axis_delta, Kind::lost_armrest});
}

}  // namespace

ExcavatorReferees::ExcavatorReferees(const World& world, const ExcavatorOptions& options,
                                     const ExcavatorTruth& truth, ExcavatorDevices& devices,
                                     const BusWatch& watch)
    : world_(&world),
      options_(&options),
      machine_(&truth.machine),
      panel_(&truth.panel),
      trainer_(&truth.trainer),
      driver_(&truth.driver),
      devices_(&devices),
      watch_(&watch),
      cab_(truth.machine, truth.panel, truth.valves) {
  for (const auto& node : devices.nodes()) {
    const NodeId id = node->place().id;
    if (!options.plays(id)) referee_.cannot_judge(unknown_without(id));
  }
  if (!options.has_armrest) referee_.has_no_armrest();
}

void ExcavatorReferees::hear(Time now, const Frame& frame) {
  if (frame.id == can_id::error_control + host_id) referee_.heard_host(now);
  if (frame.id == can_id::error_control + seat_id) referee_.heard_seat(now);
}

/// Takes the answers of the armrest.
void ExcavatorReferees::hear_behind(Time now, const Frame& frame) {
  if (frame.id == can_id::sdo_response + armrest_id) referee_.heard_armrest(now);
}

/// A horn is heard once, at its beginning; and what the armrest locks was not pressed.
void ExcavatorReferees::switched(Time now, Button button, bool is_on) {
  const bool is_toot_over = button == Button::horn && !is_on;
  const bool is_by_armrest = button == Button::lock && !panel_->is_released();
  if (!is_toot_over && !is_by_armrest) referee_.has_effect(now, button);
}

void ExcavatorReferees::fault_begins(Time now, FaultKind kind) {
  had_fault_ = true;
  referee_.fault_begins(affected_by(kind));
  excuse_at_first(now, kind);
  if (!lasts(kind)) referee_.fault_ends(affected_by(kind), now);
}

void ExcavatorReferees::fault_ends(Time now, FaultKind kind) {
  if (lasts(kind)) referee_.fault_ends(affected_by(kind), now);
  excuse_at_first(now, kind);
}

void ExcavatorReferees::excuse_at_first(Time now, FaultKind kind) {
  referee_.fault_begins(affected_at_first(kind));
  referee_.fault_ends(affected_at_first(kind), now);
}

void ExcavatorReferees::look(Time now) {
  cab_.step(now);
  std::array<double, movements> hands{};
  for (std::size_t i = 0; i < movements; ++i) hands[i] = wanted(static_cast<Movement>(i));
  referee_.moves(now, *machine_, hands);
  referee_.look_at_presses(now);
  look_at_lamps(now);
  look_at_throttle(now);
  look_at_earth(now);
  const bool has_service = is_served(now);
  driver_->is_working() ? referee_.judge(InvariantKind::service, now, has_service)
                        : referee_.pass(InvariantKind::service, now);
  for (const auto& node : devices_->nodes()) {
    // Devices behind the seat are not started: they are read in NMT state pre-operational.
    if (node->place().id == armrest_id) continue;
    referee_.judge_device(node->place().id, now,
                          is_at_work(*world_, *node, *watch_, consumer_time));
  }
}

/// What a hand wants that may move the machine: at a seat of which the lamp of the command is lit,
/// or at any while none is; with an open contact at the armrest, none.
double ExcavatorReferees::wanted(Movement movement) const {
  if (!panel_->is_released()) return 0;
  if (!options_->has_trainer) return panel_->wanted(movement);
  const std::optional<std::size_t> seat = panel_->commanding_seat();
  if (seat == 1U) return trainer_->wanted(movement);
  const double own = panel_->wanted(movement);
  return seat || own != 0 ? own : trainer_->wanted(movement);
}

/// Wherever it goes, earth that leaves the bucket is looked at.
void ExcavatorReferees::look_at_earth(Time now) {
  const Excavator::Earth& earth = machine_->earth();
  const double poured = earth.heaped + earth.spilled;
  const bool pours = std::exchange(poured_, poured) != poured;
  referee_.has_earth(now, earth.dug, earth.spilled, pours);
}

bool ExcavatorReferees::is_served(Time now) {
  const double heap = machine_->earth().heaped;
  const bool has_dumped = std::exchange(heaped_, heap) != heap;
  return !driver_->is_working() || has_dumped || is_locked_in_sight(now);
}

/// A recording is played without a further press where a fault has locked the hydraulics, and each
/// later press then has the opposite effect. While the lamp shows this, it is no failure.
bool ExcavatorReferees::is_locked_in_sight(Time now) {
  if (options_->shift.recorded.empty()) return false;
  const bool is_locked = !machine_->has_pilot_pressure();
  if (is_locked && had_fault_ && referee_.is_excused(InvariantKind::service, now)) {
    is_out_of_step_ = true;
  }
  return is_out_of_step_ && is_locked && is_lit(panel_->lit(), Lamp::locked);
}

void ExcavatorReferees::look_at_lamps(Time now) {
  constexpr Duration notices = consumer_time + 200ms;
  MachineNode& seat = devices_->node(seat_id);
  const bool is_new = std::exchange(seat_starts_, seat.starts()) != seat.starts();
  if (is_new || !seat.is_powered()) seat_was_set_up_ = false;
  const bool is_operational = seat.is_powered() && seat.node().state() == NmtState::operational;
  if (is_operational) seat_was_set_up_ = true;
  const bool is_alone = referee_.host_silence(now) > notices && seat_was_set_up_;
  if (is_alone) {
    referee_.judge_always(InvariantKind::indicators, now, cab_.is_as_without_host());
    return referee_.pass(InvariantKind::display, now);
  }
  const bool has_valves = is_at_work(*world_, devices_->node(valves_id), *watch_, consumer_time);
  referee_.judge(InvariantKind::indicators, now,
                 cab_.lamps_are_right(has_valves, is_armrest_at_work(now)) &&
                     (!options_->has_trainer || panel_->commanding_seat()));
  referee_.judge(InvariantKind::display, now, cab_.display_is_right(now, has_valves));
}

/// The wheel tells each change by more than its delta.
void ExcavatorReferees::look_at_throttle(Time now) {
  constexpr double apart_most = 2 * double{axis_delta} / full_scale;
  const double wanted = std::max(panel_->wheel(0), 0.0);
  referee_.judge(InvariantKind::throttle, now,
                 std::abs(machine_->throttle() - wanted) <= apart_most);
}

bool ExcavatorReferees::is_armrest_at_work(Time now) {
  if (!options_->has_armrest) return true;
  if (!options_->plays(armrest_id)) return referee_.armrest_silence(now) <= consumer_time;
  return devices_->node(armrest_id).is_powered();
}

/// The host must have received a position of each stick from one of the last steps.
void ExcavatorReferees::look_at_axes(Time now) {
  if (!options_->plays(host_id)) return;
  for (std::size_t i = 0; i < stick_count; ++i) {
    const auto stick = static_cast<Stick>(i);
    auto& places = axes_[i];
    std::shift_right(places.begin(), places.end(), 1);
    places[0] = panel_->stick(stick) * full_scale;
    // An axis without a position moves nothing.
    if (devices_->host().axis_value(stick) == broken_wire_reads) continue;
    double apart = INFINITY;
    for (const double place : places) {
      apart = std::min(apart, std::abs(place - devices_->host().axis_value(stick)));
    }
    referee_.compare(now, apart);
  }
}

std::vector<Invariant> ExcavatorReferees::take_broken() {
  std::vector<Invariant> broken;
  if (!referee_.has_news()) return broken;
  for (const Invariant& invariant : verdicts()) {
    bool& told = told_.at(static_cast<std::size_t>(invariant.kind));
    if (!invariant.held && !std::exchange(told, true)) broken.push_back(invariant);
  }
  return broken;
}

}  // namespace canvoy::excavator
