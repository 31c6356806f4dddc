// A car as people use it: what they see of it, the people who ride in it, and those in its doorway.
//
//     CrowdCar car;
//     car.see({.floor = 3, .door = DoorView::open}, now);
//     car.board(who);
//     if (car.enter_doorway()) hands.doorway(1, car.barred_door(), true);
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/crowd_agenda.hpp"
#include "canvoy/worlds/lift/passenger.hpp"

namespace canvoy::lift {

class CrowdCar {
 public:
  /// What people see of it.
  const CarView& view() const { return view_; }
  /// Sets what people see of it. When its door begins to be open, is_stuck() starts to count.
  void see(const CarView& view, Time now) {
    if (!stands_open(view_) && stands_open(view)) opened_at_ = now;
    view_ = view;
  }
  /// True at a floor, with a door that is not closed.
  static bool stands_open(const CarView& view) {
    return view.floor != no_floor && view.door != DoorView::closed;
  }
  /// True if a door is not closed at this floor, and the car stands there.
  bool is_open_at(FloorNumber floor) const {
    return view_.floor == floor && view_.door != DoorView::closed;
  }
  /// True if the door is wholly open and no person is in it, so that one may pass.
  bool has_free_door() const {
    return !is_passed_ && view_.door == DoorView::open && view_.floor != no_floor;
  }
  /// True if it shows this direction or none.
  bool goes(Direction way) const {
    return view_.direction == Direction::none || view_.direction == way;
  }
  /// True if the door has been wholly open for `patience`.
  bool is_stuck(Time now, Duration patience) const {
    return view_.floor != no_floor && view_.door == DoorView::open && now - opened_at_ >= patience;
  }

  /// People in it, in the order in which they got in; valid until the next call.
  std::span<const PassengerId> riders() const { return riders_; }
  /// A person is in the car.
  void board(PassengerId who) { riders_.push_back(who); }
  /// A person is out of it; must have been in it.
  void leave(PassengerId who) {
    const std::size_t left = std::erase(riders_, who);
    check_invariant(left == 1);
  }
  /// True if the car is empty, and no person is on the way in or out.
  bool is_empty() const { return riders_.empty() && !is_passed_; }

  /// True while a person is on the way through the door.
  bool is_passed() const { return is_passed_; }
  /// A person begins or ends to go through the door.
  void pass(bool is_passed) { is_passed_ = is_passed; }

  /// Mass of the people in it.
  double load_kg() const { return load_kg_; }
  /// Sets that mass; `now` counts for load_changed_at().
  void weigh(double load_kg, Time now) {
    load_kg_ = load_kg;
    load_changed_at_ = now;
  }
  /// Time of the last change of the load, in or out.
  Time load_changed_at() const { return load_changed_at_; }

  /// A further person stands in the way of the door. True: the first one.
  bool enter_doorway() {
    if (in_the_way_++ != 0) return false;
    barred_door_ = view_.doorway;
    return true;
  }
  /// A person leaves the doorway. True: it is free.
  bool leave_doorway() {
    check_invariant(in_the_way_ > 0);
    return --in_the_way_ == 0;
  }
  DoorNumber barred_door() const { return barred_door_; }  ///< door in which they stand

 private:
  CarView view_{};
  std::vector<PassengerId> riders_{};
  double load_kg_ = 0;
  Time load_changed_at_{};
  bool is_passed_ = false;
  unsigned in_the_way_ = 0;
  DoorNumber barred_door_ = 1;
  Time opened_at_{};
};

}  // namespace canvoy::lift
