// A car as people use it: what they see of it, who rides in it, and who is in its doorway.
//
//     CrowdCar car;
//     car.see({.floor = 3, .door = DoorView::open}, now);
//     car.board(who);
//     if (car.enter_doorway()) hands.doorway(1, car.barred_door(), true);
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "canvoy/can/must_hold.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/lift/crowd_agenda.hpp"
#include "canvoy/sim/lift/passenger.hpp"

namespace canvoy::lift {

class CrowdCar {
 public:
  const CarView& view() const { return view_; }
  /// From now on. Its door has just begun to be open: is_stuck() counts from here.
  void see(const CarView& view, Time now) {
    if (!stands_open(view_) && stands_open(view)) opened_at_ = now;
    view_ = view;
  }
  /// At a floor, with a door that is not closed.
  static bool stands_open(const CarView& view) {
    return view.floor != no_floor && view.door != DoorView::closed;
  }
  bool is_open_at(FloorNumber floor) const {
    return view_.floor == floor && view_.door != DoorView::closed;
  }
  /// Wholly, and nobody is in the door: somebody may go through.
  bool has_free_door() const {
    return !is_passed_ && view_.door == DoorView::open && view_.floor != no_floor;
  }
  bool goes(Direction way) const {
    return view_.direction == Direction::none || view_.direction == way;
  }
  /// It stands open, wholly, and has done so for that long.
  bool is_stuck(Time now, Duration patience) const {
    return view_.floor != no_floor && view_.door == DoorView::open && now - opened_at_ >= patience;
  }

  std::span<const PassengerId> riders() const { return riders_; }
  void board(PassengerId who) { riders_.push_back(who); }
  void leave(PassengerId who) {
    const std::size_t left = std::erase(riders_, who);
    must_hold(left == 1);
  }
  /// Nobody is in it, nor on the way in or out.
  bool is_empty() const { return riders_.empty() && !is_passed_; }

  /// Somebody is on the way through the door.
  bool is_passed() const { return is_passed_; }
  void pass(bool is_passed) { is_passed_ = is_passed; }

  double load_kg() const { return load_kg_; }
  void weigh(double load_kg, Time now) {
    load_kg_ = load_kg;
    load_changed_at_ = now;
  }
  Time load_changed_at() const { return load_changed_at_; }

  /// One more is in the way of the door. True: nobody was.
  bool enter_doorway() {
    if (in_the_way_++ != 0) return false;
    barred_door_ = view_.doorway;
    return true;
  }
  /// One less. True: it is free.
  bool leave_doorway() {
    must_hold(in_the_way_ > 0);
    return --in_the_way_ == 0;
  }
  DoorNumber barred_door() const { return barred_door_; }  ///< where they are in the way

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
