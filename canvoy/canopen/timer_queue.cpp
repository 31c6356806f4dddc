#include "canvoy/canopen/timer_queue.hpp"

#include <utility>

namespace canvoy {

void TimerQueue::arm(Timer& timer, Time at) {
  if (timer.armed_) unlink(timer);
  timer.armed_ = at != never;
  if (!timer.armed_) return;
  timer.at_ = at;
  timer.order_ = order_++;
  root_ = meld(root_, &timer);
}

void TimerQueue::disarm(Timer& timer) {
  if (!timer.armed_) return;
  unlink(timer);
  timer.armed_ = false;
}

void TimerQueue::run(Time now) {
  const std::uint64_t armed_during_run = order_;
  while (root_ != nullptr && root_->at_ <= now && root_->order_ < armed_during_run) {
    Timer& timer = *root_;
    disarm(timer);
    timer.expired_(now);
  }
}

Timer* TimerQueue::meld(Timer* a, Timer* b) {
  if (a == nullptr) return b;
  if (b == nullptr) return a;
  if (b->before(*a)) std::swap(a, b);
  b->previous_ = a;
  b->sibling_ = a->child_;
  if (b->sibling_ != nullptr) b->sibling_->previous_ = b;
  a->child_ = b;
  return a;
}

/// Pairs the siblings from left to right, then melds the pairs from right to left.
Timer* TimerQueue::merge_siblings(Timer* first) {
  Timer* pairs = nullptr;
  while (first != nullptr) {
    Timer* second = first->sibling_;
    Timer* rest = second == nullptr ? nullptr : second->sibling_;
    first->sibling_ = first->previous_ = nullptr;
    if (second != nullptr) second->sibling_ = second->previous_ = nullptr;
    Timer* pair = meld(first, second);
    pair->sibling_ = pairs;
    pairs = pair;
    first = rest;
  }
  Timer* merged = nullptr;
  while (pairs != nullptr) {
    Timer* next = std::exchange(pairs->sibling_, nullptr);
    merged = meld(merged, pairs);
    pairs = next;
  }
  return merged;
}

void TimerQueue::unlink(Timer& timer) {
  Timer* children = merge_siblings(std::exchange(timer.child_, nullptr));
  if (&timer == root_) {
    root_ = children;
    return;
  }
  if (timer.previous_->child_ == &timer) {
    timer.previous_->child_ = timer.sibling_;
  } else {
    timer.previous_->sibling_ = timer.sibling_;
  }
  if (timer.sibling_ != nullptr) timer.sibling_->previous_ = timer.previous_;
  timer.sibling_ = timer.previous_ = nullptr;
  root_ = meld(root_, children);
}

}  // namespace canvoy
