#include "canvoy/formats/trace/trace_packet.hpp"

#include <algorithm>
#include <array>

namespace canvoy::formats {

namespace {

constexpr std::uint8_t fd_flag = 0x04;
constexpr std::size_t frame_header_size = 8;

FrameFlags flags_of(std::uint32_t word) {
  if ((word & error_flag) != 0) return FrameFlags::error;
  const FrameFlags flags = (word & extended_flag) != 0 ? FrameFlags::extended : FrameFlags::none;
  return (word & remote_flag) != 0 ? flags | FrameFlags::remote : flags;
}

}  // namespace

TraceStep read_can_packet(std::string_view packet, TraceFrame& read) {
  Frame& frame = read.frame;
  if (packet.size() < frame_header_size)
    return bad_record("the packet is shorter than a CAN frame");
  const std::uint32_t word = FileNumbers{true}.u32(packet, 0);
  const auto length = static_cast<std::uint8_t>(packet[4]);
  const auto fd_flags = static_cast<std::uint8_t>(packet[5]);
  frame = {};
  frame.flags = flags_of(word);
  frame.id = word & Frame::extended_id_max;
  if (length > Frame::length_max || (fd_flags & fd_flag) != 0) {
    read.fd = {.flags = static_cast<std::uint8_t>(fd_flags & 3U)};
    const std::size_t count =
        std::min<std::size_t>({length, read.fd.data.size(), packet.size() - frame_header_size});
    read.fd.length = static_cast<std::uint8_t>(count);
    std::memcpy(read.fd.data.data(), packet.data() + frame_header_size, count);
    return {TraceItem::fd, 0, {}};
  }
  frame.length = length;
  if (!frame.is_extended() && !frame.is_error() && frame.id > Frame::id_max)
    return bad_record("the identifier has more than 11 bits, but not the flag of 29");
  if (frame.is_remote()) return {TraceItem::frame, 0, {}};
  if (packet.size() < frame_header_size + length)
    return bad_record("the packet has fewer bytes than its length says");
  std::memcpy(frame.data.data(), packet.data() + frame_header_size, length);
  return {TraceItem::frame, 0, {}};
}

void append_can_packet(std::string& bytes, const Frame& frame) {
  std::uint32_t word = frame.id;
  if (frame.is_extended()) word |= extended_flag;
  if (frame.is_remote()) word |= remote_flag;
  if (frame.is_error()) word |= error_flag;
  std::array<char, frame_header_size + Frame::length_max> packet{};
  for (std::size_t at = 0; at < 4; ++at) packet[at] = static_cast<char>(word >> (24 - 8 * at));
  packet[4] = static_cast<char>(frame.length);
  std::memcpy(&packet[frame_header_size], frame.data.data(), frame.data.size());
  bytes.append(packet.data(), frame_header_size + frame.payload().size());
}

}  // namespace canvoy::formats
