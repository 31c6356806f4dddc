#include "canvoy/worlds/lift/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::lift {

Crowd::Crowd(const Building& building, Traffic traffic, PassengerHands hands,
             const PassengerOptions& options)
    : building_(&building),
      traffic_(std::move(traffic)),
      hands_(std::move(hands)),
      options_(options),
      random_(options.seed),
      waiting_(building.floors.size()),
      cars_(building.lifts.size()) {
  plan_arrival();
}

/// Replaces a look that is planned already.
void Crowd::plan_look(PassengerId who, Time when) {
  people_[who].looks_at = when;
  plan_for(who, when, CrowdAct::look);
}

void Crowd::advance(Time now) {
  while (const std::optional<CrowdAgenda::Entry> due = agenda_.take(now)) {
    now_ = std::max(now_, due->when);
    act(*due);
  }
  now_ = now;
}

void Crowd::act(const CrowdAgenda::Entry& due) {
  switch (due.act) {
    case CrowdAct::arrive:
      return arrive();
    case CrowdAct::look:
      return look(due.who);
    case CrowdAct::give_up:
      return give_up(due.who);
    case CrowdAct::release:
      return buttons_.release(due.button);
    case CrowdAct::release_door:
      if (hands_.door_open_button) hands_.door_open_button(due.lift, false);
      return;
    case CrowdAct::out_of_way:
    case CrowdAct::hand_away:
      return free_doorway(due.lift);
    case CrowdAct::through:
      return is_through(now_, due.lift, due.who);
    case CrowdAct::try_again:
      return transfer(now_, due.lift);
    case CrowdAct::leave_stuck:
      return leave_stuck_car(due.lift);
  }
}

void Crowd::plan_arrival() {
  const std::optional<Arrival> next = traffic_.next();
  if (!next) return;
  next_arrival_ = *next;
  plan_for(nobody, next_arrival_.at, CrowdAct::arrive);
}

void Crowd::arrive() {
  const Arrival wish = next_arrival_;
  plan_arrival();
  come(now_, wish);
}

void Crowd::come(Time now, const Arrival& wish) {
  now_ = std::max(now_, now);
  const auto in_building = [&](FloorNumber floor) {
    return floor >= 1 && floor <= building_->floor_count();
  };
  if (!in_building(wish.from) || !in_building(wish.to) || wish.from == wish.to) return;
  if (!building_->has_way(wish.from, wish.to)) return;
  const PassengerId who = people_.size();
  people_.push_back({.wish = wish});
  begin_to_wait(who);
  for (std::size_t i = 1; i <= cars_.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i);
    if (car(lift).view().floor == wish.from) transfer(now_, lift);
  }
}

/// At the floor of the passenger.
void Crowd::begin_to_wait(PassengerId who) {
  Passenger& person = people_[who];
  person.state = PassengerState::waiting;
  person.waiting_since = now_;
  person.pressed_at = now_;
  person.gives_up_at = now_ + between(options_.patience_least, options_.patience_most);
  landing(person.wish.from).push_back(who);
  plan_for(who, person.gives_up_at, CrowdAct::give_up);
  plan_look(who, now_ + options_.reaction);
}

void Crowd::look(PassengerId who) {
  if (people_[who].looks_at != now_) return;
  switch (people_[who].state) {
    case PassengerState::waiting:
      return look_at_landing(who);
    case PassengerState::riding:
      return look_in_car(who);
    default:
      return;
  }
}

/// A passenger presses unless the lamp is lit already, or a suitable car is at the landing: where
/// it is full, the passenger waits until it has left.
void Crowd::look_at_landing(PassengerId who) {
  Passenger& person = people_[who];
  plan_look(who, now_ + options_.look_again);
  for (std::size_t i = 1; i <= cars_.size(); ++i) {
    const auto lift = static_cast<LiftNumber>(i);
    if (is_his(person, lift)) return;
  }
  if (options_.destination_control) return ask(who);
  press_where_dark(person, hall_button_of(person));
}

/// A terminal counts each person, so that each one makes a request, and is told the lift or to
/// wait. A passenger who has waited for long makes the request again.
void Crowd::ask(PassengerId who) {
  Passenger& person = people_[who];
  const bool is_answered = person.lift != 0 || person.told_to_wait;
  if (is_answered && now_ < person.pressed_at + options_.ask_anyway) return;
  person.told_to_wait = false;
  const CallButton button = hall_button_of(person);
  if (buttons_.is_held(button)) return;  // another person enters the same destination
  person.lift = 0;
  person.asks = true;
  person.pressed_at = now_;
  press(button, person.wish.to);
}

void Crowd::look_in_car(PassengerId who) {
  Passenger& person = people_[who];
  plan_look(who, now_ + options_.look_again);
  check_invariant(person.lift != 0);
  if (car(person.lift).is_open_at(person.wish.to)) return;
  // A passenger who has entered a destination waits for the lift for a while.
  if (options_.destination_control && now_ < person.pressed_at + options_.press_anyway) return;
  press_where_dark(person, CallButton::car(person.lift, person.wish.to));
}

/// A lamp that is lit for long, without a car, keeps no passenger from pressing.
void Crowd::press_where_dark(Passenger& person, const CallButton& button) {
  const bool is_patient = now_ < person.pressed_at + options_.press_anyway;
  if (buttons_.is_lit(button) && is_patient) return;
  person.pressed_at = now_;
  press(button, person.wish.to);
}

void Crowd::press(const CallButton& button, FloorNumber to) {
  if (!buttons_.press(button, to)) return;
  agenda_.plan({.when = now_ + options_.press, .act = CrowdAct::release, .button = button});
}

void Crowd::give_up(PassengerId who) {
  Passenger& person = people_[who];
  if (person.state != PassengerState::waiting || person.gives_up_at != now_) return;
  person.state = PassengerState::gave_up;
  const std::size_t left = std::erase(landing(person.wish.from), who);
  check_invariant(left == 1);
  statistics_.gave_up(now_ - person.waiting_since);
  if (hands_.gave_up) hands_.gave_up(person.waiting_since);
}

CallButton Crowd::hall_button_of(const Passenger& person) const {
  const Arrival& wish = person.wish;
  if (options_.destination_control) return CallButton::destination(wish.from, wish.to);
  return CallButton::hall(wish.from, wish.to > wish.from ? Direction::up : Direction::down);
}

void Crowd::hall_lamp(const HallButton& button, bool lit) {
  buttons_.show(CallButton::hall(button.floor, button.direction), lit);
}

void Crowd::car_lamp(const CarButton& button, bool lit) {
  buttons_.show(CallButton::car(button.lift, button.floor), lit);
}

void Crowd::assigned(const DestinationButton& button, LiftNumber lift) {
  bool is_answer = false;
  for (const PassengerId who : landing(button.floor)) {
    Passenger& person = people_[who];
    if (person.wish.to != button.to || !person.asks) continue;
    is_answer = true;
    person.told_to_wait = lift == 0;
    person.lift = lift;
    person.asks = lift == 0;
  }
  if (is_answer || lift == 0) return;
  // Without a new request: passengers who were told another lift see that they have a new one.
  for (const PassengerId who : landing(button.floor)) {
    Passenger& person = people_[who];
    if (person.wish.to == button.to && person.lift != 0) person.lift = lift;
  }
}

void Crowd::car_changed(Time now, LiftNumber lift, const CarView& view) {
  advance(now);
  CrowdCar& changed = car(lift);
  const CarView before = changed.view();
  if (view == before) return;
  changed.see(view, now);
  const bool was_there = CrowdCar::stands_open(before);
  const bool is_there = CrowdCar::stands_open(view);
  if (was_there && (!is_there || view.floor != before.floor)) car_left(now, lift, before.floor);
  if (is_there && !was_there) plan_at(lift, now + options_.patience_in_car, CrowdAct::leave_stuck);
  if (view.door == DoorView::closing && before.door != DoorView::closing) {
    stop_closing_door(now, lift);
  }
  transfer(now, lift);
}

/// The next passenger, where the door is open and free.
void Crowd::transfer(Time now, LiftNumber lift) {
  const CrowdCar& here = car(lift);
  if (!here.has_free_door()) return;
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
  const std::size_t left = std::erase(landing(here.view().floor), boards);
  check_invariant(left == 1);
  go_through(now, lift, boards);
}

/// The next passenger to get out: one who has arrived; in an evacuation any; and the last one to
/// board where the car still reports that it is too full, after it has had the time to weigh.
PassengerId Crowd::next_to_leave(const CrowdCar& here) const {
  for (const PassengerId who : here.riders()) {
    if (here.view().evacuates || people_[who].wish.to == here.view().floor) return who;
  }
  const bool has_settled = now_ >= here.load_changed_at() + options_.reaction;
  if (here.view().overload && has_settled && !here.riders().empty()) return here.riders().back();
  return nobody;
}

PassengerId Crowd::next_to_board(LiftNumber lift) const {
  for (const PassengerId who : waiting(car(lift).view().floor)) {
    if (may_board(people_[who], lift)) return who;
  }
  return nobody;
}

bool Crowd::may_board(const Passenger& person, LiftNumber lift) const {
  const CrowdCar& here = car(lift);
  const double persons_max =
      std::max(1.0, std::floor(building_->lift(lift).car.rated_persons * options_.fill_share));
  const bool has_room = static_cast<double>(here.riders().size()) < persons_max;
  const bool goes_there = building_->serves(lift, person.wish.to);
  const bool may_enter = goes_there && has_room && !here.view().evacuates && !here.view().overload;
  return may_enter && person.refuses != lift && is_his(person, lift);
}

/// True if its doors are not closed, and it goes to the passenger's destination.
bool Crowd::is_his(const Passenger& person, LiftNumber lift) const {
  const CrowdCar& here = car(lift);
  if (!here.is_open_at(person.wish.from) || !here.view().accepts) return false;
  if (options_.destination_control) return person.lift == lift;
  return here.goes(person.wish.to > person.wish.from ? Direction::up : Direction::down);
}

void Crowd::go_through(Time now, LiftNumber lift, PassengerId who) {
  check_invariant(!car(lift).is_passed());
  car(lift).pass(true);
  stand_in_doorway(now, lift, CrowdAct::out_of_way);
  plan_at(lift, now + options_.transfer, CrowdAct::through, who);
}

void Crowd::is_through(Time now, LiftNumber lift, PassengerId who) {
  check_invariant(car(lift).is_passed());
  car(lift).pass(false);
  if (people_[who].state == PassengerState::boarding) {
    has_boarded(now, lift, who);
  } else {
    has_left(now, lift, who);
  }
  weigh(lift);
  transfer(now, lift);
}

void Crowd::has_boarded(Time now, LiftNumber lift, PassengerId who) {
  Passenger& person = people_[who];
  check_invariant(person.state == PassengerState::boarding);
  person.state = PassengerState::riding;
  person.pressed_at = person.riding_since = now;
  car(lift).board(who);
  statistics_.boarded(now - person.waiting_since);
  plan_look(who, now + options_.reaction);
  if (random_.happens(Probability(options_.holds_door)) && hands_.door_open_button) {
    hands_.door_open_button(lift, true);
    plan_at(lift, now + between(options_.hold_least, options_.hold_most), CrowdAct::release_door);
  }
}

/// At the destination; or for another reason: the car is too full, does not go on, or is taken by
/// the fire brigade.
void Crowd::has_left(Time now, LiftNumber lift, PassengerId who) {
  Passenger& person = people_[who];
  check_invariant(person.state == PassengerState::leaving);
  const CarView& view = car(lift).view();
  if (view.floor == no_floor) {
    // The car has left its floor during the step, like one without a brake: the passenger stays in
    // it.
    person.state = PassengerState::riding;
    return plan_look(who, now + options_.reaction);
  }
  car(lift).leave(who);
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
  const CrowdCar& here = car(lift);
  if (!here.is_stuck(now_, options_.patience_in_car)) return;
  if (here.is_passed() || here.riders().empty()) return;
  plan_at(lift, now_ + options_.transfer, CrowdAct::leave_stuck);
  const PassengerId who = here.riders().back();
  people_[who].state = PassengerState::leaving;
  go_through(now_, lift, who);
}

void Crowd::stand_in_doorway(Time now, LiftNumber lift, CrowdAct end) {
  plan_at(lift, now + options_.in_doorway, end);
  CrowdCar& here = car(lift);
  if (here.enter_doorway() && hands_.doorway) hands_.doorway(lift, here.barred_door(), true);
}

void Crowd::free_doorway(LiftNumber lift) {
  CrowdCar& here = car(lift);
  if (here.leave_doorway() && hands_.doorway) hands_.doorway(lift, here.barred_door(), false);
}

/// A hand in the light barrier, by a person who wanted to board.
void Crowd::stop_closing_door(Time now, LiftNumber lift) {
  const PassengerId who = next_to_board(lift);
  if (who == nobody || !random_.happens(Probability(options_.stops_closing_door))) return;
  stand_in_doorway(now, lift, CrowdAct::hand_away);
}

/// People who were left behind look for the button; with destination control, they make a new
/// request.
void Crowd::car_left(Time now, LiftNumber lift, FloorNumber floor) {
  for (const PassengerId who : waiting(floor)) {
    Passenger& person = people_[who];
    if (person.refuses == lift) person.refuses = 0;
    if (person.lift == lift) person.lift = 0;
    plan_look(who, now + options_.reaction);
  }
  const auto persons = static_cast<unsigned>(car(lift).riders().size());
  if (floor == building_->main_floor && persons > 0) departures_.departed(now, persons);
}

void Crowd::weigh(LiftNumber lift) {
  CrowdCar& here = car(lift);
  double mass_kg = 0;
  for (const PassengerId who : here.riders()) mass_kg += people_[who].wish.mass_kg;
  here.weigh(mass_kg, now_);
  plan_at(lift, now_ + options_.reaction, CrowdAct::try_again);
  if (hands_.load) hands_.load(lift, mass_kg);
}

Duration Crowd::between(Duration least, Duration most) {
  if (most <= least) return least;
  const double share = static_cast<double>(random_.next() >> 11) * 0x1p-53;
  return least +
         Duration(static_cast<Duration::rep>(static_cast<double>((most - least).count()) * share));
}

std::size_t Crowd::waiting_count() const {
  return std::accumulate(waiting_.begin(), waiting_.end(), std::size_t{0},
                         [](std::size_t sum, const auto& all) { return sum + all.size(); });
}

std::size_t Crowd::riding_count() const {
  return std::accumulate(
      cars_.begin(), cars_.end(), std::size_t{0},
      [](std::size_t sum, const CrowdCar& car) { return sum + car.riders().size(); });
}

Duration Crowd::longest_wait(Time now, Time from) const {
  Duration longest{0};
  for (const auto& all : waiting_) {
    for (const PassengerId who : all) {
      longest = std::max(longest, now - std::max(from, people_[who].waiting_since));
    }
  }
  return longest;
}

Duration Crowd::longest_ride(Time now, Time from) const {
  Duration longest{0};
  for (const CrowdCar& car : cars_) {
    for (const PassengerId who : car.riders()) {
      longest = std::max(longest, now - std::max(from, people_[who].riding_since));
    }
  }
  return longest;
}

}  // namespace canvoy::lift
