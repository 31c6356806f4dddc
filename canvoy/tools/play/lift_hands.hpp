// Hands of a network file of lifts: at each door, panel, scale, drive and sensor that is played.
//
//     [[hands]]
//     at = "2min"
//     device = "lift-door"
//     lift = 2                 # 1 without it
//     node = 7                 # the first one of its kind without it
//     set = "obstacle=yes"
//
// The hands act on the plants of the building, in addition to people and faults: a load that is set
// is added to the weight of the people in the car, a stop switch to the safety chain.
#pragma once

#include <memory>
#include <vector>

#include "canvoy/tools/play/hand_file.hpp"
#include "canvoy/tools/play/lift_world.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::tools {

/// Reads each `[[hands]]` of a file; its nodes must be read before.
FilePart<LiftRun> lift_hands_part();

/// Hands in a world, where they are events.
class LiftHands {
 public:
  /// Plans the hands. The network must outlive this, and this must outlive the last run of its
  /// world.
  LiftHands(lift::LiftNetwork& network, const std::vector<HandOfFile>& hands);
  ~LiftHands();
  LiftHands(const LiftHands&) = delete;
  LiftHands& operator=(const LiftHands&) = delete;

 private:
  struct Placed;
  std::vector<std::unique_ptr<Placed>> placed_;
};

}  // namespace canvoy::tools
