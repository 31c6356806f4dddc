// Error frames and the senders of the affected frames: a controller repeats a destroyed frame at
// once, so that it is usually the next successful one (ISO 11898-1).
//
//     ErrorWatch errors;
//     errors.hear_error(time, error_frame);
//     errors.hear(time, frame, 5);  // the frame that was repeated, of node 5
#pragma once

#include <cstdint>
#include <map>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

class ErrorWatch {
 public:
  /// Takes an error frame. It counts for the next successful frame, if that comes within 100 ms.
  void hear_error(Time at, const Frame& frame);
  /// Takes a successful frame of `node`; 0: unknown sender.
  void hear(Time at, const Frame& frame, NodeId node);

  /// All errors, except those that only report a state of the controller.
  const Tally& errors() const { return errors_; }
  /// Number of errors() that report a missing acknowledgement.
  std::uint64_t unacknowledged() const { return unacknowledged_; }
  /// True if an error frame reported that the listening controller was error-passive.
  bool was_passive() const { return was_passive_; }
  /// True if an error frame reported that the listening controller was bus-off.
  bool was_bus_off() const { return was_bus_off_; }

  /// Frames and errors of one sender.
  struct Struck {
    NodeId node = 0;           ///< the sender; 0: unknown
    std::uint64_t frames = 0;  ///< number of successful frames
    std::uint64_t errors = 0;  ///< number of errors in its frames
  };
  /// By CAN-ID of 11 or 29 bits, for the first 4096 CAN-IDs.
  const std::map<std::uint32_t, Struck>& by_id() const { return by_id_; }
  /// The sums of by_id() for each node, without CAN-IDs of unknown senders.
  std::map<NodeId, Struck> by_node() const;
  /// Number of errors with a known sender.
  std::uint64_t known() const { return known_; }

 private:
  Tally errors_;
  std::uint64_t unacknowledged_ = 0;
  bool was_passive_ = false;
  bool was_bus_off_ = false;
  std::uint64_t waiting_ = 0;  ///< errors without a successful frame so far
  Time latest_{};
  std::map<std::uint32_t, Struck> by_id_;
  std::uint64_t known_ = 0;
};

}  // namespace canvoy::text
