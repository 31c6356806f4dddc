// Error frames, and whose frames they struck: a controller repeats a frame that was destroyed at
// once (ISO 11898-1), so that it most often is the next one that gets through.
//
//     ErrorWatch errors;
//     errors.hear_error(time, error_frame);
//     errors.hear(time, frame, 5);  // the frame that was repeated, of node 5
#pragma once

#include <cstdint>
#include <map>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/words/doctor/tally.hpp"

namespace canvoy::words {

class ErrorWatch {
 public:
  /// An error frame. It strikes the next frame that gets through, if that comes within 100 ms.
  void hear_error(Time at, const Frame& frame);
  /// A frame that got through, of `node`; 0: not known of whom.
  void hear(Time at, const Frame& frame, NodeId node);

  /// All, but for those that only tell a state of the controller.
  const Tally& errors() const { return errors_; }
  /// Those of errors() that say that a frame was not acknowledged.
  std::uint64_t unacknowledged() const { return unacknowledged_; }
  /// Whether an error frame has told that the controller that listens was error-passive.
  bool was_passive() const { return was_passive_; }
  /// Whether an error frame has told that the controller that listens was bus-off.
  bool was_bus_off() const { return was_bus_off_; }

  /// Of one sender.
  struct Struck {
    NodeId node = 0;           ///< the sender; 0: not known
    std::uint64_t frames = 0;  ///< that got through
    std::uint64_t errors = 0;  ///< that struck its frames
  };
  /// By CAN-ID, of 11 or 29 bits: of the first 4096 that are heard.
  const std::map<std::uint32_t, Struck>& by_id() const { return by_id_; }
  /// The sums of by_id() for each node; CAN-IDs whose sender is not known are left out.
  std::map<NodeId, Struck> by_node() const;
  /// Those of which it is known whom they struck.
  std::uint64_t known() const { return known_; }

 private:
  Tally errors_;
  std::uint64_t unacknowledged_ = 0;
  bool was_passive_ = false;
  bool was_bus_off_ = false;
  std::uint64_t waiting_ = 0;  ///< errors whose frame has not come
  Time latest_{};
  std::map<std::uint32_t, Struck> by_id_;
  std::uint64_t known_ = 0;
};

}  // namespace canvoy::words
