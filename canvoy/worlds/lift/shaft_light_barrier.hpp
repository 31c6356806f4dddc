// The light barriers of a car, one in each door, for a unit that is a node of its own.
//
//     ShaftLightBarrier barrier(doors);
//     device(port, id, barrier.hardware());
//     barrier.cover(true);    // by smoke
#pragma once

#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/worlds/lift/change_signal.hpp"
#include "canvoy/worlds/lift/shaft_door.hpp"

namespace canvoy::lift {

class ShaftLightBarrier {
 public:
  /// `doors` must outlive this object.
  explicit ShaftLightBarrier(const ShaftDoors& doors) : doors_(&doors) {}
  ShaftLightBarrier(const ShaftLightBarrier&) = delete;
  ShaftLightBarrier& operator=(const ShaftLightBarrier&) = delete;

  /// Hardware for its unit; valid as long as this object.
  cia417::LightBarrierHardware hardware() {
    return {.sense = Callback<cia417::Detection(unsigned)>::to<&ShaftLightBarrier::see>(*this)};
  }
  /// The unit reads its inputs again when `unit` tells it.
  void has_unit(ChangeSignal unit) { unit_ = std::move(unit); }

  /// Call it when a person has stepped into a door, or out of it.
  void look_again() const { unit_.tell(); }
  /// Breaks it, which it reports, or mends it.
  void break_down(bool is_broken) {
    is_broken_ = is_broken;
    look_again();
  }
  /// Interrupts it for ever, or frees it.
  void cover(bool is_covered) {
    is_covered_ = is_covered;
    look_again();
  }

 private:
  cia417::Detection see(unsigned door) {
    const ShaftDoor& seen = *doors_->at(door - 1);
    if (!seen.is_there()) return cia417::Detection::not_available;
    if (is_broken_) return cia417::Detection::error;
    const bool is_interrupted = seen.has_somebody() || is_covered_;
    return is_interrupted ? cia417::Detection::yes : cia417::Detection::no;
  }

  const ShaftDoors* doors_;
  ChangeSignal unit_;
  bool is_broken_ = false;
  bool is_covered_ = false;
};

}  // namespace canvoy::lift
