// What can be seen of every simulated network at one instant: its buses and its nodes. Each world
// adds its own.
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/can/port.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

struct BusSnapshot {
  double load = 0;  ///< of the last second, 0 to 1
  std::uint64_t frames = 0;
  std::uint64_t error_frames = 0;
};

struct NodeSnapshot {
  BusIndex bus = 0;
  NodeId id = 0;
  bool is_powered = true;
  NmtState state = NmtState::initialisation;
  BusState bus_state = BusState::error_active;
  std::uint8_t error_register = 0;
};

}  // namespace canvoy
