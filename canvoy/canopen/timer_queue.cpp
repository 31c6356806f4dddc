#include "canvoy/canopen/timer_queue.hpp"

namespace canvoy {

void TimerQueue::arm(Timer& timer, Time at) {
  Timer** place = &first_;
  if (timer.armed()) {
    while (*place != &timer) place = &(*place)->next_;
    *place = timer.next_;
    // What was due before it is due before a later deadline, too.
    if (at < timer.at_) place = &first_;
  }
  timer.at_ = at;
  if (at == never) return;
  while (*place != nullptr && (*place)->at_ <= at) place = &(*place)->next_;
  timer.run_ = run_;
  timer.next_ = *place;
  *place = &timer;
}

void TimerQueue::run(Time now) {
  // The count wraps: what was armed 256 runs ago waits for the next run, which comes at once.
  const std::uint8_t run = ++run_;
  while (first_ != nullptr && first_->at_ <= now && first_->run_ != run) {
    Timer& timer = *first_;
    first_ = timer.next_;
    timer.at_ = never;
    timer.expired_(now);
  }
}

}  // namespace canvoy
