#include "canvoy/text/doctor/sdo_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/sdo/sdo.hpp"

namespace canvoy::text {

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
