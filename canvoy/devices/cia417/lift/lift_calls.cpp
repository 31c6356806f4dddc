#include "canvoy/devices/cia417/lift/lift_calls.hpp"

namespace canvoy::cia417 {

namespace {

constexpr bool has(CallKinds kinds, unsigned kind) {
  return (kinds >> kind & 1) != 0;
}
constexpr DoorMask bit_of(unsigned door) {
  return static_cast<DoorMask>(1U << door);
}

}  // namespace

bool LiftCalls::add(const Call& call) {
  bool is_new = false;
  for (unsigned door = 0; door < doors_max; ++door) {
    FloorSet& floors = at(call.kind, call.priority)[door];
    if ((call.doors & bit_of(door)) == 0 || floors.contains(call.floor)) continue;
    floors.insert(call.floor);
    is_new = is_new || floors.contains(call.floor);
  }
  return is_new;
}

void LiftCalls::add_all(const LiftCalls& other, CallKinds kinds) {
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    if (!has(kinds, kind)) continue;
    for (unsigned priority = 0; priority < call_priority_count; ++priority) {
      for (unsigned door = 0; door < doors_max; ++door) {
        sets_[kind][priority][door] |= other.sets_[kind][priority][door];
      }
    }
  }
}

DoorMask LiftCalls::remove(const Call& call) {
  DoorMask removed = 0;
  for (unsigned door = 0; door < doors_max; ++door) {
    FloorSet& floors = at(call.kind, call.priority)[door];
    if ((call.doors & bit_of(door)) == 0 || !floors.contains(call.floor)) continue;
    floors.erase(call.floor);
    removed |= bit_of(door);
  }
  return removed;
}

DoorMask LiftCalls::remove_at(std::uint8_t floor, CallKinds kinds) {
  const DoorMask removed = doors_at(floor, kinds);
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    if (!has(kinds, kind)) continue;
    for (Doors& doors : sets_[kind]) {
      for (FloorSet& floors : doors) floors.erase(floor);
    }
  }
  return removed;
}

void LiftCalls::remove_all(CallKinds kinds) {
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    if (has(kinds, kind)) sets_[kind] = {};
  }
}

void LiftCalls::promote_low() {
  for (auto& priorities : sets_) {
    Doors& low = priorities[static_cast<std::size_t>(CallPriority::low)];
    Doors& standard = priorities[static_cast<std::size_t>(CallPriority::standard)];
    for (unsigned door = 0; door < doors_max; ++door) standard[door] |= low[door];
    low = {};
  }
}

bool LiftCalls::contains(const Call& call) const {
  const Doors& doors = at(call.kind, call.priority);
  for (unsigned door = 0; door < doors_max; ++door) {
    if ((call.doors & bit_of(door)) != 0 && doors[door].contains(call.floor)) return true;
  }
  return false;
}

bool LiftCalls::empty(CallKinds kinds) const {
  return floors(kinds).empty();
}

DoorMask LiftCalls::doors_at(std::uint8_t floor, CallKinds kinds) const {
  DoorMask mask = 0;
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    if (!has(kinds, kind)) continue;
    for (const Doors& doors : sets_[kind]) {
      for (unsigned door = 0; door < doors_max; ++door) {
        if (doors[door].contains(floor)) mask |= bit_of(door);
      }
    }
  }
  return mask;
}

FloorSet LiftCalls::floors(CallKinds kinds, CallPriority priority) const {
  FloorSet all;
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    if (!has(kinds, kind)) continue;
    for (const FloorSet& floors : sets_[kind][static_cast<std::size_t>(priority)]) all |= floors;
  }
  return all;
}

Call LiftCalls::first_difference(const LiftCalls& other) const {
  if (sets_ == other.sets_) return {};
  for (unsigned i = 0; i < call_kind_count * call_priority_count * doors_max; ++i) {
    const auto kind = static_cast<CallKind>(i % call_kind_count);
    const auto priority = static_cast<CallPriority>(i / call_kind_count % call_priority_count);
    const unsigned door = i / (call_kind_count * call_priority_count);
    const FloorSet difference = at(kind, priority)[door] ^ other.at(kind, priority)[door];
    if (!difference.empty()) return {kind, priority, difference.lowest(), bit_of(door)};
  }
  return {};
}

FloorSet LiftCalls::floors(CallKinds kinds) const {
  return floors(kinds, CallPriority::standard) | floors(kinds, CallPriority::low) |
         floors(kinds, CallPriority::high);
}

}  // namespace canvoy::cia417
