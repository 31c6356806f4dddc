#include "canvoy/devices/cia417/call/served_floors.hpp"

namespace canvoy::cia417 {

namespace {

Direction direction_of(CallKind kind) {
  if (kind == CallKind::up) return Direction::up;
  return kind == CallKind::down ? Direction::down : Direction::none;
}

}  // namespace

void ServedFloors::end_at(unsigned floor) {
  for (FloorSet& floors : served_) floors &= FloorSet::between(1, floor);
}

DoorMask ServedFloors::doors_at(std::uint8_t floor) const {
  return GroupLift{.served = served_}.doors_at(floor);
}

bool ServedFloors::takes_hall_call(const Call& call) const {
  const GroupLift lift{.served = served_};
  return lift.serves(call.floor, call.doors) && lift.leaves(call.floor, direction_of(call.kind));
}

bool ServedFloors::takes_car_call(const Call& call, const SpecialFunctions& keys) const {
  const bool has_doors = call.doors != 0 && (call.doors & ~doors_at(call.floor)) == 0;
  return has_doors && !is_locked(call.floor, keys);
}

bool ServedFloors::is_locked(std::uint8_t floor, const SpecialFunctions& keys) const {
  constexpr auto first_key = static_cast<std::size_t>(SpecialFunction::key_lock_1);
  for (std::size_t key = 0; key < locked_by_key_.size(); ++key) {
    const auto function = static_cast<SpecialFunction>(first_key + key);
    if (locked_by_key_[key].contains(floor) && !keys.is_on(function)) return true;
  }
  return false;
}

bool ServedFloors::takes_destination(const VirtualInput& input,
                                     const SpecialFunctions& keys) const {
  if (input.floor == input.sub_function || !FloorSet::is_floor(input.floor)) return false;
  if (!FloorSet::is_floor(input.sub_function)) return false;
  const DoorMask here = doors_at(input.floor);
  const DoorMask there = doors_at(input.sub_function);
  const bool has_doors = here != 0 && there != 0 && (source_doors(input.doors) & ~here) == 0 &&
                         (destination_doors(input.doors) & ~there) == 0;
  return has_doors && !is_locked(input.sub_function, keys);
}

}  // namespace canvoy::cia417
