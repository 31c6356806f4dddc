// A light barrier unit: what the light barriers of up to four doors see (6310h; CiA 417-4, 4.8),
// and their defects as emergencies (FF01h; CiA 417-1, 8.4).
//
//     LightBarrierUnit barrier(node, {.sense =
//     Callback<Detection(unsigned)>::to<&Door::beam>(door)},
//                              {.doors = 0b0001});
//     barrier.hardware_changed();   // the beam was broken
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

struct LightBarrierHardware {
  /// What is seen at a door, 1 to 4; yes: somebody.
  Callback<Detection(unsigned door)> sense;
};

struct LightBarrierSettings {
  unsigned lift = 1;            ///< 1 to 8
  std::uint8_t doors = 0b0001;  ///< with a light barrier: bit 0 is door 1
  /// How often the hardware is looked at; zero: when it says that it has changed.
  Duration sensing_period = 10ms;
};

class LightBarrierUnit {
 public:
  /// What `hardware` refers to must outlive this.
  LightBarrierUnit(Node& node, const LightBarrierHardware& hardware,
                   const LightBarrierSettings& settings);
  LightBarrierUnit(const LightBarrierUnit&) = delete;
  LightBarrierUnit& operator=(const LightBarrierUnit&) = delete;

  /// Has the hardware looked at when the node is called next.
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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia417
