#include "canvoy/text/doctor/object_watches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::text {

void PdoWatch::hear_sync(Time at) {
  sync_ = at;
  ++cycle_;
}

namespace {

/// Finds the sender: from the parameters of nodes, from the decoder, or from the pre-defined
/// connection set.
void find_sender(HeardPdo& pdo, std::uint16_t can_id, const decoder::Decoded& decoded,
                 NodeId sender, const KnownParameters& known) {
  pdo.node = sender;
  pdo.number = 0;
  const decoder::PdoPlan* plan = decoded.pdo;
  const bool is_sent = plan != nullptr && plan->direction == PdoInfo::Direction::transmit;
  pdo.is_multiplexed = plan != nullptr && plan->multiplexed != MpdoKind::no;
  if (const KnownParameters::Place* place = known.sender_of(can_id)) {
    pdo.node = place->first;
    pdo.number = place->second;
  } else if (is_sent) {
    pdo.node = plan->node;
    pdo.number = plan->number;
  }
}

/// Nodes may have mapped other objects than the defaults of their profiles: only known parameters
/// count, and messages that are the same everywhere.
bool is_wrong_length(const Frame& frame, const KnownTpdo* tpdo, const decoder::Decoded& decoded) {
  const auto length = tpdo == nullptr ? std::nullopt : tpdo->length();
  if (length) return *length != frame.length;
  return decoded.pdo != nullptr && decoded.pdo->node == 0 &&
         decoded.marks.has(decoder::Mark::wrong_length);
}

}  // namespace

void PdoWatch::hear(Time at, const Frame& frame, const decoder::Decoded& decoded, NodeId sender,
                    const KnownParameters& known) {
  HeardPdo& pdo = pdos_[static_cast<std::uint16_t>(frame.id)];
  if (frame.is_remote()) {
    pdo.is_asked = true;
    return;
  }
  ++pdo.frames;
  find_sender(pdo, static_cast<std::uint16_t>(frame.id), decoded, sender, known);
  const bool is_of_node = pdo.node != 0 && pdo.number != 0;
  const KnownTpdo* tpdo = is_of_node ? known.tpdo(pdo.node, pdo.number) : nullptr;
  if (is_wrong_length(frame, tpdo, decoded)) pdo.wrong_length.add(at);
  judge_length(pdo, at, frame.length);
  if (tpdo != nullptr) judge_times(pdo, at, frame, *tpdo, known.sync_window(pdo.node));
  pdo.frame_before = std::exchange(pdo.frame, frame);
  pdo.latest = at;
  pdo.is_asked = false;
}

void PdoWatch::judge_length(HeardPdo& pdo, Time at, std::uint8_t length) {
  if (pdo.lengths == 0) {
    pdo.length = length;
    pdo.lengths = 1;
  }
  if (length == pdo.length) return;
  if (pdo.lengths == 1 || (pdo.lengths == 2 && length != pdo.other_length)) ++pdo.lengths;
  pdo.length_changes.add(at);
  pdo.other_length = pdo.length;
  pdo.length = length;
}

void PdoWatch::judge_times(HeardPdo& pdo, Time at, const Frame& frame, const KnownTpdo& tpdo,
                           const std::optional<Duration>& window) {
  if (tpdo.is_synchronous() && cycle_ != 0 && !pdo.is_asked) judge_cycle(pdo, at, window);
  if (pdo.frames < 2 || !tpdo.is_event_driven()) return;
  // A new value is sent at once, between the periods of the event timer.
  const bool is_told_again = frame == pdo.frame || frame == pdo.frame_before;
  if (is_told_again) pdo.rhythm.hear(at, tpdo.event_timer);
  const Duration interval = at - pdo.latest;
  const Duration inhibited = tpdo.inhibit_time.value_or(Duration::zero());
  // A frame that waited for the bus comes late, and the next one may then follow earlier.
  if (pdo.is_asked || inhibited <= Duration::zero() || interval >= inhibited / 2) return;
  pdo.too_early.add(at);
  pdo.inhibit_time = inhibited;
  pdo.shortest = std::min(pdo.shortest, interval);
}

void PdoWatch::judge_cycle(HeardPdo& pdo, Time at, const std::optional<Duration>& window) {
  pdo.in_cycle = pdo.cycle == cycle_ ? pdo.in_cycle + 1 : 1;
  pdo.cycle = cycle_;
  if (pdo.in_cycle == 2) pdo.twice_in_cycle.add(at);
  const Duration behind = at - sync_;
  if (!window || behind <= *window) return;
  pdo.too_late.add(at);
  pdo.window = *window;
  pdo.latest_in_cycle = std::max(pdo.latest_in_cycle, behind);
}

namespace {

/// Entries that are equal in all devices of a kind: the device type, the identity except for the
/// serial number, and constants of the sheet.
bool is_fixed(std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
  constexpr std::uint8_t serial_number = 4;
  if (index == object_index::device_type) return true;
  if (index == object_index::identity) return sub < serial_number;
  return entry.access == "const";
}

std::optional<std::int64_t> said(const formats::SheetEntry& entry, NodeId node) {
  const auto number =
      formats::sheet_number(entry.value.empty() ? entry.default_value : entry.value);
  return number ? std::optional(number->at(node)) : std::nullopt;
}

}  // namespace

void SheetWatch::tell(NodeId node, const formats::DataSheet& sheet, KnownParameters& known) {
  // The heartbeat period is chosen for each network: a default gives no information on this one.
  const auto learn = [&](std::uint16_t index, std::uint8_t sub, const formats::SheetEntry& entry) {
    const bool is_heartbeat =
        index == object_index::heartbeat_producer || index == object_index::heartbeat_consumers;
    if (is_heartbeat && entry.value.empty()) return;
    if (const auto number = said(entry, node)) {
      known.learn(node, index, sub, static_cast<std::uint32_t>(*number));
    }
  };
  for (const auto& [index, object] : sheet.objects) {
    if (object.is_variable()) learn(index, 0, object.own);
    for (const auto& [sub, entry] : object.subs) learn(index, sub, entry);
  }
}

void SheetWatch::hear(Time at, const Frame& frame, const decoder::Decoded& decoded) {
  if (sheets_.empty() || decoded.service != decoder::Decoded::Service::sdo_response) return;
  const auto found = sheets_.find(decoded.node);
  if (found == sheets_.end() || decoded.behind.node != 0) return;
  if (decoded.message == decoder::SdoMessage::abort) {
    return refused(at, decoded.node, *found->second, frame);
  }
  const bool is_read = decoded.transfer != nullptr && !decoded.transfer->is_write;
  if (is_read) compare(at, decoded.node, *found->second, *decoded.transfer);
}

void SheetWatch::compare(Time at, NodeId node, const formats::DataSheet& sheet,
                         const decoder::SdoTransfer& transfer) {
  const formats::SheetEntry* entry = sheet.find(transfer.index, transfer.sub);
  const std::string place = object_text(transfer.index, transfer.sub);
  if (entry == nullptr) {
    return differs(at, node, transfer.index, transfer.sub,
                   fmt::format("{} is in the device, and not in the sheet", place));
  }
  const std::size_t length = byte_length(static_cast<DataType>(entry->data_type));
  if (length != 0 && length != transfer.size) {
    return differs(
        at, node, transfer.index, transfer.sub,
        fmt::format("{} has {} bytes, and by the sheet {}", place, transfer.size, length));
  }
  const auto wanted = said(*entry, node);
  if (!wanted || length == 0 || length > sizeof(std::uint64_t)) return;
  if (!is_fixed(transfer.index, transfer.sub, *entry)) return;
  const std::uint64_t is = load_unsigned(transfer.bytes);
  const std::uint64_t mask = length == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << length * 8) - 1;
  const std::uint64_t should_be = static_cast<std::uint64_t>(*wanted) & mask;
  if (is == should_be) return;
  const auto digits = static_cast<int>(2 * length);
  differs(at, node, transfer.index, transfer.sub,
          fmt::format("{} is {:0{}X}h, and by the sheet {:0{}X}h", place, is, digits, should_be,
                      digits));
}

void SheetWatch::refused(Time at, NodeId node, const formats::DataSheet& sheet,
                         const Frame& frame) {
  const sdo::Message message(frame);
  if (!is_absent(static_cast<AbortCode>(message.value()))) return;
  const std::uint16_t index = message.multiplexer().index();
  const std::uint8_t sub = message.multiplexer().sub();
  if (sheet.find(index, sub) == nullptr) return;
  differs(at, node, index, sub,
          fmt::format("{} is in the sheet, and not in the device", object_text(index, sub)));
}

void SheetWatch::differs(Time at, NodeId node, std::uint16_t index, std::uint8_t sub,
                         std::string text) {
  constexpr std::size_t differences_max = 1024;
  const std::tuple key(node, index, sub);
  if (differences_.size() == differences_max && !differences_.contains(key)) return;
  Difference& difference = differences_[key];
  difference.text = std::move(text);
  difference.tally.add(at);
}

namespace {

/// Objects that may take long: flash memory is erased, or written.
bool may_take_long(std::uint16_t index) {
  constexpr std::uint16_t program_first = 0x1F50;
  constexpr std::uint16_t program_last = 0x1F57;
  return index == object_index::store_parameters || index == object_index::restore_parameters ||
         (index >= program_first && index <= program_last);
}

bool is_time_out(const Frame& frame) {
  return sdo::Message(frame).value() == static_cast<std::uint32_t>(AbortCode::time_out);
}

}  // namespace

void SdoWatch::hear(Time at, const Frame& frame, const decoder::Decoded& decoded, bool is_there) {
  if (!is_node_id(decoded.node) || frame.length != Frame::length_max) return;
  constexpr std::size_t channels_max = 4096;
  if (channels_.size() == channels_max && !channels_.contains(decoded.channel)) return;
  Channel& channel = channels_[decoded.channel];
  channel.server = decoded.node;
  if (decoded.about != nullptr) {
    channel.index = decoded.about->index;
    channel.sub = decoded.about->sub;
  }
  if (decoded.service == decoder::Decoded::Service::sdo_request) {
    take_request(channel, at, frame, decoded);
    channel.is_waiting = channel.is_waiting && is_there;
  } else {
    take_answer(channel, at, decoded);
  }
}

void SdoWatch::take_request(Channel& channel, Time at, const Frame& frame,
                            const decoder::Decoded& decoded) {
  using decoder::SdoMessage;
  const bool is_abort = decoded.message == SdoMessage::abort;
  // Segments of a block are answered together.
  const bool goes_on = decoded.message == SdoMessage::block_segment;
  if (channel.is_waiting && !goes_on) ++channel.owed;
  if (is_abort) {
    if (channel.is_waiting && is_time_out(frame)) missed(channel, at);
  } else if (channel.is_waiting && !goes_on && at - channel.latest >= SdoWatch::slow_from) {
    missed(channel, at);
  }
  channel.is_waiting = !is_abort && decoded.message != SdoMessage::block_upload_done;
  channel.is_answered = false;
  channel.latest = at;
}

void SdoWatch::take_answer(Channel& channel, Time at, const decoder::Decoded& decoded) {
  using decoder::SdoMessage;
  constexpr Duration twice_within = 100ms;
  HeardServer& server = servers_.at(channel.server);
  const bool is_block = decoded.message == SdoMessage::block_segment ||
                        decoded.message == SdoMessage::block_upload_end;
  ++server.answers;
  if (channel.is_waiting) {
    const Duration took = at - channel.latest;
    if (took >= slow_from && !may_take_long(channel.index)) {
      server.slow.add(at);
      if (took > server.slowest) {
        server.slowest = took;
        server.index = channel.index;
        server.sub = channel.sub;
      }
    }
    channel.is_answered = !is_block;
  } else if (channel.owed != 0) {
    --channel.owed;
  } else if (channel.is_answered && !is_block && at - channel.latest <= twice_within) {
    server.doubles.add(at);
  }
  channel.is_waiting = false;
  channel.latest = at;
}

void SdoWatch::missed(const Channel& channel, Time at) {
  if (may_take_long(channel.index)) return;
  HeardServer& server = servers_.at(channel.server);
  server.time_outs.add(at);
  server.index = channel.index;
  server.sub = channel.sub;
}

void SdoWatch::end(Time at) {
  for (auto& [id, channel] : channels_) {
    if (channel.is_waiting && at - channel.latest >= answer_most) missed(channel, at);
  }
}

void SdoWatch::restarted(NodeId server) {
  for (auto& [id, channel] : channels_) {
    if (channel.server != server) continue;
    channel.is_waiting = channel.is_answered = false;
    channel.owed = 0;
  }
}

}  // namespace canvoy::text
