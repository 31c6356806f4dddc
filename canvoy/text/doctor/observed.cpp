#include "canvoy/text/doctor/observed.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/error_frame.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/model/physical.hpp"

namespace canvoy::text {

void TrafficWatch::hear(Time at, const Frame& frame, NodeId node) {
  if (frames_.count != 0) pass(at);
  frames_.add(std::max(at, frames_.last));
  if (node != 0) nodes_[node] = true;
  if (bit_rate_ != 0) count(at, frame, node);
}

void TrafficWatch::end(Time at) {
  if (frames_.count != 0) pass(at);
  if (bit_rate_ != 0) close_second();
}

void TrafficWatch::pass(Time at) {
  const Duration gap = std::max(at - frames_.last, Duration::zero());
  if (gap < silence_least) {
    awake_ += gap;
    return;
  }
  silences_.add(at);
  longest_silence_ = std::max(longest_silence_, gap);
  awoken_ = at;
}

void TrafficWatch::count(Time at, const Frame& frame, NodeId node) {
  constexpr Duration second = 1s;
  if (at - second_ >= second || at < second_) {
    close_second();
    second_ = at;
  }
  const unsigned bits = frame_bits(frame) + intermission_bits;
  bits_ += bits;
  constexpr std::size_t senders_max = 4096;
  if (senders_.size() == senders_max && !senders_.contains(frame.id)) return;
  Sender& sender = senders_[frame.id];
  sender.node = node;
  sender.bits += bits;
}

void TrafficWatch::close_second() {
  const double load = static_cast<double>(bits_) / bit_rate_;
  if (load > load_most) peaks_.add(second_);
  if (load > highest_) {
    highest_ = load;
    peak_shares_.clear();
    for (const auto& [id, sender] : senders_) {
      peak_shares_.push_back({id, sender.node, static_cast<double>(sender.bits) / bit_rate_});
    }
    std::ranges::sort(peak_shares_, std::ranges::greater{}, &Share::of_bus);
    constexpr std::size_t shown_max = 3;
    if (peak_shares_.size() > shown_max) peak_shares_.resize(shown_max);
  }
  bits_ = 0;
  senders_.clear();
}

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

namespace {

const NamedValue* failure_of(const Reading& reading) {
  const bool fails = reading.named != nullptr && reading.named->meaning == Meaning::failure;
  return fails ? reading.named : nullptr;
}

/// The sentinel with this meaning; null: none.
const NamedValue* failure_of(const decoder::DecodedValue& value) {
  if (value.entry == nullptr) return nullptr;
  if (const NamedValue* named = failure_of(read_value(*value.entry, value.bytes()))) return named;
  for (const FieldInfo& field : value.entry->fields) {
    if (!decoder::is_active(*value.entry, field, value.bytes())) continue;
    if (const NamedValue* named = failure_of(read_field(*value.entry, field, value.bytes())))
      return named;
  }
  return nullptr;
}

}  // namespace

void ValueWatch::hear(Time at, const decoder::Decoded& decoded) {
  using decoder::Mark;
  decoder::Marks of_values;
  const bool is_pdo = decoded.service == decoder::Decoded::Service::pdo;
  // A PDO of another length has an unknown mapping.
  if (is_pdo && decoded.marks.has(Mark::wrong_length)) return;
  for (const decoder::DecodedValue& value : decoded.values) {
    hear_value(at, decoded.node, value);
    of_values.add(value.marks);
  }
  if (decoded.marks.empty()) return;
  for (const Mark mark : decoder::all_marks) {
    if (!decoded.marks.has(mark) || of_values.has(mark)) continue;
    messages_[{decoded.node, mark}].add(at);
  }
}

void ValueWatch::hear_service(Time at, NodeId node, decoder::Marks marks) {
  for (const decoder::Mark mark : decoder::all_marks) {
    if (marks.has(mark)) messages_[{node, mark}].add(at);
  }
}

void Guarding::ask(Time at) {
  if (is_waiting) {
    missed.add(at);
    most_in_row = std::max(most_in_row, ++in_a_row);
  }
  is_waiting = true;
}

void QuietWatch::tell(NodeId node, NmtState state) {
  Node& each = nodes_.at(node);
  const bool is_same = std::exchange(each.state, state) == state;
  if (is_same && each.since.count != 0) {
    if (each.sent.count == 0) each.sent.first = each.since.first;
    each.sent.count += each.since.count;
    each.sent.last = each.since.last;
  }
  each.since = {};
}

void QuietWatch::command(NodeId node) {
  for (NodeId each = node_id_min; each <= node_id_max; ++each) {
    if (node == 0 || node == each) tell(each, NmtState::operational);
  }
}

void QuietWatch::send(Time at, NodeId node) {
  Node& each = nodes_.at(node);
  const bool is_quiet = each.state == NmtState::stopped || each.state == NmtState::pre_operational;
  if (is_quiet) each.since.add(at);
}

void ValueWatch::hear_value(Time at, NodeId node, const decoder::DecodedValue& value) {
  using decoder::Mark;
  for (const Mark mark : {Mark::reserved, Mark::out_of_range}) {
    if (!value.marks.has(mark)) continue;
    HeardValue* heard = place(wrong_, node, value);
    if (heard == nullptr) continue;
    heard->mark = mark;
    heard->tally.add(at);
  }
  const NamedValue* failure = failure_of(value);
  if (failure == nullptr) return;
  if (HeardValue* heard = place(failed_, node, value)) {
    heard->meaning = failure->name;
    heard->tally.add(at);
  }
}

HeardValue* ValueWatch::place(ByEntry& entries, NodeId node, const decoder::DecodedValue& value) {
  constexpr std::size_t entries_max = 1024;
  const std::tuple key(node, value.index, value.sub);
  if (entries.size() == entries_max && !entries.contains(key)) return nullptr;
  HeardValue& heard = entries[key];
  if (value.object != nullptr) heard.name = value.object->name;
  return &heard;
}

void NodeWatch::reset(Time at, NodeId node) {
  if (node != 0) {
    nodes_.at(node).reset_at = at;
    return;
  }
  for (Node& each : nodes_) each.reset_at = at;
}

bool NodeWatch::is_asked(Time at, NodeId node) const {
  const Time reset_at = nodes_.at(node).reset_at;
  return reset_at != never && at - reset_at <= boot_most;
}

void NodeWatch::emergency(Time at, NodeId node, const Frame& frame) {
  Node& each = nodes_.at(node);
  Time& oldest = each.latest.at(each.heard.emergencies.count % storm_least);
  const bool is_storm = each.heard.emergencies.count >= storm_least && at - oldest <= storm_time;
  oldest = at;
  each.heard.emergencies.add(at);
  each.heard.error_code = load<std::uint16_t>(frame.data.data());
  if (is_storm) each.heard.storm.add(at);
  if (each.heard.error_code == 0) return;
  each.heard.errors.add(at);
  std::vector<std::uint16_t>& codes = each.heard.codes;
  const bool is_known = std::ranges::find(codes, each.heard.error_code) != codes.end();
  if (!is_known && codes.size() < codes_most) codes.push_back(each.heard.error_code);
}

void SyncWatch::hear(Time at, const Frame& frame, std::optional<Duration> expected) {
  if (heard_.count != 0) intervals_[intervals_heard_++ % intervals_max] = at - heard_.last;
  heard_.add(at);
  rhythm_.hear(at, expected);
  can_id_ = static_cast<std::uint16_t>(frame.id);
  hear_counter(at, frame);
}

/// The counter restarts with 1 after its overflow, and when its producer restarts.
void SyncWatch::hear_counter(Time at, const Frame& frame) {
  const std::uint8_t counter = frame.length == 1 ? frame.data[0] : std::uint8_t{0};
  const bool follows = counter == counter_ + 1 || counter <= 1 || counter_ == 0;
  if (!follows) jumps_.add(at);
  counter_ = counter;
}

Duration SyncWatch::period() const {
  constexpr std::size_t least = 4;
  const std::size_t count = std::min(intervals_heard_, intervals_max);
  if (count < least) return {};
  std::array<Duration, intervals_max> sorted = intervals_;
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return sorted[count / 2];
}

}  // namespace canvoy::text
