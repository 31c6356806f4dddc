#include "canvoy/worlds/lift/referee.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/sim/duration_text.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

/// Two accelerations that are sampled in short succession give no reliable jerk.
constexpr Duration jerk_interval_least = 5ms;

bool is_any_door_free(const LiftFacts& facts) {
  return std::any_of(facts.doors.begin(), facts.doors.end(), [](const DoorFacts& door) {
    return door.open_m >= open_least_m || !door.locked;
  });
}
bool is_any_door_open(const LiftFacts& facts) {
  return std::any_of(facts.doors.begin(), facts.doors.end(),
                     [](const DoorFacts& door) { return door.open_m >= open_least_m; });
}

}  // namespace

Referee::Referee(const Building& building, const RefereeLimits& limits)
    : building_(&building), limits_(limits), lifts_(building.lifts.size()) {
  for (std::size_t i = 0; i < lifts_.size(); ++i) {
    const LiftDesign& design = building.lifts[i];
    auto& judged = lifts_[i].judged;
    const double share = 1 + limits.tolerance;
    judged[InvariantKind::closed_while_moving].bound = 0;
    judged[InvariantKind::opens_at_floor].bound = limits.floor_tolerance_m * 1000;
    judged[InvariantKind::no_overload].bound = design.car.rated_load_kg * design.car.overload_share;
    judged[InvariantKind::speed].bound = design.speed_m_s * share;
    judged[InvariantKind::acceleration].bound = design.acceleration_m_s2 * share;
    judged[InvariantKind::jerk].bound = design.jerk_m_s3 * share;
    judged[InvariantKind::travel].bound = design.overtravel_m - limits.buffer_gap_m;
    judged[InvariantKind::chain_stops].bound = 0;
    judged[InvariantKind::levelled].bound = limits.levelled_m * 1000;
    judged[InvariantKind::lift_serves].bound = in_seconds(limits.idle_most);
    judged[InvariantKind::nobody_trapped].bound = in_seconds(limits.trapped_most);
    judged[InvariantKind::rescued].bound = in_seconds(limits.rescued_within);
  }
  common_[InvariantKind::call_acknowledged].bound = in_seconds(limits.acknowledge_most);
  common_[InvariantKind::call_served].bound = in_seconds(limits.serve_most);
  common_[InvariantKind::no_call_lost].bound = 0;
  common_[InvariantKind::no_endless_wait].bound = in_seconds(limits.wait_most);
  common_[InvariantKind::no_endless_ride].bound = in_seconds(limits.ride_most);
  common_[InvariantKind::nobody_gives_up].bound = 0;
}

void Referee::observe(Time now, LiftNumber number, const LiftFacts& facts) {
  Lift& lift = lifts_.at(number - std::size_t{1});
  const LiftDesign& design = building_->lift(number);
  const Duration passed = lift.last ? now - lift.last_at : Duration{0};
  judge_motion(lift, design, facts, passed);
  judge_chain(lift, facts, passed);
  judge_doors(lift, design, facts, passed);
  judge_level(lift, design, facts, passed);
  note_open_door(now, number, design, facts);
  judge_departure(lift, design, facts);
  judge_fire(now, lift, facts);
  judge_inspection(now, lift, facts, passed);
  judge_displays(now, lift, facts);
  if (facts.position_lie_m) {
    Judged& told = lift.judged[InvariantKind::real_position];
    told.bound = limits_.position_lie_m * 1000;
    told.judge(*facts.position_lie_m * 1000);
  }
  lift.last = facts;
  lift.last_at = now;
}

void Referee::judge_motion(Lift& lift, const LiftDesign& design, const LiftFacts& facts,
                           Duration passed) {
  const double speed = std::abs(facts.speed_m_s);
  if (facts.emergency_stop) {
    // A speed from before it is no fault of the stop; the governor's limit holds all the same.
    lift.judged[InvariantKind::speed].judge(speed * (1 + limits_.tolerance) /
                                            limits_.emergency_speed);
    const double share = design.acceleration_m_s2 / limits_.emergency_m_s2;
    lift.judged[InvariantKind::acceleration].judge(std::abs(facts.acceleration_m_s2) * share);
  } else {
    lift.judged[InvariantKind::speed].judge(speed);
    lift.judged[InvariantKind::acceleration].judge(std::abs(facts.acceleration_m_s2));
  }
  const double above = facts.position_m - building_->top_m();
  const double below = building_->height_m(1) - facts.position_m;
  const double beyond = std::max({above, below, 0.0});
  // It may stand in a buffer until it is moved.
  lift.was_unheld = facts.is_unheld || (lift.was_unheld && beyond > 0);
  if (!lift.was_unheld) lift.judged[InvariantKind::travel].judge(beyond);
  if (!lift.last || passed < jerk_interval_least) return;
  if (facts.emergency_stop || lift.last->emergency_stop) return;
  const double change = facts.acceleration_m_s2 - lift.last->acceleration_m_s2;
  lift.judged[InvariantKind::jerk].judge(std::abs(change) / in_seconds(passed));
}

/// It stops a car where something is wrong, and then a fault is declared.
void Referee::judge_chain(Lift& lift, const LiftFacts& facts, Duration passed) {
  const bool was_cut = lift.last && lift.last->is_cut;
  const bool moves = std::abs(facts.speed_m_s) > limits_.moving_m_s;
  // From standstill only a fault can move it: that begins again.
  const bool is_on = facts.is_cut && was_cut && (moves || !facts.hindered);
  lift.cut_for = is_on ? lift.cut_for + passed : Duration{0};
  if (facts.is_cut && !was_cut && moves && !facts.hindered) ++lift.chain_stops;
  judge_stop_on_the_way(lift, facts, passed);
  lift.judged[InvariantKind::chain_stops].judge(lift.chain_stops);
}

/// A controller may stop a car at any place, but then it declares why. People who drive the car, by
/// a key, in an inspection or by hand, stop it where they like.
void Referee::judge_stop_on_the_way(Lift& lift, const LiftFacts& facts, Duration passed) {
  const bool is_driven = facts.is_inspected || facts.is_cranked || facts.fire != FireMode::none;
  const bool stands = std::abs(facts.speed_m_s) <= limits_.moving_m_s;
  const bool is_between = distance_to_floor_m(facts.position_m) > limits_.between_floors_m;
  if (!stands || !is_between || is_driven || facts.hindered) {
    lift.is_excused_between = stands && is_between && lift.between_for == Duration{0};
    lift.between_for = Duration{0};
    return;
  }
  if (lift.is_excused_between) return;
  const bool had_stopped = lift.between_for >= limits_.stops_between_least;
  lift.between_for += passed;
  if (!had_stopped && lift.between_for >= limits_.stops_between_least) ++lift.chain_stops;
}

/// People step in and out: the sinking of the car under them is corrected while they do.
void Referee::judge_level(Lift& lift, const LiftDesign& design, const LiftFacts& facts,
                          Duration passed) {
  const double distance_m = distance_to_floor_m(facts.position_m);
  const bool is_judged =
      is_any_door_open(facts) && distance_m <= design.door_zone_m && !facts.hindered;
  const bool is_off = is_judged && distance_m > limits_.levelled_m;
  lift.off_for = is_off ? lift.off_for + passed : Duration{0};
  if (!is_judged) return;
  const bool lasts = lift.off_for > limits_.levels_within;
  lift.judged[InvariantKind::levelled].judge(
      (lasts ? distance_m : std::min(distance_m, limits_.levelled_m)) * 1000);
}

void Referee::judge_doors(Lift& lift, const LiftDesign& design, const LiftFacts& facts,
                          Duration passed) {
  const double distance_m = distance_to_floor_m(facts.position_m);
  const bool moves = std::abs(facts.speed_m_s) > limits_.moving_m_s;
  // The safety chain opens with the lock, and a car does not stop at once.
  const Duration stops_within = facts.is_unheld ? limits_.gear_stop_most : limits_.cut_stop_most;
  const bool is_stopping = facts.is_cut && lift.cut_for <= stops_within;
  if (moves && is_any_door_free(facts) && distance_m > design.door_zone_m && !is_stopping) {
    // The first look counts, however short the time was.
    lift.open_movement += std::max(passed, Duration{1});
  }
  lift.judged[InvariantKind::closed_while_moving].judge(in_seconds(lift.open_movement));
  // A door that was commanded to open while the car stood, and the brake does not hold it.
  const bool drifts = moves && facts.hindered;
  if (opening_doors(lift, facts) != 0 && !drifts) {
    lift.judged[InvariantKind::opens_at_floor].judge(distance_m * 1000);
  }
}

/// Bit 0 is door 1.
unsigned Referee::opening_doors(const Lift& lift, const LiftFacts& facts) {
  unsigned opening = 0;
  for (std::size_t i = 0; i < facts.doors.size(); ++i) {
    const bool was_open = lift.last && lift.last->doors.at(i).open_m >= open_least_m;
    if (!was_open && facts.doors.at(i).open_m >= open_least_m) opening |= 1U << i;
  }
  return opening;
}

/// People who have called there can get in, or out.
void Referee::note_open_door(Time now, LiftNumber number, const LiftDesign& design,
                             const LiftFacts& facts) {
  Lift& lift = lifts_.at(number - std::size_t{1});
  const double wide_m = limits_.walkable_share * design.door.width_m;
  const bool is_wide = std::ranges::any_of(
      facts.doors, [wide_m](const DoorFacts& door) { return door.open_m >= wide_m; });
  const bool stands = std::abs(facts.speed_m_s) <= limits_.moving_m_s;
  const FloorNumber before = lift.open_floor;
  lift.open_floor = no_floor;
  if (is_wide && stands) {
    lift.open_floor = building_->floor_near(facts.position_m, limits_.floor_tolerance_m);
  }
  if (lift.open_floor == no_floor || lift.open_floor == before) return;
  for (auto& [key, call] : calls_) {
    const bool is_its = key.lift == 0 || key.lift == number;
    if (!is_its || key.floor != lift.open_floor) continue;
    call.was_open = true;
    if (call.opens_by == never) continue;
    common_[InvariantKind::call_served].judge(in_seconds(now - call.asked_at));
    call.asked_at = call.opens_by = never;
  }
}

/// Its lamp went out for a car: where no door opens, the call was lost.
void Referee::look_for_door(Time now, Call& call, bool hindered) {
  if (call.opens_by == never) return;
  if (hindered) {
    call.asked_at = call.opens_by = never;  // it may have been withdrawn
  } else if (now > call.opens_by) {
    Judged& lost = common_[InvariantKind::no_call_lost];
    lost.judge(lost.worst + 1);
    call.asked_at = call.opens_by = never;
  }
}

void Referee::judge_departure(Lift& lift, const LiftDesign& design, const LiftFacts& facts) {
  if (!lift.last) return;
  const bool was_at_floor = distance_to_floor_m(lift.last->position_m) <= design.door_zone_m;
  const bool is_at_floor = distance_to_floor_m(facts.position_m) <= design.door_zone_m;
  const bool leaves = was_at_floor && !is_at_floor;
  if (leaves) lift.judged[InvariantKind::no_overload].judge(facts.load_kg);
  judge_brake(lift, facts, leaves);
}

/// A self-test finds it at the next stop, and the lift does not leave again.
void Referee::judge_brake(Lift& lift, const LiftFacts& facts, bool leaves) const {
  if (!facts.brake_slips) {
    lift.weak_trips = 0;
    lift.has_stood = false;
    return;
  }
  if (std::abs(facts.speed_m_s) <= limits_.moving_m_s) lift.has_stood = true;
  const bool is_driven = !facts.drifts && !facts.is_cranked && !facts.is_unheld;
  if (leaves && is_driven && std::exchange(lift.has_stood, false)) ++lift.weak_trips;
  Judged& trips = lift.judged[InvariantKind::weak_brake];
  trips.bound = limits_.weak_brake_trips;
  trips.judge(lift.weak_trips);
}

/// By a hand alone, and slowly.
void Referee::judge_inspection(Time now, Lift& lift, const LiftFacts& facts,
                               Duration passed) const {
  if (!facts.is_inspected) {
    lift.inspected_since = never;
    return;
  }
  const bool is_new = !lift.last || !lift.last->is_inspected;
  if (is_new || lift.last->inspection_way != facts.inspection_way) lift.inspected_since = now;
  const bool is_driven = !facts.is_unheld && !facts.is_cut && !facts.is_cranked;
  const bool moves = is_driven && std::abs(facts.speed_m_s) > limits_.moving_m_s;
  const bool is_up = facts.speed_m_s > 0;
  const bool is_asked = facts.inspection_way == (is_up ? Direction::up : Direction::down);
  lift.rests = moves ? Duration{0} : lift.rests + passed;
  if (moves && !is_asked) lift.unasked += passed;
  if ((moves && is_asked) || lift.rests >= limits_.inspection_rests) lift.unasked = Duration{0};
  Judged& unasked = lift.judged[InvariantKind::inspection_buttons];
  unasked.bound = in_seconds(limits_.inspection_stops_within);
  unasked.judge(in_seconds(lift.unasked));
  if (!moves || now - lift.inspected_since < limits_.inspection_stops_within) return;
  Judged& speed = lift.judged[InvariantKind::inspection_speed];
  speed.bound = limits_.inspection_m_s + limits_.moving_m_s;
  speed.judge(std::abs(facts.speed_m_s));
}

/// While the car stands at a floor. What a display did not hear during a fault it hears when the
/// car goes on.
void Referee::judge_displays(Time now, Lift& lift, const LiftFacts& facts) const {
  const bool stands = std::abs(facts.speed_m_s) <= limits_.moving_m_s;
  if (!stands) lift.is_display_old = facts.hindered;
  if (facts.hindered) lift.is_display_old = true;
  if (!stands || !facts.misnamed_since) {
    lift.stands_since = never;
    return;
  }
  if (lift.stands_since == never) lift.stands_since = now;
  if (lift.is_display_old) return;
  const Time since = std::max(*facts.misnamed_since, lift.stands_since);
  Judged& shown = lift.judged[InvariantKind::shown_floor];
  shown.bound = in_seconds(limits_.display_most);
  shown.judge(*facts.misnamed_since == never ? 0 : in_seconds(now - since));
}

/// Its lamp is lit: a lift has accepted it.
void Referee::judge_call_in_inspection(Time now, const CallKey& call) {
  if (call.lift == 0) return;
  Lift& lift = lifts_.at(call.lift - std::size_t{1});
  if (!lift.last || !lift.last->is_inspected) return;
  if (now - lift.inspected_since >= limits_.heeds_key_within) ++lift.calls_in_inspection;
  Judged& calls = lift.judged[InvariantKind::inspection_calls];
  calls.bound = 0;
  calls.judge(lift.calls_in_inspection);
}

/// A door that was unlocked before the key was turned had its command to open before.
void Referee::note_fire_mode(Time now, Lift& lift, const LiftFacts& facts) {
  if (!lift.last || lift.last->fire != facts.fire) lift.fire_since = now;
  unsigned unlocked = 0;
  for (std::size_t i = 0; i < facts.doors.size(); ++i) {
    if (!facts.doors.at(i).locked) unlocked |= 1U << i;
  }
  const bool is_new = now - lift.fire_since < limits_.heeds_key_within;
  lift.doors_freed_before = is_new ? unlocked : lift.doors_freed_before & unlocked;
}

void Referee::judge_fire(Time now, Lift& lift, const LiftFacts& facts) {
  note_fire_mode(now, lift, facts);
  const unsigned opening = opening_doors(lift, facts) & ~lift.doors_freed_before;
  const bool opens = opening != 0 && !facts.hindered;
  if (facts.is_inspected) {
    // Inspection control neutralises a recall, and ends a return (EN 81-20, 5.12.1.5.2.1).
    lift.recall_since = never;
    lift.is_returning = false;
  } else if (facts.fire == FireMode::brigade) {
    lift.recall_since = never;
    lift.is_returning = true;
    if (opens && !facts.opens_by_hand) ++lift.doors_opened_by_themselves;
    lift.judged[InvariantKind::fire_buttons].judge(lift.doors_opened_by_themselves);
  } else if (facts.fire == FireMode::recall || lift.is_returning) {
    judge_recall(now, lift, facts, opens);
  } else {
    lift.recall_since = never;
  }
}

/// By an alarm, or because the brigade has left it: to the fire floor, and to no other one.
void Referee::judge_recall(Time now, Lift& lift, const LiftFacts& facts, bool opens) {
  if (lift.recall_since == never) {
    lift.recall_since = now;
    lift.is_recalled = false;
  }
  const bool is_there =
      building_->floor_near(facts.position_m, limits_.floor_tolerance_m) == facts.fire_floor;
  if (opens && !is_there) ++lift.doors_opened_in_recall;
  lift.judged[InvariantKind::fire_doors].judge(lift.doors_opened_in_recall);
  // A car that was there already when the keys were turned back need not open.
  const bool stands = std::abs(facts.speed_m_s) <= limits_.moving_m_s;
  if (facts.fire == FireMode::none && is_there && stands) lift.is_returning = false;
  if (lift.is_recalled) return;
  if (facts.hindered) lift.recall_since = now;
  Judged& recall = lift.judged[InvariantKind::fire_recall];
  recall.bound = in_seconds(limits_.recall_most);
  recall.judge(in_seconds(now - lift.recall_since));
  lift.is_recalled = is_there && is_any_door_open(facts);
}

/// In a recall no call is accepted; while the brigade drives, only those of the car.
bool Referee::refuses(Time now, const Lift& lift, const CallKey& call) const {
  if (!lift.last || lift.last->hindered || lift.last->fire == FireMode::none) return false;
  if (now - lift.fire_since < limits_.heeds_key_within) return false;
  return call.lift == 0 || lift.last->fire == FireMode::recall;
}

/// Its lamp is lit: a lift has accepted it.
void Referee::judge_fire_call(Time now, const CallKey& call) {
  const auto refuse = [&](const Lift& lift) { return refuses(now, lift, call); };
  if (call.lift == 0) {
    if (!std::all_of(lifts_.begin(), lifts_.end(), refuse)) return;
    for (Lift& lift : lifts_) lift.judged[InvariantKind::fire_calls].judge(++lift.calls_taken);
    return;
  }
  Lift& lift = lifts_.at(call.lift - std::size_t{1});
  if (!lift.last || lift.last->fire == FireMode::none) return;
  if (refuse(lift)) ++lift.calls_taken;
  lift.judged[InvariantKind::fire_calls].judge(lift.calls_taken);
}

double Referee::distance_to_floor_m(double position_m) const {
  double least = std::abs(position_m - building_->floors.front().height_m);
  for (const Floor& floor : building_->floors) {
    least = std::min(least, std::abs(position_m - floor.height_m));
  }
  return least;
}

void Referee::button_pressed(Time now, const CallKey& call, bool is_answered) {
  Call& pressed = calls_[call];
  if (is_answered || pressed.lit_at != never || pressed.pressed_at != never) return;
  pressed.pressed_at = now;
}

void Referee::lamp_changed(Time now, const CallKey& key, bool lit, CallEnd end) {
  Call& call = calls_[key];
  if (call.pressed_at != never) {
    common_[InvariantKind::call_acknowledged].judge(in_seconds(now - call.pressed_at));
  }
  call.pressed_at = never;
  if (lit) {
    if (call.lit_at == never) {
      call.lit_at = now;
      call.was_open = false;
    }
    judge_fire_call(now, key);
    judge_call_in_inspection(now, key);
    return;
  }
  if (call.lit_at == never) return;
  if (end == CallEnd::served) {
    const bool is_open =
        call.was_open || std::ranges::any_of(lifts_, [&](const Lift& lift) {
          const auto number = static_cast<LiftNumber>(&lift - lifts_.data() + 1);
          return lift.open_floor == key.floor && (key.lift == 0 || key.lift == number);
        });
    if (call.opens_by == never) call.asked_at = call.lit_at;
    if (is_open) {
      common_[InvariantKind::call_served].judge(in_seconds(now - call.asked_at));
      call.asked_at = call.opens_by = never;
    } else if (call.opens_by == never) {
      call.opens_by = now + limits_.opens_within;
    }
  }
  Judged& lost = common_[InvariantKind::no_call_lost];
  lost.judge(lost.worst + (end == CallEnd::unexplained ? 1 : 0));
  call.lit_at = never;
}

void Referee::waited(Duration longest, bool hindered) {
  if (!hindered) common_[InvariantKind::no_endless_wait].judge(in_seconds(longest));
}

void Referee::rode(Duration longest, bool hindered) {
  if (!hindered) common_[InvariantKind::no_endless_ride].judge(in_seconds(longest));
}

void Referee::idled(LiftNumber lift, Duration time) {
  lifts_.at(lift - std::size_t{1}).judged[InvariantKind::lift_serves].judge(in_seconds(time));
}

void Referee::trapped(LiftNumber lift, Duration time) {
  lifts_.at(lift - std::size_t{1}).judged[InvariantKind::nobody_trapped].judge(in_seconds(time));
}

void Referee::shut_in(LiftNumber lift, Duration time) {
  lifts_.at(lift - std::size_t{1}).judged[InvariantKind::rescued].judge(in_seconds(time));
}

/// A building may be higher than one of a firefighters lift (EN 81-72: 60 s to the last floor).
void Referee::brigade_waits(LiftNumber number, Duration time) {
  const LiftDesign& design = building_->lift(number);
  const Flight flight{design.speed_m_s, design.acceleration_m_s2, design.jerk_m_s3};
  Judged& ride = lifts_.at(number - std::size_t{1}).judged[InvariantKind::fire_ride];
  ride.bound = std::max(in_seconds(limits_.brigade_waits_most),
                        20 + flight_time_s(flight, building_->top_m()));
  ride.judge(in_seconds(time));
}

void Referee::stayed() {
  Judged& people = common_[InvariantKind::nobody_gives_up];
  people.judge(people.worst);
}

void Referee::gave_up() {
  Judged& people = common_[InvariantKind::nobody_gives_up];
  people.judge(people.worst + 1);
}

/// While they are hindered, the time of calls does not run.
void Referee::look_at_calls(Time now, bool hindered) {
  for (auto& [key, call] : calls_) {
    look_for_door(now, call, hindered);
    if (hindered) {
      if (call.pressed_at != never) call.pressed_at = now;
      if (call.lit_at != never) call.lit_at = now;
      continue;
    }
    if (call.pressed_at != never) {
      common_[InvariantKind::call_acknowledged].judge(in_seconds(now - call.pressed_at));
    }
    if (call.lit_at != never) {
      common_[InvariantKind::call_served].judge(in_seconds(now - call.lit_at));
    }
  }
}

template <class Visit>
void Referee::visit_all(const Visit& visit) {
  for (std::size_t i = 0; i < lifts_.size(); ++i) {
    for (auto& [kind, judged] : lifts_[i].judged)
      visit(kind, static_cast<LiftNumber>(i + 1), judged);
  }
  for (auto& [kind, judged] : common_) visit(kind, LiftNumber{0}, judged);
}

namespace {

template <class Judged>
Invariant invariant_of(InvariantKind kind, LiftNumber lift, const Judged& judged) {
  return {.kind = kind,
          .part = lift,
          .worst = judged.worst,
          .allowed = judged.bound,
          .held = judged.held(),
          .judged = judged.count};
}

}  // namespace

std::vector<Invariant> Referee::invariants() const {
  std::vector<Invariant> all;
  for (std::size_t i = 0; i < lifts_.size(); ++i) {
    for (const auto& [kind, judged] : lifts_[i].judged) {
      all.push_back(invariant_of(kind, static_cast<LiftNumber>(i + 1), judged));
    }
  }
  for (const auto& [kind, judged] : common_) all.push_back(invariant_of(kind, 0, judged));
  return all;
}

std::vector<Invariant> Referee::take_broken() {
  std::vector<Invariant> broken;
  visit_all([&](InvariantKind kind, LiftNumber lift, Judged& judged) {
    if (judged.held() || judged.is_told) return;
    judged.is_told = true;
    broken.push_back(invariant_of(kind, lift, judged));
  });
  return broken;
}

}  // namespace canvoy::lift
