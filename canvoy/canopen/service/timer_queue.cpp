#include "canvoy/canopen/service/timer_queue.hpp"

#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

void TimerQueue::arm(Timer& timer, Time at) {
  if constexpr (!is_small_machine) {
    if (timer.armed()) take_out(timer);
    timer.alarm_.set(at);
    if (timer.armed()) put_in(timer);
    return;
  }
  Timer** place = &first_;
  if (timer.armed()) {
    while (*place != &timer) place = &(*place)->next_;
    *place = timer.next_;
    place = &first_;
  }
  timer.alarm_.set(at);
  if (!timer.armed()) return;
  while (*place != nullptr && !is_before(at, (*place)->alarm_.due())) place = &(*place)->next_;
  timer.alarm_.run = run_;
  timer.next_ = *place;
  *place = &timer;
}

// The pairing heap: no timer is due before its parent (Fredman, Sedgewick, Sleator, Tarjan 1986).

inline bool TimerQueue::precedes(const Timer& one, const Timer& other) {
  if constexpr (is_small_machine) {
    return false;
  } else {
    if (one.alarm_.due() != other.alarm_.due()) {
      return is_before(one.alarm_.due(), other.alarm_.due());
    }
    const Timer::Place& place = one.place_.value;
    const Timer::Place& others_place = other.place_.value;
    return place.order < others_place.order;
  }
}

/// Merges two heaps; the earlier top stays on top, and the other becomes its first child.
inline Timer* TimerQueue::meld(Timer* one, Timer* other) {
  Timer* const top = precedes(*other, *one) ? other : one;
  Timer* const below = top == one ? other : one;
  check_invariant(top != below && !precedes(*below, *top));
  Timer*& child = top->place_.value.child;
  below->next_ = child;
  below->place_.value.previous = top;
  if (child != nullptr) child->place_.value.previous = below;
  child = below;
  return top;
}

/// Merges siblings into one heap: in pairs from the first to the last, which are then merged from
/// the last to the first.
Timer* TimerQueue::meld_all(Timer* siblings) {
  if constexpr (is_small_machine) return nullptr;
  Timer* pairs = nullptr;  // the last one first
  while (siblings != nullptr) {
    Timer* pair = siblings;
    Timer* const second = pair->next_;
    siblings = second == nullptr ? nullptr : second->next_;
    if (second != nullptr) pair = meld(pair, second);
    pair->next_ = pairs;
    pairs = pair;
  }
  Timer* top = nullptr;
  while (pairs != nullptr) {
    Timer* const pair = std::exchange(pairs, pairs->next_);
    top = top == nullptr ? pair : meld(top, pair);
  }
  return top;
}

inline void TimerQueue::put_in(Timer& timer) {
  timer.alarm_.run = run_;
  timer.place_.value = {.order = ++armed_.value};
  timer.next_ = nullptr;
  first_ = first_ == nullptr ? &timer : meld(first_, &timer);
}

inline void TimerQueue::take_out(Timer& timer) {
  Timer* const below = meld_all(timer.place_.value.child);
  if (&timer == first_) {
    first_ = below;
    return;
  }
  Timer* const previous = timer.place_.value.previous;
  check_invariant(previous != nullptr);
  Timer*& child = previous->place_.value.child;
  check_invariant(child == &timer || previous->next_ == &timer);
  (child == &timer ? child : previous->next_) = timer.next_;
  if (timer.next_ != nullptr) timer.next_->place_.value.previous = previous;
  if (below != nullptr) first_ = meld(first_, below);
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

void TimerQueue::run_due(Time now) {
  now_ = now;
  // The count wraps: a timer armed 256 runs ago waits for the next run, which comes at once.
  const std::uint8_t run = ++run_;
  while (first_ != nullptr && !is_before(now, first_->alarm_.due()) && first_->alarm_.run != run) {
    Timer& timer = *first_;
    check_invariant(timer.armed());
    if constexpr (is_small_machine) {
      first_ = timer.next_;
    } else {
      take_out(timer);
    }
    timer.alarm_.clear();
    timer.expired_(now);
  }
}

}  // namespace canvoy
