#include "canvoy/devices/cia417/group/up_peak.hpp"

#include <algorithm>
#include <bit>

namespace canvoy::cia417 {

namespace {

constexpr LiftMask without(LiftMask lifts, LiftMask others) {
  return static_cast<LiftMask>(lifts & ~others);
}
constexpr LiftMask with(LiftMask lifts, LiftMask others) {
  return static_cast<LiftMask>(lifts | others);
}

}  // namespace

void UpPeak::reset() {
  call_ = {};
  has_left_ = false;
  left_people_ = 0;
  filling_ = called_ = asked_ = 0;
}

void UpPeak::called(Time now, const HallCall& call) {
  if (call.floor != settings_.main_floor || call.direction != Direction::up) return;
  call_ = call;
  const bool were_left = has_left_ && now - left_at_ <= settings_.left_behind;
  left_people_ = were_left ? std::min(left_people_ + 1, settings_.in_a_row) : 0;
  asked_ = 0;
}

void UpPeak::opened(unsigned lift, const Landing& landing) {
  if (landing.floor != settings_.main_floor || landing.direction == Direction::down) return;
  filling_ = with(filling_, lift_bit(lift));
  called_ = without(called_, lift_bit(lift));
}

void UpPeak::told(Time now, unsigned lift, bool moving) {
  const LiftMask bit = lift_bit(lift);
  const bool fills = (filling_ & bit) != 0;
  if (fills && moving) {
    left_at_ = now;
    has_left_ = true;
  }
  // A lift that has closed its doors without a call is already there, and is not called again.
  if (moving || lifts_[lift - 1].direction == Direction::none) filling_ = without(filling_, bit);
  if (!moving) return;
  called_ = without(called_, bit);
  asked_ = without(asked_, bit);
}

LiftMask UpPeak::call_more(LiftMask busy) {
  const LiftMask serving = this->serving();
  filling_ &= serving;
  called_ &= serving;
  if (!is_crowded() || filling_ == 0) return 0;
  const LiftMask before = called_;
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    const unsigned cars = static_cast<unsigned>(std::popcount(with(filling_, called_)));
    if (cars >= settings_.cars_max) break;
    if ((busy & lift_bit(lift)) != 0 || !is_ready(lift)) continue;
    called_ = with(called_, lift_bit(lift));
    asked_ = with(asked_, lift_bit(lift));
  }
  return called_ == before ? LiftMask{0} : called_;
}

HallCall UpPeak::call() const {
  HallCall made = call_;
  made.priority = CallPriority::low;
  return made;
}

/// True if it stands there with closed doors and without calls.
bool UpPeak::is_ready(unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  const bool is_idle = state.direction == Direction::none && state.car_calls.empty();
  const bool is_meant = (call_.lifts & lift_bit(lift)) != 0;
  const bool is_known = (with(with(filling_, called_), asked_) & lift_bit(lift)) != 0;
  return state.in_service && state.floor == settings_.main_floor && is_idle && is_meant &&
         !is_known && state.serves(call_.floor, call_.doors);
}

LiftMask UpPeak::serving() const {
  unsigned mask = 0;
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    if (lifts_[lift - 1].in_service) mask |= lift_bit(lift);
  }
  return static_cast<LiftMask>(mask);
}

}  // namespace canvoy::cia417
