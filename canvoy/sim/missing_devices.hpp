// For how long a device was missing at the worst, of all devices of a world.
//
//     MissingDevices missing;
//     missing.judge(5, now, is_at_work || is_excused);    // each step, each device
//     if (missing.worst() > 20s) ...
#pragma once

#include <algorithm>
#include <array>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/wrong_time.hpp"

namespace canvoy {

class MissingDevices {
 public:
  /// Whether the device is there; called in each step.
  void judge(NodeId id, Time now, bool is_there) {
    WrongTime& device = devices_.at(id);
    device.judge(now, is_there);
    worst_ = std::max(worst_, device.worst());
    ++judged_;
  }
  /// It may be missing.
  void pass(NodeId id, Time now) { devices_.at(id).pass(now); }
  /// The longest time at a stretch, of any of them.
  Duration worst() const { return worst_; }
  /// How often.
  std::uint64_t judged() const { return judged_; }

 private:
  std::array<WrongTime, node_id_max + 1> devices_{};
  Duration worst_{};
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy
