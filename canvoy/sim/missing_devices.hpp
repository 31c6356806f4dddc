// Measures for how long a device was missing at the worst, over all devices of a world.
//
//     MissingDevices missing;
//     missing.judge(5, now, is_at_work || is_excused);    // each step, each device
//     if (missing.worst() > 20s) ...
#pragma once

#include <algorithm>
#include <array>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/wrong_time.hpp"

namespace canvoy {

class MissingDevices {
 public:
  /// Call it in each step, with whether the device is present.
  void judge(NodeId id, Time now, bool is_there) {
    WrongTime& device = devices_.at(id);
    device.judge(now, is_there);
    worst_ = std::max(worst_, device.worst());
    ++judged_;
  }
  /// Excuses the device: it may be missing.
  void pass(NodeId id, Time now) { devices_.at(id).pass(now); }
  /// The longest absence of any device without interruption.
  Duration worst() const { return worst_; }
  /// Number of judgements.
  std::uint64_t judged() const { return judged_; }

 private:
  std::array<WrongTime, node_id_max + 1> devices_{};
  Duration worst_{};
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy
