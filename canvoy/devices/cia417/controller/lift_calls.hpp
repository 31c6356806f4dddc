// The calls that one lift has to answer: who wants it, where, at which doors, and how urgently (CiA
// 417-4, 4.3.1).
//
//     LiftCalls calls;
//     calls.add({.kind = CallKind::up, .floor = 3, .doors = 0b01});
//     calls.doors_at(3, {CallKind::up})  // 0b01
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia417/controller/floor_set.hpp"
#include "canvoy/devices/cia417/controller/lift_interfaces.hpp"

namespace canvoy::cia417 {

enum class CallKind : std::uint8_t {
  car,   ///< somebody in the car wants to go there
  up,    ///< somebody there wants to go up
  down,  ///< somebody there wants to go down
  any,   ///< somebody there wants the car, and says no direction
};
inline constexpr unsigned call_kind_count = 4;

/// Each basic function has its three (4.3.1); in the order in which the profile counts them.
enum class CallPriority : std::uint8_t { standard, low, high };
inline constexpr unsigned call_priority_count = 3;

struct Call {
  CallKind kind = CallKind::car;
  CallPriority priority = CallPriority::standard;
  std::uint8_t floor = 0;  ///< 1 to 254
  DoorMask doors = 1;      ///< those that are to open there; none: no call

  friend constexpr bool operator==(const Call&, const Call&) = default;
};

/// A bit for each CallKind.
using CallKinds = std::uint8_t;
constexpr CallKinds kinds_of(CallKind kind) {
  return static_cast<CallKinds>(1U << static_cast<unsigned>(kind));
}
inline constexpr CallKinds car_calls = 0b0001;
inline constexpr CallKinds hall_calls = 0b1110;
inline constexpr CallKinds all_calls = 0b1111;
/// What a car that goes up, or down, answers at a floor.
inline constexpr CallKinds calls_up = 0b1011;
inline constexpr CallKinds calls_down = 0b1101;

/// 1.5 KiB; nothing takes longer than a look at each of its 48 sets of floors.
class LiftCalls {
 public:
  /// False where it is there already, with all its doors, or is no call.
  bool add(const Call& call);
  void add_all(const LiftCalls& other, CallKinds kinds = all_calls);
  /// The doors of it that there were.
  DoorMask remove(const Call& call);
  /// Calls of these kinds at a floor, of all priorities: the doors that they wanted.
  DoorMask remove_at(std::uint8_t floor, CallKinds kinds);
  void remove_all(CallKinds kinds = all_calls);
  void remove_each(const LiftCalls& others);
  /// Low calls become standard ones: they have waited long enough.
  void promote_low();

  bool contains(const Call& call) const;
  bool empty(CallKinds kinds = all_calls) const;
  DoorMask doors_at(std::uint8_t floor, CallKinds kinds) const;
  FloorSet floors(CallKinds kinds, CallPriority priority) const;
  FloorSet floors(CallKinds kinds) const;
  /// A call at one door that is either here or there, and not in both; of floor 0: there is none.
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
