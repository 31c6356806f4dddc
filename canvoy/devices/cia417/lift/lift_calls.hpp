// The calls that one lift has to answer: kind, floor, doors and priority (CiA 417-4, 4.3.1).
//
//     LiftCalls calls;
//     calls.add({.kind = CallKind::up, .floor = 3, .doors = 0b01});
//     calls.doors_at(3, kinds_of(CallKind::up));  // 0b01
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia417/lift/floor_set.hpp"
#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"

namespace canvoy::cia417 {

/// Who waits where: car calls have no direction.
enum class CallKind : std::uint8_t {
  car,   ///< a passenger in the car wants to go there
  up,    ///< a passenger there wants to go up
  down,  ///< a passenger there wants to go down
  any,   ///< a passenger there wants the car, without a direction
};
inline constexpr unsigned call_kind_count = 4;  ///< kinds

/// Each basic function has three priorities, in the order of the profile (4.3.1).
enum class CallPriority : std::uint8_t { standard, low, high };
inline constexpr unsigned call_priority_count = 3;  ///< priorities

/// A call.
struct Call {
  CallKind kind = CallKind::car;                   ///< of car or landing
  CallPriority priority = CallPriority::standard;  ///< by its basic function
  std::uint8_t floor = 0;                          ///< 1 to 254
  DoorMask doors = 1;                              ///< doors that have to open there; none: no call

  friend constexpr bool operator==(const Call&, const Call&) = default;
};

/// A bit for each CallKind.
using CallKinds = std::uint8_t;
/// The bit of a kind.
constexpr CallKinds kinds_of(CallKind kind) {
  return static_cast<CallKinds>(1U << static_cast<unsigned>(kind));
}
inline constexpr CallKinds car_calls = 0b0001;   ///< kind car
inline constexpr CallKinds hall_calls = 0b1110;  ///< the three others
inline constexpr CallKinds all_calls = 0b1111;   ///< of any kind
/// Kinds of calls that a car answers at a floor on its way up, or down.
inline constexpr CallKinds calls_up = 0b1011;
inline constexpr CallKinds calls_down = 0b1101;  ///< what a car on its way down may answer

/// 1.5 KiB. Each operation visits each of its 48 sets of floors at most once.
class LiftCalls {
 public:
  /// False if it exists already, with all its doors, or is no call.
  bool add(const Call& call);
  /// Adds the calls of these kinds of another set.
  void add_all(const LiftCalls& other, CallKinds kinds = all_calls);
  /// Returns the doors of the call that existed.
  DoorMask remove(const Call& call);
  /// Removes calls of these kinds at a floor, of all priorities. Returns their doors.
  DoorMask remove_at(std::uint8_t floor, CallKinds kinds);
  /// Removes all calls of these kinds.
  void remove_all(CallKinds kinds = all_calls);
  /// Changes calls of low priority, which have waited long enough, to standard ones.
  void promote_low();

  /// True if the call is there, at all of its doors.
  bool contains(const Call& call) const;
  bool empty(CallKinds kinds = all_calls) const;
  /// Doors that calls of these kinds want at a floor.
  DoorMask doors_at(std::uint8_t floor, CallKinds kinds) const;
  /// Floors with calls of these kinds and this priority.
  FloorSet floors(CallKinds kinds, CallPriority priority) const;
  /// Floors with calls of these kinds.
  FloorSet floors(CallKinds kinds) const;
  /// A call at one door that exists in one of the two and not in the other; floor 0: none.
  Call first_difference(const LiftCalls& other) const;

 private:
  static constexpr unsigned doors_max = 4;
  using Doors = std::array<FloorSet, doors_max>;

  Doors& at(CallKind kind, CallPriority priority) {
    return sets_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(priority)];
  }
  const Doors& at(CallKind kind, CallPriority priority) const {
    return sets_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(priority)];
  }

  std::array<std::array<Doors, call_priority_count>, call_kind_count> sets_{};
};

}  // namespace canvoy::cia417
