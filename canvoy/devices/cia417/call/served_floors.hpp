// Which calls a lift can answer: the floors where its car has doors, and those that are locked
// while a key is not turned (CiA 417-4, 4.3.1: key lock 1 to 4).
//
//     ServedFloors served({.doors = {FloorSet::between(1, 20)}});
//     served.doors_at(7)                                          // 0b0001
#pragma once

#include <array>

#include "canvoy/devices/cia417/call/special_functions.hpp"
#include "canvoy/devices/cia417/controller/lift_calls.hpp"
#include "canvoy/devices/cia417/group/group_lift.hpp"

namespace canvoy::cia417 {

inline constexpr std::size_t key_locks = 4;

class ServedFloors {
 public:
  /// For each door its floors; for each key those to which car calls are taken while it is turned
  /// only.
  ServedFloors(const std::array<FloorSet, lift_doors_max>& served,
               const std::array<FloorSet, key_locks>& locked_by_key)
      : served_(served), locked_by_key_(locked_by_key) {}

  /// The building has no floors above.
  void end_at(unsigned floor);

  DoorMask doors_at(std::uint8_t floor) const;
  /// It has a door there, and some floor to go to: from the highest one nobody goes up, nor down
  /// from the lowest.
  bool takes_hall_call(const Call& call) const;
  bool takes_car_call(const Call& call, const SpecialFunctions& keys) const;
  bool is_locked(std::uint8_t floor, const SpecialFunctions& keys) const;
  /// From floor to floor, by doors that are there.
  bool takes_destination(const VirtualInput& input, const SpecialFunctions& keys) const;

 private:
  std::array<FloorSet, lift_doors_max> served_;
  std::array<FloorSet, key_locks> locked_by_key_;
};

}  // namespace canvoy::cia417
