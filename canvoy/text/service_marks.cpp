#include "canvoy/text/service_marks.hpp"

#include <span>

#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::text {

namespace {

using decoder::Mark;
using decoder::Marks;

constexpr std::uint32_t emergency_last = can_id::emergency + node_id_max;
constexpr unsigned toggle_bit = 0x80;

Marks with(Mark mark) {
  Marks marks;
  marks.add(mark);
  return marks;
}

bool is_told(NmtState state) {
  return state == NmtState::stopped || state == NmtState::operational ||
         state == NmtState::pre_operational;
}

bool is_command(std::uint8_t code) {
  switch (static_cast<NmtCommand>(code)) {
    case NmtCommand::start:
    case NmtCommand::stop:
    case NmtCommand::enter_pre_operational:
    case NmtCommand::reset_node:
    case NmtCommand::reset_communication:
      return true;
  }
  return false;
}

Marks of_nmt(const Frame& frame) {
  constexpr std::uint8_t length = 2;
  if (frame.length != length) return with(Mark::wrong_length);
  const bool is_known = is_command(frame.data[0]) && frame.data[1] <= node_id_max;
  return is_known ? Marks{} : with(Mark::unknown_command);
}

Marks of_sync(const Frame& frame) {
  constexpr unsigned counter_max = 240;
  if (frame.length == 0) return {};
  if (frame.length != 1) return with(Mark::wrong_length);
  const unsigned counter = frame.data[0];
  return counter == 0 || counter > counter_max ? with(Mark::out_of_range) : Marks{};
}

Marks of_time(const Frame& frame) {
  if (frame.length != time_of_day_bytes) return with(Mark::wrong_length);
  const auto time = decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>());
  return time.valid() ? Marks{} : with(Mark::out_of_range);
}

Marks of_emergency(const Frame& frame) {
  constexpr unsigned reserved_bit = 0x40;
  if (frame.length != Frame::length_max) return with(Mark::wrong_length);
  return (frame.data[2] & reserved_bit) != 0 ? with(Mark::reserved) : Marks{};
}

}  // namespace

Marks ServiceMarks::take(const Frame& frame) {
  is_answer_ = false;
  if (frame.is_error() || frame.is_extended()) return {};
  const std::uint32_t node = frame.id - can_id::error_control;
  if (frame.id > can_id::error_control && is_node_id(node)) {
    return of_error_control(frame, static_cast<NodeId>(node));
  }
  if (frame.is_remote()) return {};
  if (frame.id == can_id::nmt) return of_nmt(frame);
  if (frame.id == can_id::sync) return of_sync(frame);
  if (frame.id == can_id::time) return of_time(frame);
  const bool is_emergency = frame.id > can_id::emergency && frame.id <= emergency_last;
  return is_emergency ? of_emergency(frame) : Marks{};
}

/// An answer to a remote frame is node guarding, any other message a heartbeat.
Marks ServiceMarks::of_error_control(const Frame& frame, NodeId node) {
  const bool was_asked = asked_.test(node);
  asked_.set(node, frame.is_remote());
  if (frame.is_remote()) return {};
  if (frame.length != 1) return with(Mark::wrong_length);
  if (frame.data[0] == 0) {
    toggles_.at(node) = false;
    return {};
  }
  is_answer_ = was_asked;
  Marks marks;
  if (!is_told(static_cast<NmtState>(frame.data[0] & ~toggle_bit))) marks.add(Mark::reserved);
  if (was_asked) marks.add(of_guarding((frame.data[0] & toggle_bit) != 0, node));
  return marks;
}

/// The bit alternates from answer to answer, and is 0 in the first one after boot-up (CiA 301,
/// 7.2.8.3.2.1).
Marks ServiceMarks::of_guarding(bool toggle, NodeId node) {
  std::optional<bool>& expected = toggles_.at(node);
  const bool is_wrong = expected && *expected != toggle;
  expected = !toggle;
  return is_wrong ? with(Mark::wrong_toggle) : Marks{};
}

}  // namespace canvoy::text
