// All people of a building: they arrive, press buttons, step through doors one after the other,
// those who get out first, and lose patience.
//
//     Crowd crowd(building, Traffic(building, traffic_options), hands, options);
//     crowd.advance(now);                       // when crowd.deadline() has come
//     crowd.car_changed(now, 1, {.floor = 3, .door = DoorView::open});
//     crowd.hall_lamp({3, Direction::up}, true);
//
// It depends on no device: people see cars and lamps, and act by their hands. A lit lamp keeps them
// from pressing again; without one they press every few seconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/call_buttons.hpp"
#include "canvoy/worlds/lift/crowd_agenda.hpp"
#include "canvoy/worlds/lift/crowd_car.hpp"
#include "canvoy/worlds/lift/passenger.hpp"
#include "canvoy/worlds/lift/statistics.hpp"
#include "canvoy/worlds/lift/traffic.hpp"

namespace canvoy::lift {

class Crowd {
 public:
  /// `building` must outlive this object. Hands are called from within the functions below.
  Crowd(const Building& building, Traffic traffic, PassengerHands hands,
        const PassengerOptions& options = {});
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// Time of the next planned action; never: none.
  Time deadline() const { return agenda_.deadline(); }
  /// Carries out all actions that are due by `now`.
  void advance(Time now);
  /// Adds a person beside those of the traffic. Does nothing for a person who is not in the
  /// building, or has no way.
  void come(Time now, const Arrival& wish);

  /// Call it whenever the visible state of a car changes.
  void car_changed(Time now, LiftNumber lift, const CarView& view);
  /// The lamp of a button of a landing changes; people with the same way see it.
  void hall_lamp(const HallButton& button, bool lit);
  /// The lamp of a button in a car changes.
  void car_lamp(const CarButton& button, bool lit);
  /// A terminal answers the people who requested this destination: take this lift; 0: wait until it
  /// shows one. Without new requests, the people who had another lift there take this one.
  void assigned(const DestinationButton& button, LiftNumber lift);

  /// Waits and rides of all who were served or gave up.
  const PassengerStatistics& statistics() const { return statistics_; }
  /// Departures of cars that left the main floor with people in them.
  DepartureStatistics& departures() { return departures_; }
  /// Departures in an up-peak.
  const DepartureStatistics& departures() const { return departures_; }

  /// All people who ever came, in their order.
  const std::deque<Passenger>& passengers() const { return people_; }
  /// People at a landing, the first to come in front; valid until the next call.
  std::span<const PassengerId> waiting(FloorNumber floor) const {
    return waiting_[floor - std::size_t{1}];
  }
  /// People in a car, in the order in which they got in; valid until the next call.
  std::span<const PassengerId> riding(LiftNumber lift) const { return car(lift).riders(); }
  /// Mass of the people in a car.
  double load_kg(LiftNumber lift) const { return car(lift).load_kg(); }
  /// True if the car is empty, and no person is on the way in or out.
  bool is_empty(LiftNumber lift) const { return car(lift).is_empty(); }
  /// People at all landings.
  std::size_t waiting_count() const;
  /// People in all cars.
  std::size_t riding_count() const;
  /// The longest time for which a person waits, or rides, within the time since `from`; 0: there is
  /// none.
  Duration longest_wait(Time now, Time from = {}) const;
  /// See longest_wait().
  Duration longest_ride(Time now, Time from = {}) const;
  /// Number of buttons that people have pressed.
  std::uint64_t presses() const { return buttons_.presses(); }

 private:
  void plan_for(PassengerId who, Time when, CrowdAct act) {
    agenda_.plan({.when = when, .act = act, .who = who});
  }
  void plan_at(LiftNumber lift, Time when, CrowdAct act, PassengerId who = nobody) {
    agenda_.plan({.when = when, .act = act, .who = who, .lift = lift});
  }
  void plan_look(PassengerId who, Time when);
  void act(const CrowdAgenda::Entry& due);

  // People at a landing, and in a car.
  void plan_arrival();
  void arrive();
  void begin_to_wait(PassengerId who);
  void look(PassengerId who);
  void look_at_landing(PassengerId who);
  void ask(PassengerId who);
  void look_in_car(PassengerId who);
  void press(const CallButton& button, FloorNumber to);
  void press_where_dark(Passenger& person, const CallButton& button);
  void give_up(PassengerId who);
  void leave_stuck_car(LiftNumber lift);

  // Moves people through the door: one after the other, those who get out first.
  void transfer(Time now, LiftNumber lift);
  PassengerId next_to_leave(const CrowdCar& car) const;
  PassengerId next_to_board(LiftNumber lift) const;
  bool may_board(const Passenger& person, LiftNumber lift) const;
  bool is_his(const Passenger& person, LiftNumber lift) const;
  void go_through(Time now, LiftNumber lift, PassengerId who);
  void is_through(Time now, LiftNumber lift, PassengerId who);
  void has_boarded(Time now, LiftNumber lift, PassengerId who);
  void has_left(Time now, LiftNumber lift, PassengerId who);
  void stand_in_doorway(Time now, LiftNumber lift, CrowdAct end);
  void free_doorway(LiftNumber lift);
  void stop_closing_door(Time now, LiftNumber lift);
  void car_left(Time now, LiftNumber lift, FloorNumber floor);
  void weigh(LiftNumber lift);

  CrowdCar& car(LiftNumber lift) { return cars_[lift - std::size_t{1}]; }
  const CrowdCar& car(LiftNumber lift) const { return cars_[lift - std::size_t{1}]; }
  std::vector<PassengerId>& landing(FloorNumber floor) { return waiting_[floor - std::size_t{1}]; }
  CallButton hall_button_of(const Passenger& person) const;
  Duration between(Duration least, Duration most);

  static constexpr PassengerId nobody = CrowdAgenda::nobody;

  const Building* building_;
  Traffic traffic_;
  PassengerHands hands_;
  PassengerOptions options_;
  Random random_;
  Arrival next_arrival_{};
  std::deque<Passenger> people_;
  std::vector<std::vector<PassengerId>> waiting_;
  std::vector<CrowdCar> cars_;
  CallButtons buttons_{hands_};
  CrowdAgenda agenda_;
  PassengerStatistics statistics_;
  DepartureStatistics departures_;
  Time now_{};
};

}  // namespace canvoy::lift
