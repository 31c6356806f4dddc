#include "canvoy/worlds/lift/lift_referees.hpp"

#include <algorithm>

#include "canvoy/worlds/lift/fault_consequences.hpp"

namespace canvoy::lift {

namespace {

/// A controller that receives a wrong position may stop its car by any means.
constexpr Duration stops_after_lie_within = 10s;

/// True for what people see a lift do, or not do.
constexpr bool needs_technician(InvariantKind kind) {
  switch (kind) {
    case InvariantKind::closed_while_moving:
    case InvariantKind::opens_at_floor:
    case InvariantKind::levelled:
    case InvariantKind::chain_stops:
    case InvariantKind::travel:
    case InvariantKind::lift_serves:
    case InvariantKind::nobody_trapped:
    case InvariantKind::weak_brake:
      return true;
    default:
      return false;
  }
}

}  // namespace

LiftReferees::LiftReferees(const LiftNetworkDescription& description, const LiftDevices& devices,
                           std::vector<LiftEvent>& events)
    : description_(&description),
      devices_(&devices),
      events_(&events),
      referee_(description.building),
      cars_(description.building, events),
      crowd_(description.building, description.people),
      service_(description.building),
      misled_until_(description.building.lifts.size()),
      has_technician_(description.building.lifts.size()),
      brigade_excused_at_(description.building.lifts.size()) {}

void LiftReferees::car_changed(Time now, LiftNumber lift, unsigned persons) {
  LiftFacts is = facts(now, lift);
  // A car of which a technician has pressed the stop switch does not level itself.
  const bool has_technician = has_technician_[lift - std::size_t{1}];
  is.hindered = fault_referee_.is_faulty(now, lift) || is_misled(now, lift, is) || has_technician;
  is.emergency_stop = is.emergency_stop || is.hindered;
  referee_.observe(now, lift, is);
  const CarWatch::Seen seen = cars_.look(now, lift, is, persons);
  if (seen.starts && !is.drifts && !is.is_cranked) fault_referee_.starts(now, lift);
  if (seen.stands) fault_referee_.stands(now, lift);
}

bool LiftReferees::is_misled(Time now, LiftNumber lift, const LiftFacts& facts) {
  Time& until = misled_until_[lift - std::size_t{1}];
  if (facts.position_lie_m.value_or(0) > RefereeLimits{}.position_lie_m)
    until = now + stops_after_lie_within;
  return now < until;
}

CallLamps::Change LiftReferees::lamp_changed(Time now, LiftNumber lift, const CallKey& call,
                                             bool is_lit) {
  const CallLamps::Change change = lamps_.set(now, lift, call, is_lit);
  if (is_lit && lamps_.are_shared()) fault_referee_.serves(now, 0);
  if (change == CallLamps::Change::none) return change;
  const bool now_lit = change == CallLamps::Change::lit;
  const CallEnd end = now_lit ? CallEnd::served : end_of(now, call);
  referee_.lamp_changed(now, call, now_lit, end);
  events_->push_back({now, LampChanged{call, now_lit, end}});
  return change;
}

void LiftReferees::assigned(Time now, LiftNumber panel, const DestinationButton& button,
                            LiftNumber lift) {
  referee_.lamp_changed(now, {.floor = button.floor, .to = button.to}, false);
  // The terminal of one lift names another one: they share the calls.
  if (lift != 0 && panel != lift) fault_referee_.serves(now, 0);
}

void LiftReferees::pressed(Time now, const CallKey& call) {
  const bool is_of_car = call.lift != 0;
  bool is_answered = is_of_car ? is_out_of_use(now, call.lift) : is_anything_hindered(now);
  for (LiftNumber lift = 1; lift <= devices_->count() && !is_answered; ++lift) {
    const bool is_its = !is_of_car || call.lift == lift;
    is_answered = is_its && (is_at(now, lift, call.floor) || is_out_of_use(now, lift));
  }
  referee_.button_pressed(now, call, is_answered);
}

/// Beside a fault it is no judgement of those who give up: they would be excused.
void LiftReferees::carried(Time now, LiftNumber lift) {
  fault_referee_.serves(now, lift);
  if (!is_anything_hindered(now)) referee_.stayed();
}

/// A passenger who began to wait while a fault hindered people, or just after it, stands behind a
/// crowd: the fault is the reason to give up, however long the passenger waits.
void LiftReferees::gave_up(Time now, Time since) {
  const bool was_hindered = is_anything_hindered(now) || crowd_.excused_at() > since;
  if (!was_hindered && !fault_referee_.excuses_waiting(since)) referee_.gave_up();
}

void LiftReferees::emergency_seen(Time now, const EmergencySeen& told) {
  fault_referee_.emergency_seen(now, devices_->lift_of(told.bus), told.code);
}

void LiftReferees::look(Time now, const LiftPeople& people, bool is_hindered) {
  fault_referee_.passed(now, look_period,
                        [&people](LiftNumber lift) { return people.is_wanted(lift); });
  const Crowd& crowd = people.crowd();
  crowd_.look(now, is_hindered, crowd);
  referee_.waited(crowd.longest_wait(now, crowd_.hindered_at()), is_hindered);
  referee_.rode(crowd.longest_ride(now, crowd_.hindered_at()), is_hindered);
  referee_.look_at_calls(now, is_hindered);
  look_at_service(now, crowd);
  look_at_brigades(now, people);
  for (const Invariant& broken : referee_.take_broken()) {
    events_->push_back({now, InvariantBroken{broken}});
    if (broken.part != 0 && needs_technician(broken.kind)) {
      complaints_.push_back(static_cast<LiftNumber>(broken.part));
    }
  }
}

/// For each lift separately: a hindrance of another one is no excuse.
void LiftReferees::look_at_service(Time now, const Crowd& crowd) {
  for (LiftNumber lift = 1; lift <= devices_->count(); ++lift) {
    const bool is_excused = is_out_of_use(now, lift) || is_hindered(now, 0);
    service_.look(now, lift, facts(now, lift), is_excused, crowd);
    if (service_.was_wanted(lift)) referee_.idled(lift, service_.idle(lift));
    if (service_.has_riders(lift)) referee_.trapped(lift, service_.trapped(lift));
    if (service_.has_people(lift)) referee_.shut_in(lift, service_.shut_in(lift));
  }
}

/// A second fault is no disobedience of the lift.
void LiftReferees::look_at_brigades(Time now, const LiftPeople& people) {
  for (LiftNumber lift = 1; lift <= devices_->count(); ++lift) {
    Time& excused_at = brigade_excused_at_[lift - std::size_t{1}];
    if (fault_referee_.is_faulty(now, lift)) excused_at = now;
    const Duration waits = std::min(people.brigade_waits(lift), now - excused_at);
    if (waits != Duration{0}) referee_.brigade_waits(lift, waits);
  }
}

/// Reason why a lamp goes out.
CallEnd LiftReferees::end_of(Time now, const CallKey& call) const {
  bool is_fire = false;
  bool is_out = false;
  for (LiftNumber lift = 1; lift <= devices_->count(); ++lift) {
    if (call.lift != 0 && call.lift != lift) continue;
    const LiftFacts is = facts(now, lift);
    const bool is_here = is_car_at(description_->building, is, call.floor);
    // A car that passes when all calls are withdrawn serves none of them.
    const bool is_hindered_here = is_out_of_use(now, lift);
    if (is_here && (stands(is) || !is_hindered_here)) return CallEnd::served;
    is_fire = is_fire || is.fire != FireMode::none;
    is_out = is_out || is_hindered_here;
  }
  if (is_fire) return CallEnd::fire_service;
  if (was_opened_for(call)) return CallEnd::served;
  return is_out ? CallEnd::out_of_order : CallEnd::unexplained;
}

/// A panel, or a group, that did not receive at once that its call was answered receives it later.
bool LiftReferees::was_opened_for(const CallKey& call) const {
  const Time since = lamps_.lit_at(call);
  if (since == never) return false;
  for (LiftNumber lift = 1; lift <= devices_->count(); ++lift) {
    const bool is_its = call.lift == 0 || call.lift == lift;
    if (is_its && cars_.has_opened_since(since, lift, call.floor)) return true;
  }
  return false;
}

bool LiftReferees::is_at(Time now, LiftNumber lift, FloorNumber floor) const {
  return is_car_at(description_->building, facts(now, lift), floor);
}

/// For a lift; 0: the group.
bool LiftReferees::is_hindered(Time now, LiftNumber lift) const {
  if (fault_referee_.is_hindered(now, lift)) return true;
  // A hand on a real key is no fault of the plan.
  const Time until = lift == 0 ? Time{} : devices_->shaft(lift).in_real_service_until(now);
  return until != Time{} && now - until < serves_most(*description_, lift);
}

/// Waits run on while a technician is at a lift.
bool LiftReferees::is_out_of_use(Time now, LiftNumber lift) const {
  return has_technician_[lift - std::size_t{1}] || is_hindered(now, lift);
}

bool LiftReferees::is_anything_hindered(Time now) const {
  for (LiftNumber lift = 0; lift <= devices_->count(); ++lift) {
    if (is_hindered(now, lift)) return true;
  }
  return false;
}

std::vector<Invariant> LiftReferees::invariants(Time now) const {
  std::vector<Invariant> all = referee_.invariants();
  const std::vector<Invariant> of_faults = fault_referee_.invariants(now);
  all.insert(all.end(), of_faults.begin(), of_faults.end());
  return all;
}

}  // namespace canvoy::lift
