// The buttons of a building as people see and press them: which are lit, and which are held
// already.
//
//     CallButtons buttons(hands);
//     if (buttons.press({CallButton::Kind::car, 1, 3}, 3)) plan(release_in_a_moment);
//     buttons.show({CallButton::Kind::car, 1, 3}, true);
#pragma once

#include <compare>
#include <cstdint>
#include <set>

#include "canvoy/worlds/lift/passenger.hpp"

namespace canvoy::lift {

/// A button as one value, so that actions with it can be planned.
struct CallButton {
  /// A button of a landing, one of a car, or a destination at a landing.
  enum class Kind : std::uint8_t { hall, car, destination } kind = Kind::hall;  ///< which of them
  std::uint8_t place = 0;                                                       ///< floor or lift
  std::uint8_t what = 0;  ///< direction or floor

  /// A button of a landing with a direction.
  static CallButton hall(FloorNumber floor, Direction direction) {
    return {Kind::hall, floor, static_cast<std::uint8_t>(direction)};
  }
  /// A button in a car.
  static CallButton car(LiftNumber lift, FloorNumber floor) { return {Kind::car, lift, floor}; }
  /// A button of a terminal at floor `from`.
  static CallButton destination(FloorNumber from, FloorNumber to) {
    return {Kind::destination, from, to};
  }
  auto operator<=>(const CallButton&) const = default;
};

class CallButtons {
 public:
  /// `hands` must outlive this object.
  explicit CallButtons(const PassengerHands& hands) : hands_(&hands) {}

  /// Presses a button for a person who wants to go `to`. False: another person holds it.
  bool press(const CallButton& button, FloorNumber to);
  /// The hand leaves the button.
  void release(const CallButton& button);
  /// True while a hand holds it.
  bool is_held(const CallButton& button) const { return held_.contains(button); }
  /// Number of presses so far, of all buttons.
  std::uint64_t presses() const { return presses_; }

  /// Switches its lamp on or off.
  void show(const CallButton& button, bool is_lit);
  /// True if its lamp is lit, as people see it.
  bool is_lit(const CallButton& button) const { return lit_.contains(button); }

 private:
  void move(const CallButton& button, bool pressed, FloorNumber to = no_floor);

  const PassengerHands* hands_;
  std::set<CallButton> lit_;
  std::set<CallButton> held_;
  std::uint64_t presses_ = 0;
};

}  // namespace canvoy::lift
