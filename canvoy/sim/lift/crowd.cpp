#include "canvoy/sim/lift/crowd.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

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

void Crowd::plan(Time when, Act act, std::size_t who, const Button& button) {
  plan_.push({when, plan_order_++, act, who, button});
}

void Crowd::plan_for(PassengerId who, Time when, Act act) {
  plan(when, act, who, Button{});
}

/// In place of a look that is planned already.
void Crowd::plan_look(PassengerId who, Time when) {
  people_[who].looks_at = when;
  plan_for(who, when, Act::look);
}

void Crowd::advance(Time now) {
  while (!plan_.empty() && plan_.top().when <= now) {
    const Planned planned = plan_.top();
    plan_.pop();
    now_ = std::max(now_, planned.when);
    act(planned);
  }
  now_ = now;
}

void Crowd::act(const Planned& planned) {
  const auto lift = static_cast<LiftNumber>(planned.button.place);
  switch (planned.act) {
    case Act::arrive:
      return arrive();
    case Act::look:
      return look(planned.who);
    case Act::give_up:
      return give_up(planned.who);
    case Act::release:
      held_.erase(planned.button);
      return move(planned.button, false);
    case Act::release_door:
      if (hands_.door_open_button) hands_.door_open_button(lift, false);
      return;
    case Act::out_of_way:
    case Act::hand_away:
      return free_doorway(lift);
    case Act::through:
      return is_through(now_, lift, planned.who);
    case Act::try_again:
      return transfer(now_, lift);
    case Act::leave_stuck:
      return leave_stuck_car(lift);
  }
}

void Crowd::plan_arrival() {
  const std::optional<Arrival> next = traffic_.next();
  if (!next) return;
  next_arrival_ = *next;
  plan_for(nobody, next_arrival_.at, Act::arrive);
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
    if (car(lift).view.floor == wish.from) transfer(now_, lift);
  }
}

/// At the floor that is his.
void Crowd::begin_to_wait(PassengerId who) {
  Passenger& person = people_[who];
  person.state = PassengerState::waiting;
  person.waiting_since = now_;
  person.pressed_at = now_;
  person.gives_up_at = now_ + between(options_.patience_least, options_.patience_most);
  landing(person.wish.from).push_back(who);
  plan_for(who, person.gives_up_at, Act::give_up);
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

/// A person presses unless the lamp is lit already, or a car that goes his way is there: where it
/// is full, he waits until it has left.
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

/// At a terminal each person is counted, so that each one asks, and is told the lift or to wait.
/// Who has waited for long does not believe it any more.
void Crowd::ask(PassengerId who) {
  Passenger& person = people_[who];
  const bool is_answered = person.lift != 0 || person.told_to_wait;
  if (is_answered && now_ < person.pressed_at + options_.ask_anyway) return;
  person.told_to_wait = false;
  const Button button = hall_button_of(person);
  if (held_.contains(button)) return;  // somebody else is asking the same
  person.lift = 0;
  person.asks = true;
  person.pressed_at = now_;
  press(now_, button, person.wish.to);
}

void Crowd::look_in_car(PassengerId who) {
  Passenger& person = people_[who];
  plan_look(who, now_ + options_.look_again);
  if (is_served_here(person)) return;
  // Who has said where to expects to be brought there, for a while.
  if (options_.destination_control && now_ < person.pressed_at + options_.press_anyway) return;
  press_where_dark(person, {Button::Kind::car, person.lift, person.wish.to});
}

/// A lamp that is lit for long, and no car, persuades nobody.
void Crowd::press_where_dark(Passenger& person, const Button& button) {
  const bool is_patient = now_ < person.pressed_at + options_.press_anyway;
  if (lit_.contains(button) && is_patient) return;
  person.pressed_at = now_;
  press(now_, button, person.wish.to);
}

void Crowd::press(Time now, const Button& button, FloorNumber to) {
  if (!held_.insert(button).second) return;  // somebody else's finger is on it
  ++presses_;
  plan(now + options_.press, Act::release, nobody, button);
  move(button, true, to);
}

void Crowd::move(const Button& button, bool pressed, FloorNumber to) {
  switch (button.kind) {
    case Button::Kind::hall:
      if (!hands_.hall_button) return;
      return hands_.hall_button({button.place, static_cast<Direction>(button.what), to}, pressed);
    case Button::Kind::car:
      if (hands_.car_button) hands_.car_button({button.place, button.what}, pressed);
      return;
    case Button::Kind::destination:
      if (hands_.destination_button) {
        hands_.destination_button({button.place, button.what}, pressed);
      }
      return;
  }
}

void Crowd::give_up(PassengerId who) {
  Passenger& person = people_[who];
  if (person.state != PassengerState::waiting || person.gives_up_at != now_) return;
  person.state = PassengerState::gave_up;
  std::erase(landing(person.wish.from), who);
  statistics_.gave_up(now_ - person.waiting_since);
  if (hands_.gave_up) hands_.gave_up(person.waiting_since);
}

Crowd::Button Crowd::hall_button_of(const Passenger& person) const {
  if (options_.destination_control) {
    return {Button::Kind::destination, person.wish.from, person.wish.to};
  }
  const Direction way = person.wish.to > person.wish.from ? Direction::up : Direction::down;
  return {Button::Kind::hall, person.wish.from, static_cast<std::uint8_t>(way)};
}

void Crowd::hall_lamp(const HallButton& button, bool lit) {
  const Button key{Button::Kind::hall, button.floor, static_cast<std::uint8_t>(button.direction)};
  if (lit) {
    lit_.insert(key);
  } else {
    lit_.erase(key);
  }
}

void Crowd::car_lamp(const CarButton& button, bool lit) {
  const Button key{Button::Kind::car, button.lift, button.floor};
  if (lit) {
    lit_.insert(key);
  } else {
    lit_.erase(key);
  }
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
  // Nobody has asked: those who were told another lift see that they have a new one.
  for (const PassengerId who : landing(button.floor)) {
    Passenger& person = people_[who];
    if (person.wish.to == button.to && person.lift != 0) person.lift = lift;
  }
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
  return std::accumulate(cars_.begin(), cars_.end(), std::size_t{0},
                         [](std::size_t sum, const Car& car) { return sum + car.riders.size(); });
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
  for (const Car& car : cars_) {
    for (const PassengerId who : car.riders) {
      longest = std::max(longest, now - std::max(from, people_[who].riding_since));
    }
  }
  return longest;
}

}  // namespace canvoy::lift
