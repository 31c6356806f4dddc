#include "canvoy/text/doctor/doctor.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"

namespace canvoy::text {

namespace {

constexpr std::uint32_t function_mask = 0x780;
/// At 125 kbit/s a frame of eight bytes takes 1.1 ms.
constexpr Duration sent_again_within = 3ms;

/// Sender of a frame in the pre-defined connection set; 0: none (CiA 301, 7.3.3).
NodeId predefined_sender(std::uint32_t id) {
  constexpr std::uint32_t transmit_bit = 0x80;
  const std::uint32_t function = id & function_mask;
  const bool is_tpdo = function >= can_id::tpdo1 && function < can_id::sdo_response &&
                       (function & transmit_bit) != 0;
  const bool is_of_node = function == can_id::emergency || is_tpdo ||
                          function == can_id::sdo_response || function == can_id::error_control;
  const auto node = static_cast<NodeId>(id & node_id_max);
  return is_of_node && id <= can_id::error_control + node_id_max ? node : NodeId{0};
}

bool is_same_node(const Finding& a, const Finding& b) {
  return a.node != 0 && a.node == b.node;
}

/// True for findings that follow from two devices with one node-ID.
bool follows_from_twice(FindingKind kind) {
  return kind != FindingKind::sheet_differs && kind != FindingKind::node_id_twice;
}

bool follows_from_can_id_twice(FindingKind kind) {
  return kind == FindingKind::pdo_length || kind == FindingKind::inhibit_time ||
         kind == FindingKind::sync_window;
}

/// True if a finding is only a consequence of the cause.
bool follows_from(const Finding& finding, const Finding& cause) {
  using enum FindingKind;
  if (&finding == &cause) return false;
  if (cause.kind == lost_bus) {
    const bool is_absence = finding.kind == no_traffic || finding.kind == silence ||
                            finding.kind == heartbeat_missing || finding.kind == heartbeat_late;
    return is_absence && finding.last >= cause.first;
  }
  if (cause.kind == node_id_twice) {
    return is_same_node(finding, cause) && follows_from_twice(finding.kind);
  }
  if (cause.kind == cob_id_twice) {
    return cause.can_id == finding.can_id && follows_from_can_id_twice(finding.kind);
  }
  if (cause.kind == sync_twice) return finding.kind == sync_window || finding.kind == sync_differs;
  if (cause.kind == bus_errors || cause.kind == errors_at_node) {
    return finding.kind == heartbeat_jitter || finding.kind == heartbeat_late;
  }
  // Late answers are no longer expected.
  if (cause.kind == sdo_time_out) {
    const bool is_sdo = finding.kind == sdo_slow || finding.kind == against_protocol;
    return is_sdo && is_same_node(finding, cause);
  }
  // What fills the bus may be no message of CiA 301 at all.
  if (cause.kind == load_peak) {
    const bool is_of_babbler = finding.kind == against_protocol && finding.node == 0;
    return finding.kind == heartbeat_jitter || is_of_babbler;
  }
  // The sender repeats the frame as fast as it can, and sends nothing else.
  if (cause.kind == not_acknowledged) {
    return finding.kind == load_peak || finding.kind == heartbeat_missing ||
           finding.kind == heartbeat_late || finding.kind == heartbeat_jitter;
  }
  if (cause.kind == heartbeat_missing || cause.kind == heartbeat_late) {
    const bool is_beat = finding.kind == heartbeat_late || finding.kind == heartbeat_jitter;
    return is_beat && is_same_node(finding, cause) && finding.kind != cause.kind;
  }
  return false;
}

}  // namespace

void Doctor::add_sheet(NodeId node, const formats::DataSheet& sheet) {
  bus_.sheets.add(node, sheet);
  SheetWatch::tell(node, sheet, bus_.known);
}

void Doctor::begin(Time at) {
  bus_.begin = bus_.end = at;
  has_begun_ = true;
}

void Doctor::lose(Time at, std::string_view why) {
  if (!has_begun_) begin(at);
  bus_.losses.add(at);
  bus_.loss = why;
}

void Doctor::hear(Time at, const Frame& frame) {
  if (!has_begun_) begin(at);
  at = std::max(at, bus_.end);
  bus_.end = at;
  if (frame.is_error()) {
    bus_.errors.hear_error(at, frame);
  } else {
    hear_frame(at, frame);
  }
}

/// True if the node has shown its presence by error control or an answer: PDOs may be those of
/// another node.
bool Doctor::is_up(NodeId node) const {
  const NodeHeartbeats& beats = bus_.heartbeats.of(node);
  return beats.is_heard() || beats.has_booted() || bus_.sdos.of(node).answers != 0;
}

NodeId Doctor::sender_of(const Frame& frame, const decoder::Decoded& decoded) const {
  using Service = decoder::Decoded::Service;
  if (frame.is_extended() || frame.is_remote()) return 0;
  if (decoded.service == Service::sdo_response) return decoded.node;
  if (decoded.service == Service::sdo_request) return decoded.client;
  if (decoded.service == Service::pdo && decoded.pdo != nullptr) {
    if (decoded.pdo->direction == PdoInfo::Direction::transmit) return decoded.pdo->node;
    // The sender of a PDO that a node is known to receive is unknown.
    return 0;
  }
  return predefined_sender(frame.id);
}

void Doctor::hear_frame(Time at, const Frame& frame) {
  const decoder::Decoded& decoded = decoder_.decode(frame);
  const NodeId node = sender_of(frame, decoded);
  bus_.traffic.hear(at, frame, node);
  bus_.errors.hear(at, frame, node);
  if (frame.is_extended()) return;
  // A frame that is disturbed in its last bits is sent again, though others have accepted it.
  const bool is_sent_again =
      frame == last_ && last_at_ != never && at - last_at_ <= sent_again_within;
  last_ = frame;
  last_at_ = at;
  if (!is_sent_again) {
    bus_.values.hear(at, decoded);
    bus_.values.hear_service(at, node, services_.take(frame));
  }
  if (decoded.service == decoder::Decoded::Service::sdo_request ||
      decoded.service == decoder::Decoded::Service::sdo_response) {
    bus_.sdos.hear(at, frame, decoded, is_up(decoded.node));
    bus_.sheets.hear(at, frame, decoded);
    return learn(decoded);
  }
  if (frame.is_plain() && bus_.known.is_sync(frame.id)) return hear_sync(at, frame);
  constexpr std::uint32_t pdo_first = can_id::tpdo1 + 1;
  constexpr std::uint32_t pdo_last = 0x6DF;
  if (frame.id >= pdo_first && frame.id <= pdo_last) {
    bus_.pdos.hear(at, frame, decoded, node, bus_.known);
    if (node != 0 && !frame.is_remote()) bus_.quiet.send(at, node);
  } else if (frame.id == can_id::nmt) {
    hear_nmt(at, frame);
  } else if (frame.id == can_id::time && frame.is_plain()) {
    bus_.clocks.hear(at, std::nullopt);
  } else if ((frame.id & function_mask) == can_id::emergency) {
    if (frame.is_plain() && frame.length == Frame::length_max) {
      bus_.nodes.emergency(at, static_cast<NodeId>(frame.id & node_id_max), frame);
    }
  } else if ((frame.id & function_mask) == can_id::error_control &&
             is_node_id(frame.id & node_id_max)) {
    hear_error_control(at, frame);
  }
}

void Doctor::hear_sync(Time at, const Frame& frame) {
  bus_.pdos.hear_sync(at);
  bus_.syncs.hear(at, frame, bus_.known.sync_period());
}

void Doctor::learn(const decoder::Decoded& decoded) {
  if (decoded.transfer == nullptr) return;
  const decoder::SdoTransfer& transfer = *decoded.transfer;
  if (transfer.bytes.empty() || transfer.bytes.size() > sizeof(std::uint32_t)) return;
  const auto value = static_cast<std::uint32_t>(load_unsigned(transfer.bytes));
  const std::optional<Duration> before = bus_.known.producer_time(decoded.node);
  bus_.known.learn(decoded.node, transfer.index, transfer.sub, value);
  const bool is_other = before != bus_.known.producer_time(decoded.node);
  if (is_other && transfer.is_write) bus_.heartbeats.of(decoded.node).chosen_anew();
}

void Doctor::hear_nmt(Time at, const Frame& frame) {
  if (!frame.is_plain() || frame.length != 2 || frame.data[1] > node_id_max) return;
  const auto command = static_cast<NmtCommand>(frame.data[0]);
  const NodeId node = frame.data[1];
  const bool is_reset =
      command == NmtCommand::reset_node || command == NmtCommand::reset_communication;
  if (is_reset) bus_.nodes.reset(at, node);
  bus_.quiet.command(node);
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    if (node == 0 || node == id) bus_.heartbeats.of(id).commanded(is_reset);
  }
}

void Doctor::hear_error_control(Time at, const Frame& frame) {
  const auto node = static_cast<NodeId>(frame.id & node_id_max);
  if (frame.is_remote()) return bus_.guarding.at(node).ask(at);
  if (frame.length != 1) return;
  const auto state = static_cast<NmtState>(frame.data[0] & ~guarding_toggle_bit);
  if (frame.data[0] == 0) return hear_boot_up(at, node);
  bus_.quiet.tell(node, state);
  // An answer to node guarding is no heartbeat.
  if (services_.is_answer()) return bus_.guarding.at(node).answer();
  bus_.heartbeats.of(node).hear(at, state, bus_.known.producer_time(node), bus_.traffic.awake());
}

/// A node that is heard for the first time, or has slept with all others, may start.
void Doctor::hear_boot_up(Time at, NodeId node) {
  const bool is_awoken =
      bus_.traffic.awoken() != never && at - bus_.traffic.awoken() <= NodeWatch::boot_most;
  const bool is_expected = bus_.nodes.is_asked(at, node) || is_awoken;
  NodeHeartbeats& beats = bus_.heartbeats.of(node);
  const bool was_heard = beats.is_heard() || beats.has_booted();
  if (was_heard && !is_expected) bus_.nodes.boot_up(at, node);
  beats.boot_up(at, bus_.traffic.awake(), is_expected);
  bus_.quiet.tell(node, NmtState::pre_operational);
  bus_.sdos.restarted(node);
}

Findings Doctor::findings(Time end) {
  bus_.end = std::max(end, bus_.end);
  bus_.traffic.end(bus_.end);
  bus_.sdos.end(bus_.end);
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    bus_.heartbeats.of(id).end(bus_.end, bus_.traffic.awake());
  }
  Findings all;
  for (const FindingRow& row : finding_rows()) row.judge(bus_, all);
  Findings causes;
  for (const Finding& finding : all) {
    const bool follows = std::ranges::any_of(
        all, [&](const Finding& cause) { return follows_from(finding, cause); });
    if (!follows) causes.push_back(finding);
  }
  return causes;
}

}  // namespace canvoy::text
