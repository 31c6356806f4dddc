#include "canvoy/text/doctor/error_watch.hpp"

#include <utility>

#include "canvoy/can/error_frame.hpp"

namespace canvoy::text {

namespace {

/// Bits of the controller byte.
constexpr unsigned passive_bits = 0x30;

bool is_unacknowledged(const Frame& frame) {
  if ((frame.id & error_class::no_acknowledgement) != 0) return true;
  const unsigned location = frame.data[error_byte::location];
  return (frame.id & error_class::protocol) != 0 && location == error_location::ack_slot;
}

}  // namespace

void ErrorWatch::hear_error(Time at, const Frame& frame) {
  constexpr std::uint32_t errors =
      error_class::protocol | error_class::bus_error | error_class::no_acknowledgement;
  if ((frame.id & error_class::controller) != 0) {
    was_passive_ = was_passive_ || (frame.data[error_byte::controller] & passive_bits) != 0;
  }
  was_bus_off_ = was_bus_off_ || (frame.id & error_class::bus_off) != 0;
  // A log without error details has an error frame for each error.
  const bool is_state = frame.id != 0 && (frame.id & errors) == 0;
  if (is_state) return;
  errors_.add(at);
  if (is_unacknowledged(frame)) ++unacknowledged_;
  ++waiting_;
  latest_ = at;
}

void ErrorWatch::hear(Time at, const Frame& frame, NodeId node) {
  constexpr std::size_t ids_max = 4096;
  constexpr Duration repeated_within = 100ms;
  const std::uint64_t errors = std::exchange(waiting_, 0);
  if (by_id_.size() == ids_max && !by_id_.contains(frame.id)) return;
  Struck& struck = by_id_[frame.id];
  struck.node = node;
  ++struck.frames;
  if (errors == 0 || at - latest_ > repeated_within) return;
  struck.errors += errors;
  known_ += errors;
}

std::map<NodeId, ErrorWatch::Struck> ErrorWatch::by_node() const {
  std::map<NodeId, Struck> nodes;
  for (const auto& [id, struck] : by_id_) {
    if (struck.node == 0) continue;
    Struck& node = nodes[struck.node];
    node.node = struck.node;
    node.frames += struck.frames;
    node.errors += struck.errors;
  }
  return nodes;
}

}  // namespace canvoy::text
