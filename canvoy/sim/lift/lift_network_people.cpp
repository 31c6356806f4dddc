// Between people, lamps and cars: what people do goes to the panels and plants of the shafts, and
// what these show goes to people and referees.
#include <algorithm>
#include <cmath>

#include "canvoy/sim/lift/lift_network_state.hpp"

namespace canvoy::lift {

namespace {

constexpr double standing_m_s = 0.001;
constexpr double floor_tolerance_m = 0.012;
constexpr double open_least_m = 0.001;

bool is_open(const LiftFacts& facts) {
  return std::any_of(facts.doors.begin(), facts.doors.end(),
                     [](const DoorFacts& door) { return door.open_m >= open_least_m; });
}

}  // namespace

PassengerHands LiftNetwork::State::hands() {
  return {
      .hall_button =
          [this](const HallButton& button, bool pressed) {
            press({.floor = button.floor, .direction = button.direction}, pressed);
          },
      .car_button =
          [this](const CarButton& button, bool pressed) {
            press({.lift = button.lift, .floor = button.floor}, pressed);
          },
      .destination_button =
          [this](const DestinationButton& button, bool pressed) {
            press({.floor = button.floor, .to = button.to}, pressed);
          },
      .door_open_button = [this](LiftNumber lift,
                                 bool pressed) { shaft(lift).press_door_open(pressed); },
      .doorway = [this](LiftNumber lift, DoorNumber door,
                        bool is_in_the_way) { shaft(lift).stand_in_door(door, is_in_the_way); },
      .load = [this](LiftNumber lift, double mass_kg) { shaft(lift).set_load(mass_kg); },
  };
}

/// A landing has panels of all lifts: people press the one or the other, and let go of the same.
void LiftNetwork::State::press(const CallKey& call, bool pressed) {
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
  const auto lift = static_cast<LiftNumber>(1 + presses++ % shafts.size());
  pressed_on[call] = lift;
  if (!shaft(lift).press(call, true)) return;
  bool is_answered = is_anything_hindered();
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    is_answered = is_answered || is_car_at(static_cast<LiftNumber>(i), call.floor);
  }
  referee.button_pressed(now, call, is_answered);
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
  const FloorNumber floor = description.building.floor_near(facts.position_m, floor_tolerance_m);
  if (moves && !car.moves) {
    ++car.starts;
    const auto persons = static_cast<unsigned>(crowd ? crowd->riding(lift).size() : 0);
    const FloorNumber left = description.building.floor_near(car.position_m, floor_tolerance_m);
    events.push_back({now, CarStarted{lift, left, persons}});
    fault_referee.starts(now, lift);
  }
  if (!moves && car.moves) events.push_back({now, CarStopped{lift, floor}});
  if (!moves) fault_referee.stands(now, lift);
  const bool open = is_open(facts);
  if (open && !car.is_open) {
    events.push_back({now, DoorsOpened{lift, floor}});
    if (floor != no_floor) opened_at[floor - std::size_t{1}] = now;
    if (shaft(lift).snapshot(now).mode == LiftMode::normal) fault_referee.serves(now, lift);
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
    if (is_car_at(lift, call.floor)) return CallEnd::served;
    is_fire = is_fire || shaft(lift).facts(world.now()).fire != FireMode::none;
    const LiftMode mode = shaft(lift).snapshot(world.now()).mode;
    is_out = is_out || is_hindered(lift) || mode == LiftMode::out_of_order ||
             mode == LiftMode::starting || mode == LiftMode::fault;
  }
  if (is_fire) return CallEnd::fire_service;
  if (call.lift == 0 && is_hindered(0) && was_opened_for(call)) return CallEnd::served;
  return is_out ? CallEnd::out_of_order : CallEnd::unexplained;
}

/// A lift that cannot tell its group that it has answered a call does so later.
bool LiftNetwork::State::was_opened_for(const CallKey& call) const {
  const auto since = lit_since.find(call);
  const Time opened = opened_at[call.floor - std::size_t{1}];
  return since != lit_since.end() && opened != never && opened >= since->second;
}

bool LiftNetwork::State::is_car_at(LiftNumber lift, FloorNumber floor) const {
  const LiftFacts facts = shaft(lift).facts(world.now());
  const double distance_m = std::abs(facts.position_m - description.building.height_m(floor));
  return distance_m <= floor_tolerance_m;
}

/// Once a second: who waits for what for how long.
void LiftNetwork::State::look(Time now) {
  look_for_brigades(now);
  const bool hindered = is_anything_hindered();
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i);
    shaft_changed(lift);
    // Ready for whoever comes.
    if (shaft(lift).snapshot(now).mode == LiftMode::normal) fault_referee.serves(now, lift);
  }
  if (serves_as_group()) fault_referee.serves(now, 0);
  referee.waited(crowd->longest_wait(now), hindered);
  referee.look_at_calls(now, hindered);
  for (const Invariant& broken : referee.take_broken()) note(now, broken);
}

void LiftNetwork::State::look_for_brigades(Time now) {
  for (std::size_t i = 1; i <= shafts.size(); ++i) {
    FireBrigade& brigade = *brigades[i - 1];
    if (!brigade.is_there()) continue;
    const auto lift = static_cast<LiftNumber>(i);
    const LiftFacts facts = shaft(lift).facts(now);
    const bool stands = std::abs(facts.speed_m_s) <= standing_m_s;
    const FloorNumber here = description.building.floor_near(facts.position_m, floor_tolerance_m);
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
  const auto asked_at = pressed_on.find(call);
  const bool is_seen = asked_at == pressed_on.end() || asked_at->second == panel;
  if (crowd != nullptr && is_seen) crowd->assigned(button, lift);
}

void LiftNetwork::State::note(Time at, const Invariant& broken) {
  events.push_back({at, InvariantBroken{broken}});
}

}  // namespace canvoy::lift
