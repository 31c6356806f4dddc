// All people of a building: they arrive, press buttons, step through doors one after the other,
// those who leave first, and lose patience.
//
//     Crowd crowd(building, Traffic(building, traffic_options), hands, options);
//     crowd.advance(now);                       // when crowd.deadline() has come
//     crowd.car_changed(now, 1, {.floor = 3, .door = DoorView::open});
//     crowd.hall_lamp({3, Direction::up}, true);
//
// It knows no device: it sees cars and lamps, and acts by its hands. A lamp that is lit keeps
// people from pressing again; where no lamp ever is, they press every few seconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <queue>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/passenger.hpp"
#include "canvoy/sim/lift/statistics.hpp"
#include "canvoy/sim/lift/traffic.hpp"

namespace canvoy::lift {

using PassengerId = std::size_t;

class Crowd {
 public:
  /// `building` must outlive this. Hands are called from within the functions below.
  Crowd(const Building& building, Traffic traffic, PassengerHands hands,
        const PassengerOptions& options = {});
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  Time deadline() const { return plan_.empty() ? never : plan_.top().when; }
  void advance(Time now);
  /// Somebody comes beside those of the traffic. Nobody does who is not in the building, or has no
  /// way.
  void come(Time now, const Arrival& wish);

  /// What people see of a car, whenever it changes.
  void car_changed(Time now, LiftNumber lift, const CarView& view);
  void hall_lamp(const HallButton& button, bool lit);
  void car_lamp(const CarButton& button, bool lit);
  /// A terminal answers those who asked for this destination: take this lift; 0: wait until it
  /// shows one. Where nobody has asked, who had another lift there has this one now.
  void assigned(const DestinationButton& button, LiftNumber lift);

  const PassengerStatistics& statistics() const { return statistics_; }
  /// Of cars that left the main floor with people in them.
  DepartureStatistics& departures() { return departures_; }
  const DepartureStatistics& departures() const { return departures_; }

  /// All who ever came, in their order.
  const std::deque<Passenger>& passengers() const { return people_; }
  /// At a landing, those who came first in front; valid until the next call.
  std::span<const PassengerId> waiting(FloorNumber floor) const {
    return waiting_[floor - std::size_t{1}];
  }
  std::span<const PassengerId> riding(LiftNumber lift) const { return car(lift).riders; }
  double load_kg(LiftNumber lift) const { return car(lift).load_kg; }
  /// Nobody is in it, nor on the way in or out.
  bool is_empty(LiftNumber lift) const { return car(lift).riders.empty() && !car(lift).is_passed; }
  std::size_t waiting_count() const;
  std::size_t riding_count() const;
  /// How long the one who waits, or rides, longest does so, of the time since `from`; 0: nobody.
  Duration longest_wait(Time now, Time from = {}) const;
  Duration longest_ride(Time now, Time from = {}) const;
  std::uint64_t presses() const { return presses_; }

 private:
  enum class Act : std::uint8_t {
    arrive,
    look,          // whether a button has to be pressed
    give_up,       // waiting
    release,       // a button
    release_door,  // the button for it
    out_of_way,    // the doorway is free
    through,       // a person is in, or out
    hand_away,     // that stopped a closing door
    try_again,     // to get through the door
    leave_stuck,   // a car that does not go on
  };
  /// A button as one number, so that it can be planned.
  struct Button {
    enum class Kind : std::uint8_t { hall, car, destination } kind = Kind::hall;
    std::uint8_t place = 0;  ///< floor or lift
    std::uint8_t what = 0;   ///< direction or floor
    auto operator<=>(const Button&) const = default;
  };
  struct Planned {
    Time when{};
    std::uint64_t order = 0;
    Act act = Act::arrive;
    std::size_t who = 0;  ///< passenger, or lift
    Button button{};
    bool operator<(const Planned& other) const {
      return when != other.when ? when > other.when : order > other.order;
    }
  };
  struct Car {
    CarView view{};
    std::vector<PassengerId> riders{};
    double load_kg = 0;
    bool is_passed = false;  ///< somebody is on the way through the door
    unsigned in_the_way = 0;
    DoorNumber barred_door = 1;  ///< where they are in the way
    Time stuck_since{};
    Time load_changed_at{};
  };

  void plan(Time when, Act act, std::size_t who, const Button& button);
  void plan_for(PassengerId who, Time when, Act act);
  void plan_look(PassengerId who, Time when);
  void begin_to_wait(PassengerId who);
  void act(const Planned& planned);
  void plan_arrival();
  void arrive();
  void look(PassengerId who);
  void look_at_landing(PassengerId who);
  void ask(PassengerId who);
  void look_in_car(PassengerId who);
  void press(Time now, const Button& button, FloorNumber to);
  void press_where_dark(Passenger& person, const Button& button);
  void move(const Button& button, bool pressed, FloorNumber to = no_floor);
  void give_up(PassengerId who);
  void leave_stuck_car(LiftNumber lift);

  // crowd_transfer.cpp: through the door
  void transfer(Time now, LiftNumber lift);
  PassengerId next_to_leave(const Car& car) const;
  PassengerId next_to_board(LiftNumber lift) const;
  bool may_board(const Passenger& person, LiftNumber lift) const;
  bool is_his(const Passenger& person, LiftNumber lift) const;
  bool is_served_here(const Passenger& person) const;
  void go_through(Time now, LiftNumber lift, PassengerId who);
  void is_through(Time now, LiftNumber lift, PassengerId who);
  void has_boarded(Time now, LiftNumber lift, PassengerId who);
  void has_left(Time now, LiftNumber lift, PassengerId who);
  void stand_in_doorway(Time now, LiftNumber lift, Duration how_long, Act end);
  void free_doorway(LiftNumber lift);
  void stop_closing_door(Time now, LiftNumber lift);
  void car_left(Time now, LiftNumber lift, FloorNumber floor);
  void update_load(LiftNumber lift);

  Car& car(LiftNumber lift) { return cars_[lift - std::size_t{1}]; }
  const Car& car(LiftNumber lift) const { return cars_[lift - std::size_t{1}]; }
  std::vector<PassengerId>& landing(FloorNumber floor) { return waiting_[floor - std::size_t{1}]; }
  Button hall_button_of(const Passenger& person) const;
  Duration between(Duration least, Duration most);

  static constexpr PassengerId nobody = ~std::size_t{0};

  const Building* building_;
  Traffic traffic_;
  PassengerHands hands_;
  PassengerOptions options_;
  Random random_;
  Arrival next_arrival_{};
  std::deque<Passenger> people_;
  std::vector<std::vector<PassengerId>> waiting_;
  std::vector<Car> cars_;
  std::set<Button> lit_;
  std::set<Button> held_;
  std::priority_queue<Planned> plan_;
  std::uint64_t plan_order_ = 0;
  std::uint64_t presses_ = 0;
  PassengerStatistics statistics_;
  DepartureStatistics departures_;
  Time now_{};
};

}  // namespace canvoy::lift
