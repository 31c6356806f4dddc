// The buttons of a building as people see and press them: which are lit, and on which there is a
// finger already.
//
//     CallButtons buttons(hands);
//     if (buttons.press({CallButton::Kind::car, 1, 3}, 3)) plan(release_in_a_moment);
//     buttons.show({CallButton::Kind::car, 1, 3}, true);
#pragma once

#include <compare>
#include <cstdint>
#include <set>

#include "canvoy/sim/lift/passenger.hpp"

namespace canvoy::lift {

/// As one value, so that it can be planned.
struct CallButton {
  enum class Kind : std::uint8_t { hall, car, destination } kind = Kind::hall;
  std::uint8_t place = 0;  ///< floor or lift
  std::uint8_t what = 0;   ///< direction or floor

  static CallButton hall(FloorNumber floor, Direction direction) {
    return {Kind::hall, floor, static_cast<std::uint8_t>(direction)};
  }
  static CallButton car(LiftNumber lift, FloorNumber floor) { return {Kind::car, lift, floor}; }
  static CallButton destination(FloorNumber from, FloorNumber to) {
    return {Kind::destination, from, to};
  }
  auto operator<=>(const CallButton&) const = default;
};

class CallButtons {
 public:
  /// `hands` must outlive this.
  explicit CallButtons(const PassengerHands& hands) : hands_(&hands) {}

  /// For somebody who wants to go `to`. False: somebody else's finger is on it.
  bool press(const CallButton& button, FloorNumber to);
  void release(const CallButton& button);
  bool is_held(const CallButton& button) const { return held_.contains(button); }
  std::uint64_t presses() const { return presses_; }

  /// Its lamp goes on or out.
  void show(const CallButton& button, bool is_lit);
  bool is_lit(const CallButton& button) const { return lit_.contains(button); }

 private:
  void move(const CallButton& button, bool pressed, FloorNumber to = no_floor);

  const PassengerHands* hands_;
  std::set<CallButton> lit_;
  std::set<CallButton> held_;
  std::uint64_t presses_ = 0;
};

}  // namespace canvoy::lift
