// The calls that a lift can answer: floors where its car has doors, and floors that are locked
// unless a key is turned (CiA 417-4, 4.3.1: key locks 1 to 4).
//
//     ServedFloors served({FloorSet::between(1, 20)}, {});
//     served.doors_at(7)  // 0b0001
#pragma once

#include <array>

#include "canvoy/devices/cia417/call/special_functions.hpp"
#include "canvoy/devices/cia417/lift/group_lift.hpp"
#include "canvoy/devices/cia417/lift/lift_calls.hpp"

namespace canvoy::cia417 {

inline constexpr std::size_t key_locks = 4;  ///< key lock 1 to 4

class ServedFloors {
 public:
  /// For each door its floors; for each key the floors to which car calls are accepted only while
  /// it is turned.
  ServedFloors(const std::array<FloorSet, lift_doors_max>& served,
               const std::array<FloorSet, key_locks>& locked_by_key)
      : served_(served), locked_by_key_(locked_by_key) {}

  /// The building has no floors above `floor`.
  void end_at(unsigned floor);

  /// Doors of the car at a floor; 0: the lift does not serve it.
  DoorMask doors_at(std::uint8_t floor) const;
  /// True if the lift has a door there, and a floor in that direction: no call goes up from the
  /// highest floor, or down from the lowest.
  bool takes_hall_call(const Call& call) const;
  /// True if the car has a door at the floor, and no key locks it.
  bool takes_car_call(const Call& call, const SpecialFunctions& keys) const;
  /// True if car calls to the floor need a key that is not turned.
  bool is_locked(std::uint8_t floor, const SpecialFunctions& keys) const;
  /// True from one floor to another, by existing doors.
  bool takes_destination(const VirtualInput& input, const SpecialFunctions& keys) const;

 private:
  std::array<FloorSet, lift_doors_max> served_;
  std::array<FloorSet, key_locks> locked_by_key_;
};

}  // namespace canvoy::cia417
