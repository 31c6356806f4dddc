// Violations of CiA 301 in the frames of NMT, SYNC, TIME, emergencies and error control.
//
//     ServiceMarks services;
//     if (services.take(frame).has(Mark::wrong_toggle)) show("the toggle bit has not alternated");
#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/mark.hpp"

namespace canvoy::text {

class ServiceMarks {
 public:
  /// Takes the next frame of the bus, and returns its violations: none of frames of other services,
  /// of 29 bits, and of error frames.
  decoder::Marks take(const Frame& frame);
  /// True if the last frame answers a guarding request.
  bool is_answer() const { return is_answer_; }

 private:
  decoder::Marks of_error_control(const Frame& frame, NodeId node);
  decoder::Marks of_guarding(bool toggle, NodeId node);

  std::bitset<node_id_max + 1> asked_;  ///< nodes that were the last to get a guarding request
  /// Expected toggle bit of the next guarding answer of each node.
  std::array<std::optional<bool>, node_id_max + 1> toggles_;
  bool is_answer_ = false;
};

}  // namespace canvoy::text
