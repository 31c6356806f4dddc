// Between people, lamps and cars: what people do goes to the panels and plants of the shafts, and
// what these show goes to people and referees.
#include <algorithm>
#include <cmath>

#include "canvoy/sim/lift/lift_network_state.hpp"

namespace canvoy::lift {

namespace {

constexpr double standing_m_s = 0.001;
constexpr double level_tolerance_m = 0.012;

bool is_open(const LiftFacts& facts) {
  return std::any_of(facts.doors.begin(), facts.doors.end(),
                     [](const DoorFacts& door) { return door.open_m >= open_least_m; });
}

}  // namespace

PassengerHands LiftNetwork::State::hands() {
  return {
      .hall_button =
          [this](const HallButton& button, bool pressed) {
            press({.floor = button.floor, .direction = button.direction}, pressed, button.to);
          },
      .car_button =
          [this](const CarButton& button, bool pressed) {
            press({.lift = button.lift, .floor = button.floor}, pressed);
          },
      .destination_button =
          [this](const DestinationButton& button, bool pressed) {
            press({.floor = button.floor, .to = button.to}, pressed, button.to);
          },
      .door_open_button = [this](LiftNumber lift,
                                 bool pressed) { shaft(lift).press_door_open(pressed); },
      .doorway = [this](LiftNumber lift, DoorNumber door,
                        bool is_in_the_way) { shaft(lift).stand_in_door(door, is_in_the_way); },
      .carried = [this](LiftNumber lift) { fault_referee.serves(world.now(), lift); },
      .gave_up = [this](Time since) { gave_up(since); },
      .load = [this](LiftNumber lift, double mass_kg) { shaft(lift).set_load(mass_kg); },
  };
}

/// A landing has panels of all lifts: people press the one or the other, and let go of the same.
void LiftNetwork::State::press(const CallKey& call, bool pressed, FloorNumber to) {
  const Time now = world.now();
  if (call.lift != 0) {
    if (!shaft(call.lift).press(call, pressed) || !pressed) return;
    return referee.button_pressed(now, call,
                                  is_hindered(call.lift) || is_car_at(call.lift, call.floor));
  }
  if (!pressed) {
    const auto found = pressed_on.find(call);
    if (found != pressed_on.end()) shaft(found->second).press(call, false);
    return;
  }
  const LiftNumber lift = next_panel(call, to);
  pressed_on[call] = lift;
  if (!shaft(lift).press(call, true)) return;
  bool is_answered = is_anything_hindered();
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    is_answered = is_answered || is_car_at(static_cast<LiftNumber>(i), call.floor);
  }
  referee.button_pressed(now, call, is_answered);
}

/// One after the other, of the lifts that go where he wants to.
LiftNumber LiftNetwork::State::next_panel(const CallKey& call, FloorNumber to) {
  const Building& building = description.building;
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(1 + presses++ % shafts.size());
    const bool goes_there = to == no_floor || building.serves(lift, to);
    if (goes_there && building.serves(lift, call.floor)) return lift;
  }
  return static_cast<LiftNumber>(1 + presses++ % shafts.size());
}

void LiftNetwork::State::shaft_changed(LiftNumber lift) {
  const Time now = world.now();
  LiftFacts facts = shaft(lift).facts(now);
  facts.hindered = is_faulty(lift);
  facts.emergency_stop = facts.emergency_stop || facts.hindered;
  referee.observe(now, lift, facts);
  note_car(lift, facts);
  if (crowd == nullptr) return;
  crowd->car_changed(now, lift, shaft(lift).view(now));
  wake_crowd();
}

void LiftNetwork::State::note_car(LiftNumber lift, const LiftFacts& facts) {
  CarNote& car = cars[lift - std::size_t{1}];
  const Time now = world.now();
  const bool moves = std::abs(facts.speed_m_s) > standing_m_s;
  const FloorNumber floor = description.building.floor_near(facts.position_m, level_tolerance_m);
  if (moves && !car.moves) {
    ++car.starts;
    const auto persons = static_cast<unsigned>(crowd ? crowd->riding(lift).size() : 0);
    const FloorNumber left = description.building.floor_near(car.position_m, level_tolerance_m);
    events.push_back({now, CarStarted{lift, left, persons}});
    if (!facts.drifts) fault_referee.starts(now, lift);
  }
  if (!moves && car.moves) events.push_back({now, CarStopped{lift, floor}});
  if (!moves) fault_referee.stands(now, lift);
  const bool open = is_open(facts);
  if (open && !car.is_open) {
    events.push_back({now, DoorsOpened{lift, floor}});
    if (floor != no_floor) opened_at[lift - std::size_t{1}][floor - std::size_t{1}] = now;
  }
  car.moves = moves;
  car.is_open = open;
  car.position_m = facts.position_m;
}

void LiftNetwork::State::lamp_changed(LiftNumber lift, const CallKey& call, bool is_lit) {
  unsigned& on = lit[call];
  const bool was_lit = on != 0;
  const unsigned bit = 1U << (lift - 1U);
  on = is_lit ? on | bit : on & ~bit;
  const bool now_lit = on != 0;
  if (!now_lit) lit.erase(call);
  if (is_lit && serves_as_group()) fault_referee.serves(world.now(), 0);
  if (was_lit == now_lit) return;
  const CallEnd end = now_lit ? CallEnd::served : end_of(call);
  if (now_lit) lit_since[call] = world.now();
  referee.lamp_changed(world.now(), call, now_lit, end);
  events.push_back({world.now(), LampChanged{call, now_lit, end}});
  if (crowd == nullptr || call.to != no_floor) return;
  if (call.lift != 0) {
    crowd->car_lamp({call.lift, call.floor}, now_lit);
  } else {
    crowd->hall_lamp({call.floor, call.direction}, now_lit);
  }
}

/// Why a lamp goes out that has just gone out.
CallEnd LiftNetwork::State::end_of(const CallKey& call) const {
  bool is_fire = false;
  bool is_out = false;
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i);
    if (call.lift != 0 && call.lift != lift) continue;
    // A car that passes when all calls are taken back serves none of them.
    const bool passes = std::abs(shaft(lift).facts(world.now()).speed_m_s) > standing_m_s;
    if (is_car_at(lift, call.floor) && !(passes && is_hindered(lift))) return CallEnd::served;
    is_fire = is_fire || shaft(lift).facts(world.now()).fire != FireMode::none;
    is_out = is_out || is_hindered(lift);
  }
  if (is_fire) return CallEnd::fire_service;
  if (was_opened_for(call)) return CallEnd::served;
  return is_out ? CallEnd::out_of_order : CallEnd::unexplained;
}

/// A panel, or a group, that was not told at once that its call was answered is told later.
bool LiftNetwork::State::was_opened_for(const CallKey& call) const {
  const auto since = lit_since.find(call);
  if (since == lit_since.end()) return false;
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    const Time opened = opened_at[i - 1][call.floor - std::size_t{1}];
    const bool is_its = call.lift == 0 || call.lift == i;
    if (is_its && opened != never && opened >= since->second) return true;
  }
  return false;
}

bool LiftNetwork::State::is_car_at(LiftNumber lift, FloorNumber floor) const {
  const LiftFacts facts = shaft(lift).facts(world.now());
  const double distance_m = std::abs(facts.position_m - description.building.height_m(floor));
  return distance_m <= level_tolerance_m;
}

/// Once in a look_period: who waits for what for how long.
void LiftNetwork::State::look(Time now) {
  look_for_brigades(now);
  const bool hindered = is_anything_hindered();
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i);
    shaft_changed(lift);
  }
  fault_referee.passed(now, look_period, [this](LiftNumber lift) { return is_wanted(lift); });
  look_at_people(now, hindered);
  referee.look_at_calls(now, hindered);
  for (const Invariant& broken : referee.take_broken()) note(now, broken);
}

/// Time in which something hindered them is nobody's fault.
void LiftNetwork::State::look_at_people(Time now, bool hindered) {
  constexpr Duration saturated_after = 5min;
  if (hindered) hindered_last = now;
  double places = 0;
  for (const LiftDesign& lift : description.building.lifts) {
    places += lift.car.rated_persons * description.people.fill_share;
  }
  const bool is_crowded = static_cast<double>(crowd->waiting_count()) > 2 * places;
  if (hindered || !is_crowded) not_crowded_last = now;
  is_saturated = is_saturated || now - not_crowded_last >= saturated_after;
  referee.waited(crowd->longest_wait(now, hindered_last), hindered);
  referee.rode(crowd->longest_ride(now, hindered_last), hindered);
}

/// Who began to wait while something hindered people, or just after, finds a crowd before him: he
/// gives up because of it, however long his patience is.
void LiftNetwork::State::gave_up(Time since) {
  const bool was_hindered = is_anything_hindered() || hindered_last > since;
  if (!was_hindered && !fault_referee.excuses_waiting(since)) referee.gave_up();
}

/// Somebody rides in it, or waits where it should come. The lifts of a group share who waits.
bool LiftNetwork::State::is_wanted(LiftNumber lift) const {
  const bool is_waited_for = crowd->waiting_count() > 0;
  return is_waited_for || (lift != 0 && !crowd->riding(lift).empty());
}

void LiftNetwork::State::look_for_brigades(Time now) {
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    FireBrigade& brigade = *brigades[i - 1];
    if (!brigade.is_there()) continue;
    const auto lift = static_cast<LiftNumber>(i);
    const LiftFacts facts = shaft(lift).facts(now);
    const bool stands = std::abs(facts.speed_m_s) <= standing_m_s;
    const FloorNumber here = description.building.floor_near(facts.position_m, level_tolerance_m);
    brigade.look(now, {.floor = stands ? here : no_floor,
                       .is_open = shaft(lift).view(now).door == DoorView::open,
                       .is_empty = crowd->is_empty(lift)});
  }
}

/// The display of a destination terminal is its acknowledgement. All of a landing show it, and
/// people look at the one where they asked.
void LiftNetwork::State::assigned(LiftNumber panel, const DestinationButton& button,
                                  LiftNumber lift) {
  const CallKey call{.floor = button.floor, .to = button.to};
  referee.lamp_changed(world.now(), call, false);
  // The terminal of one lift names another one: they share the calls.
  if (lift != 0 && panel != lift) fault_referee.serves(world.now(), 0);
  const auto asked_at = pressed_on.find(call);
  const bool is_seen = asked_at == pressed_on.end() || asked_at->second == panel;
  if (crowd != nullptr && is_seen) crowd->assigned(button, lift);
}

void LiftNetwork::State::note(Time at, const Invariant& broken) {
  events.push_back({at, InvariantBroken{broken}});
}

}  // namespace canvoy::lift
