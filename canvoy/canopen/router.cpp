#include "canvoy/canopen/router.hpp"

#include <algorithm>

namespace canvoy {

namespace {

std::uint16_t key_of(std::uint16_t can_id, Router::Kind kind) {
  return static_cast<std::uint16_t>(can_id | static_cast<std::uint16_t>(kind));
}

}  // namespace

Router::Route* Router::lower_bound(std::uint16_t key) const {
  Route* base = table_.data();
  std::size_t length = size_;
  while (length > 0) {
    const std::size_t half = length / 2;
    const bool right = base[half].key < key;
    base = right ? base + half + 1 : base;
    length = right ? length - half - 1 : half;
  }
  return base;
}

/// The first route of `key` with a later serial, or whatever stands in its place.
const Router::Route* Router::after(std::uint16_t key, std::uint32_t serial) const {
  const Route* end = table_.data() + size_;
  const Route* route = lower_bound(key);
  while (route != end && route->key == key && route->serial <= serial) ++route;
  return route;
}

bool Router::wanted(std::uint16_t can_id) const {
  const auto has = [&](std::uint16_t key) {
    const Route* route = lower_bound(key);
    return route != table_.data() + size_ && route->key == key;
  };
  return has(key_of(can_id, Kind::data)) || has(key_of(can_id, Kind::remote));
}

bool Router::add(std::uint16_t can_id, Receiver receiver, Kind kind) {
  if (size_ == table_.size() || can_id > Frame::id_max) return false;
  const std::uint16_t key = key_of(can_id, kind);
  Route* end = table_.data() + size_;
  Route* place = lower_bound(static_cast<std::uint16_t>(key + 1));
  std::move_backward(place, end, end + 1);
  *place = {key, ++generation_, receiver};
  ++size_;
  forget();
  if (port_.accept != nullptr) port_.accept(port_.context, can_id, true);
  return true;
}

void Router::remove(std::uint16_t can_id, Receiver receiver, Kind kind) {
  const std::uint16_t key = key_of(can_id, kind);
  Route* end = table_.data() + size_;
  for (Route* route = lower_bound(key); route != end && route->key == key; ++route) {
    if (route->receiver != receiver) continue;
    std::move(route + 1, end, route);
    --size_;
    ++generation_;
    forget();
    if (port_.accept != nullptr && !wanted(can_id)) port_.accept(port_.context, can_id, false);
    return;
  }
}

bool Router::search_and_dispatch(const Frame& frame, Time now, std::uint16_t key) {
  const Route* route = lower_bound(key);
  if (!has_key(route, key)) return false;
  if (!has_key(route + 1, key)) {
    remembered_[place_of(key)] = static_cast<std::uint16_t>(route - table_.data());
    route->receiver(frame, now);
    return true;
  }
  const std::uint32_t newest = generation_;
  std::uint32_t generation = generation_;
  while (has_key(route, key) && route->serial <= newest) {
    const std::uint32_t serial = route->serial;
    route->receiver(frame, now);
    route = generation == generation_ ? route + 1 : after(key, serial);
    generation = generation_;
  }
  return true;
}

}  // namespace canvoy
