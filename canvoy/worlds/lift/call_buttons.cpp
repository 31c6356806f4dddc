#include "canvoy/worlds/lift/call_buttons.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::lift {

bool CallButtons::press(const CallButton& button, FloorNumber to) {
  if (!held_.insert(button).second) return false;
  ++presses_;
  move(button, true, to);
  return true;
}

void CallButtons::release(const CallButton& button) {
  const std::size_t left = held_.erase(button);
  check_invariant(left == 1);
  move(button, false);
}

void CallButtons::show(const CallButton& button, bool is_lit) {
  if (is_lit) {
    lit_.insert(button);
  } else {
    lit_.erase(button);
  }
}

void CallButtons::move(const CallButton& button, bool pressed, FloorNumber to) {
  switch (button.kind) {
    case CallButton::Kind::hall:
      if (!hands_->hall_button) return;
      return hands_->hall_button({button.place, static_cast<Direction>(button.what), to}, pressed);
    case CallButton::Kind::car:
      if (hands_->car_button) hands_->car_button({button.place, button.what}, pressed);
      return;
    case CallButton::Kind::destination:
      if (hands_->destination_button) {
        hands_->destination_button({button.place, button.what}, pressed);
      }
      return;
  }
}

}  // namespace canvoy::lift
