#include "canvoy/canopen/timer_queue.hpp"

namespace canvoy {

void TimerQueue::arm(Timer& timer, Time at) {
  Timer** place = &first_;
  if (timer.armed()) {
    while (*place != &timer) place = &(*place)->next_;
    *place = timer.next_;
    // What was due before it is due before a later deadline, too.
    if (is_small_machine || is_before(at, timer.alarm_.due())) place = &first_;
  }
  timer.alarm_.set(at);
  if (!timer.armed()) return;
  while (*place != nullptr && !is_before(at, (*place)->alarm_.due())) place = &(*place)->next_;
  timer.alarm_.run = run_;
  timer.next_ = *place;
  *place = &timer;
}

void TimerQueue::disarm(Timer& timer) {
  arm(timer, never);
}

void TimerQueue::arm_in(Timer& timer, std::uint32_t delay) {
  arm(timer, now() + Duration(delay));
}

void TimerQueue::arm_earlier(Timer& timer, std::uint32_t delay) {
  const Time at = now() + Duration(delay);
  if (!timer.armed() || is_before(at, timer.alarm_.due())) arm(timer, at);
}

void TimerQueue::run(Time now) {
  now_ = now;
  // The count wraps: what was armed 256 runs ago waits for the next run, which comes at once.
  const std::uint8_t run = ++run_;
  while (first_ != nullptr && !is_before(now, first_->alarm_.due()) && first_->alarm_.run != run) {
    Timer& timer = *first_;
    first_ = timer.next_;
    timer.alarm_.clear();
    timer.expired_(now);
  }
}

}  // namespace canvoy
