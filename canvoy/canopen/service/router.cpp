#include "canvoy/canopen/service/router.hpp"

#include <algorithm>

#include "canvoy/can/array_insert.hpp"
#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

std::uint16_t route_key(std::uint16_t can_id, Router::Kind kind) {
  return static_cast<std::uint16_t>(can_id | static_cast<std::uint16_t>(kind));
}

}  // namespace

constexpr Router::Route Router::nobody = {.key = 0xFFFF, .receiver = {}};

Router::Route* Router::lower_bound(unsigned key) const {
  Route* base = table_;
  std::size_t length = size_;
  while (length > 0) {
    const std::size_t half = length / 2;
    const bool right = base[half].key < key;
    base = right ? base + half + 1 : base;
    length = right ? length - half - 1 : half;
  }
  return base;
}

/// Adjusts the dispatches in progress to the routes from `place` on, which have moved by a step.
/// One that was added at the end of a walk is behind it, and waits for the next frame.
void Router::follow(const Route* place, int step) {
  for (Walk* walk = walks_; walk != nullptr; walk = walk->outer) {
    if (place > walk->end || (place == walk->end && step > 0)) continue;
    walk->end += step;
    if (place <= walk->next) walk->next += step;
    check_invariant(walk->next <= walk->end && walk->end <= table_ + size_);
  }
  forget();
}

bool Router::add(std::uint16_t can_id, Receiver receiver, Kind kind) {
  if (full() || can_id > Frame::id_max) return false;
  const std::uint16_t key = route_key(can_id, kind);
  Route* const place = lower_bound(key + 1U);
  table_[size_++] = {key, receiver};
  move_into(table_, size_, static_cast<std::size_t>(place - table_));
  follow(place, 1);
  if constexpr (!is_small_machine) known_.value.add(key);
  search_ = search_and_dispatch;
  filter(can_id, true);
  return true;
}

void Router::remove(std::uint16_t can_id, Receiver receiver, Kind kind) {
  const std::uint16_t key = route_key(can_id, kind);
  Route* place = lower_bound(key);
  for (;; ++place) {
    if (place == table_ + size_ || place->key != key) return;
    if (place->receiver == receiver) break;
  }
  take_out(table_, size_--, static_cast<std::size_t>(place - table_));
  follow(place + 1, -1);
  if constexpr (!is_small_machine) {
    const auto shares = [key](const Route& route) { return KnownKeys::share(route.key, key); };
    if (std::none_of(table_, table_ + size_, shares)) known_.value.remove(key);
  }
  filter(can_id, false);
}

void Router::filter(std::uint16_t can_id, bool is_wanted) {
  if (port_.accept == nullptr) return;
  for (std::size_t i = 0; i < size_ && !is_wanted; ++i) {
    if ((table_[i].key & Frame::id_max) == can_id) return;
  }
  port_.accept(port_.context, can_id, is_wanted);
}

void Router::refilter(std::uint16_t present, std::uint16_t wanted) {
  if (present != 0) filter(present, false);
  if (wanted != 0) filter(wanted, true);
}

bool Router::search_and_dispatch(Router& self, const Frame& frame, Time now) {
  const std::uint16_t key = key_of(frame);
  Route* const first = self.lower_bound(key);
  Route* last = first;
  while (last != self.table_ + self.size_ && last->key == key) ++last;
  if (first == last) return false;
  Walk walk{first, last, self.walks_};
  if constexpr (!is_small_machine) {
    if (walk.end - walk.next == 1) {
      self.remembered_.value[place_of(key)] = static_cast<std::uint16_t>(walk.next - self.table_);
    }
  }
  self.walks_ = &walk;
  while (walk.next < walk.end) {
    const Receiver receiver = (walk.next++)->receiver;
    receiver(frame, now);
  }
  self.walks_ = walk.outer;
  return true;
}

}  // namespace canvoy
