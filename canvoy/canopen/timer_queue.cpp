#include "canvoy/canopen/timer_queue.hpp"

namespace canvoy {

void TimerQueue::arm(Timer& timer, Time at) {
  if (at == never) return disarm(timer);
  insert(timer, Alarm(now_, at));
}

void TimerQueue::arm_in(Timer& timer, std::uint32_t delay) {
  insert(timer, Alarm(now_, delay));
}

void TimerQueue::arm_earlier(Timer& timer, std::uint32_t delay) {
  const Alarm alarm(now_, delay);
  if (!timer.armed() || alarm.is_before(timer.alarm_)) insert(timer, alarm);
}

void TimerQueue::disarm(Timer& timer) {
  for (Timer** place = &first_; *place != nullptr; place = &(*place)->next_) {
    if (*place != &timer) continue;
    *place = timer.next_;
    break;
  }
  timer.alarm_ = Alarm();
}

void TimerQueue::insert(Timer& timer, const Alarm& alarm) {
  disarm(timer);
  Timer** place = &first_;
  while (*place != nullptr && !alarm.is_before((*place)->alarm_)) place = &(*place)->next_;
  timer.alarm_ = alarm;
  timer.alarm_.run = run_;
  timer.next_ = *place;
  *place = &timer;
}

void TimerQueue::run(Time now) {
  now_ = now;
  // The count wraps: what was armed 256 runs ago waits for the next run, which comes at once.
  const std::uint8_t run = ++run_;
  while (first_ != nullptr && first_->alarm_.is_due(now) && first_->alarm_.run != run) {
    Timer& timer = *first_;
    Alarm alarm = timer.alarm_;
    disarm(timer);
    if (alarm.put_off()) {
      insert(timer, alarm);
    } else {
      timer.expired_(now);
    }
  }
}

}  // namespace canvoy
