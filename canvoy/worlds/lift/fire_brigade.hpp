// Firefighters who take over a lift: they call it to the fire floor, turn the key in its car when
// all passengers have left it, and go to one floor after the other with the buttons of the car
// alone.
//
//     FireBrigade brigade(hands, {.fire_floor = 1, .floors = 10, .seed = seed});
//     brigade.begin(now);
//     brigade.look(now, view);   // from time to time, a second say
//     brigade.end(now);          // they ride back to the fire floor, get out and give the keys
//     back
//
// If they cannot come back in time, they turn the keys back where the car is: it returns by itself.
// Doors close while their button is held, and open while the other one is (EN 81-72; the choices of
// this lift are in docs/decisions.md).
#pragma once

#include <cstdint>
#include <functional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// Actions at the lift. None may be empty.
struct FireBrigadeHands {
  std::function<void(bool on)> alarm_key;  ///< at the fire floor
  /// The key in the car, 6010h function "fire brigade".
  std::function<void(bool on)> car_key;
  /// A button of the car.
  std::function<void(FloorNumber, bool pressed)> call;
  /// The button that opens the door; it opens as long as it is held.
  std::function<void(bool pressed)> door_open;
  /// The button that closes the door.
  std::function<void(bool pressed)> door_close;
};

/// Visible state of its car.
struct FireBrigadeView {
  FloorNumber floor = no_floor;  ///< floor where it stands
  bool is_open = false;          ///< a door is wholly open
  bool is_empty = true;          ///< of passengers
};

/// Ways and times of the firefighters.
struct FireBrigadeOptions {
  FloorNumber fire_floor = 1;          ///< floor with the alarm key
  FloorNumber floors = 2;              ///< number of floors of the building
  Duration gets_in = 3s;               ///< time from the open door until they turn the key
  Duration looks_before_opening = 2s;  ///< time at a closed door before they open it
  Duration patience = 20s;             ///< after it they try something else
  Duration search_least = 5s;          ///< shortest time at a floor
  std::uint32_t search_more_s = 10;    ///< so much longer at most, by chance
  std::uint64_t seed = 1;              ///< of their ways: the same seed, the same floors
};

class FireBrigade {
 public:
  /// They act by `hands` from within look().
  FireBrigade(FireBrigadeHands hands, const FireBrigadeOptions& options);

  /// Longest time from end() until both keys are turned back.
  static constexpr Duration gives_back_within = 2min;

  void begin(Time now);
  void end(Time now);
  /// They see the car and act; call it often (every 100 ms), and at changes.
  void look(Time now, const FireBrigadeView& car);
  /// True from begin() to end().
  bool is_there() const { return step_ != Step::away; }
  /// Time for which they have waited for the car to take them to a floor; 0: they do not wait.
  Duration waits(Time now) const {
    return rides_since_ == never ? Duration{0} : now - rides_since_;
  }
  /// Number of times that they gave the keys back at the fire floor, beside the open car.
  unsigned returns() const { return returns_; }
  /// Number of floors where they have opened the car with the button.
  unsigned floors_searched() const { return floors_searched_; }

 private:
  enum class Step : std::uint8_t {
    away,
    called,     ///< the car, to the fire floor
    inside,     ///< with the key turned, at an open door
    leaving,    ///< with a finger on the button
    riding,     ///< to target_
    opening,    ///< with a finger on the other button
    searching,  ///< the floor, with the door open
  };
  void enter(Step step, Time now);
  void choose(Time now, FloorNumber here);
  void let_go();
  void open(Time now);
  void give_back();
  bool must_give_back(Time now, const FireBrigadeView& car) const;

  FireBrigadeHands hands_;
  FireBrigadeOptions options_;
  Random random_;
  Step step_ = Step::away;
  Time since_{};  ///< of the step
  Duration search_{};
  FloorNumber target_ = no_floor;
  Time rides_since_ = never;
  Time gives_back_at_ = never;  ///< at the latest; never: they stay
  unsigned floors_searched_ = 0;
  unsigned returns_ = 0;
};

}  // namespace canvoy::lift
