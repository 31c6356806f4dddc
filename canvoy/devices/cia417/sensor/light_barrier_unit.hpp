// A light barrier unit: the state of the light barriers of up to four doors (6310h; CiA 417-4,
// 4.8), and their defects as emergencies (FF01h; CiA 417-1, 8.4).
//
//     LightBarrierUnit barrier(node, {.sense =
//     Callback<Detection(unsigned)>::to<&Door::beam>(door)},
//                              {.doors = 0b0001});
//     barrier.hardware_changed();   // the beam was broken
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

/// What the unit senses.
struct LightBarrierHardware {
  /// State at a door, 1 to 4; yes: interrupted.
  Callback<Detection(unsigned door)> sense;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(LightBarrierHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::sense; }, "LightBarrierHardware needs a member function sense");
  hardware.sense = callback<&Plain::sense>(plain);
}

/// Lift, doors and period.
struct LightBarrierSettings {
  unsigned lift = 1;            ///< 1 to 8
  std::uint8_t doors = 0b0001;  ///< doors with a light barrier: bit 0 is door 1
  /// Period of readings of the hardware; zero: read when the hardware reports a change.
  Duration sensing_period = 10ms;
};

class LightBarrierUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  LightBarrierUnit(Node& node, const LightBarrierHardware& hardware,
                   const LightBarrierSettings& settings);

  /// Reads the hardware at the next call of the node.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }

  /// `door` is 1 to 4.
  Detection seen(unsigned door) const { return seen_[door - 1]; }

 private:
  void reset(ResetScope scope);
  void look(Time now);
  void tell(unsigned door, Detection seen);

  Node& node_;
  LightBarrierHardware hardware_;
  LightBarrierSettings settings_;
  std::array<Detection, door_count> seen_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia417
