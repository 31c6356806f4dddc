// How people get into cars and out: one after the other, through the light barrier, those who leave
// first.
#include <algorithm>
#include <cmath>

#include "canvoy/sim/lift/crowd.hpp"

#include "canvoy/can/must_hold.hpp"

namespace canvoy::lift {

void Crowd::car_changed(Time now, LiftNumber lift, const CarView& view) {
  advance(now);
  Car& changed = car(lift);
  const CarView before = changed.view;
  if (view == before) return;
  changed.view = view;
  const bool was_there = before.floor != no_floor && before.door != DoorView::closed;
  const bool is_there = view.floor != no_floor && view.door != DoorView::closed;
  if (was_there && (!is_there || view.floor != before.floor)) car_left(now, lift, before.floor);
  if (is_there && !was_there) {
    changed.stuck_since = now;
    plan(now + options_.patience_in_car, Act::leave_stuck, nobody,
         {Button::Kind::car, lift, view.floor});
  }
  if (view.door == DoorView::closing && before.door != DoorView::closing) {
    stop_closing_door(now, lift);
  }
  transfer(now, lift);
}

/// The next one, where the door is open and nobody is in it.
void Crowd::transfer(Time now, LiftNumber lift) {
  Car& here = car(lift);
  if (here.is_passed || here.view.door != DoorView::open || here.view.floor == no_floor) return;
  const PassengerId leaves = next_to_leave(here);
  if (leaves != nobody) {
    people_[leaves].state = PassengerState::leaving;
    return go_through(now, lift, leaves);
  }
  const PassengerId boards = next_to_board(lift);
  if (boards == nobody) return;
  people_[boards].state = PassengerState::boarding;
  people_[boards].lift = lift;
  people_[boards].asks = people_[boards].told_to_wait = false;
  std::erase(landing(here.view.floor), boards);
  go_through(now, lift, boards);
}

bool Crowd::is_served_here(const Passenger& person) const {
  const CarView& view = car(person.lift).view;
  return view.floor == person.wish.to && view.door != DoorView::closed;
}

/// Who has arrived; all in an evacuation; the last one who came where the car still says that it is
/// too full, after it has had the time to weigh.
PassengerId Crowd::next_to_leave(const Car& here) const {
  for (const PassengerId who : here.riders) {
    if (here.view.evacuates || people_[who].wish.to == here.view.floor) return who;
  }
  const bool has_settled = now_ >= here.load_changed_at + options_.reaction;
  if (here.view.overload && has_settled && !here.riders.empty()) return here.riders.back();
  return nobody;
}

PassengerId Crowd::next_to_board(LiftNumber lift) const {
  for (const PassengerId who : waiting(car(lift).view.floor)) {
    if (may_board(people_[who], lift)) return who;
  }
  return nobody;
}

bool Crowd::may_board(const Passenger& person, LiftNumber lift) const {
  const Car& here = car(lift);
  const double persons_max =
      std::max(1.0, std::floor(building_->lift(lift).car.rated_persons * options_.fill_share));
  const bool has_room = static_cast<double>(here.riders.size()) < persons_max;
  const bool goes_there = building_->serves(lift, person.wish.to);
  const bool may_enter = goes_there && has_room && !here.view.evacuates && !here.view.overload;
  return may_enter && person.refuses != lift && is_his(person, lift);
}

/// Its doors are not closed, and it goes where he wants to.
bool Crowd::is_his(const Passenger& person, LiftNumber lift) const {
  const CarView& view = car(lift).view;
  if (view.floor != person.wish.from || view.door == DoorView::closed || !view.accepts) {
    return false;
  }
  if (options_.destination_control) return person.lift == lift;
  const Direction wanted = person.wish.to > person.wish.from ? Direction::up : Direction::down;
  return view.direction == Direction::none || view.direction == wanted;
}

void Crowd::go_through(Time now, LiftNumber lift, PassengerId who) {
  car(lift).is_passed = true;
  stand_in_doorway(now, lift, options_.in_doorway, Act::out_of_way);
  plan(now + options_.transfer, Act::through, who, {Button::Kind::car, lift, 0});
}

void Crowd::is_through(Time now, LiftNumber lift, PassengerId who) {
  car(lift).is_passed = false;
  if (people_[who].state == PassengerState::boarding) {
    has_boarded(now, lift, who);
  } else {
    has_left(now, lift, who);
  }
  update_load(lift);
  transfer(now, lift);
}

void Crowd::has_boarded(Time now, LiftNumber lift, PassengerId who) {
  Passenger& person = people_[who];
  must_hold(person.state == PassengerState::boarding);
  person.state = PassengerState::riding;
  person.pressed_at = person.riding_since = now;
  car(lift).riders.push_back(who);
  statistics_.boarded(now - person.waiting_since);
  plan_look(who, now + options_.reaction);
  if (random_.happens(Probability(options_.holds_door)) && hands_.door_open_button) {
    hands_.door_open_button(lift, true);
    plan(now + between(options_.hold_least, options_.hold_most), Act::release_door, nobody,
         {Button::Kind::car, lift, 0});
  }
}

/// At the destination; for another one because the car is too full, does not go on, or is wanted by
/// the fire brigade.
void Crowd::has_left(Time now, LiftNumber lift, PassengerId who) {
  Passenger& person = people_[who];
  const CarView& view = car(lift).view;
  if (view.floor == no_floor) {
    // The car has left its floor under him, as one without a brake does: he stays in it.
    person.state = PassengerState::riding;
    return plan_look(who, now + options_.reaction);
  }
  const std::size_t left = std::erase(car(lift).riders, who);
  must_hold(left == 1);
  person.lift = 0;
  if (view.floor == person.wish.to) {
    person.state = PassengerState::served;
    if (hands_.carried) hands_.carried(lift);
    return statistics_.served(now, now - person.wish.at);
  }
  if (view.evacuates) {
    person.state = PassengerState::evacuated;
    return;
  }
  person.refuses = lift;
  person.wish.from = view.floor;
  begin_to_wait(who);
}

void Crowd::leave_stuck_car(LiftNumber lift) {
  Car& here = car(lift);
  const bool is_stuck = here.view.floor != no_floor && here.view.door == DoorView::open &&
                        now_ - here.stuck_since >= options_.patience_in_car;
  if (!is_stuck || here.is_passed || here.riders.empty()) return;
  plan(now_ + options_.transfer, Act::leave_stuck, nobody, {Button::Kind::car, lift, 0});
  const PassengerId who = here.riders.back();
  people_[who].state = PassengerState::leaving;
  go_through(now_, lift, who);
}

void Crowd::stand_in_doorway(Time now, LiftNumber lift, Duration how_long, Act end) {
  Car& here = car(lift);
  plan(now + how_long, end, nobody, {Button::Kind::car, lift, 0});
  if (here.in_the_way++ != 0) return;
  here.barred_door = here.view.doorway;
  if (hands_.doorway) hands_.doorway(lift, here.barred_door, true);
}

void Crowd::free_doorway(LiftNumber lift) {
  Car& here = car(lift);
  must_hold(here.in_the_way > 0);
  if (--here.in_the_way == 0 && hands_.doorway) hands_.doorway(lift, here.barred_door, false);
}

/// A hand in the light barrier, by one of those who would have liked to board.
void Crowd::stop_closing_door(Time now, LiftNumber lift) {
  const PassengerId who = next_to_board(lift);
  if (who == nobody || !random_.happens(Probability(options_.stops_closing_door))) return;
  stand_in_doorway(now, lift, options_.in_doorway, Act::hand_away);
}

/// Those who were left behind look for the button; with destination control, they ask again.
void Crowd::car_left(Time now, LiftNumber lift, FloorNumber floor) {
  for (const PassengerId who : waiting(floor)) {
    Passenger& person = people_[who];
    if (person.refuses == lift) person.refuses = 0;
    if (person.lift == lift) person.lift = 0;
    plan_look(who, now + options_.reaction);
  }
  const auto persons = static_cast<unsigned>(car(lift).riders.size());
  if (floor == building_->main_floor && persons > 0) departures_.departed(now, persons);
}

void Crowd::update_load(LiftNumber lift) {
  Car& here = car(lift);
  double mass_kg = 0;
  for (const PassengerId who : here.riders) mass_kg += people_[who].wish.mass_kg;
  here.load_kg = mass_kg;
  here.load_changed_at = now_;
  plan(now_ + options_.reaction, Act::try_again, nobody, {Button::Kind::car, lift, 0});
  if (hands_.load) hands_.load(lift, mass_kg);
}

}  // namespace canvoy::lift
