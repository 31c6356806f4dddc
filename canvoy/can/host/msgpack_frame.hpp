// A frame as one msgpack map, as python-can 4.1 sends it over UDP multicast.
//
//     MsgpackFrame datagram(frame, seconds_since_1970);
//     send(datagram.bytes());
//     DecodedFrame decoded = decode_msgpack_frame(bytes);
//     if (decoded.kind == FrameKind::classic) ...
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "canvoy/can/frame.hpp"

namespace canvoy::host {

/// Encodes the datagram, byte for byte like python-can: its order of keys, the shortest form of
/// each number, the time stamp as a 64-bit float.
class MsgpackFrame {
 public:
  static constexpr std::size_t size_max = 192;  ///< bytes of the longest datagram

  /// Encodes a frame; `timestamp` in seconds since 1970.
  MsgpackFrame(const Frame& frame, double timestamp);
  /// The datagram, valid as long as this object.
  std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

 private:
  void put(std::uint8_t byte) { bytes_[size_++] = byte; }
  void put_key(std::string_view key);
  void put_big_endian(std::uint64_t value, int size);
  void put_unsigned(std::uint32_t value);
  void put_float(double value);
  void put_data(std::span<const std::uint8_t> data);
  void put_flag(std::string_view key, bool value);

  std::array<std::uint8_t, size_max> bytes_{};
  std::size_t size_ = 0;
};

/// What a datagram holds.
enum class FrameKind : std::uint8_t { malformed, classic, fd };

/// Result of decoding; `frame` is empty unless it is a classic one.
struct DecodedFrame {
  FrameKind kind = FrameKind::malformed;  ///< malformed: nothing else counts
  Frame frame;                            ///< empty unless classic
};

/// Decodes strictly: one map of known keys with values of their types, each once, in any order,
/// nothing behind it; arbitration_id and is_extended_id are mandatory, identifier and length must
/// be in range and agree with the data (a remote frame has none). The time stamp and the channel
/// are checked and dropped. Cost: linear, no heap.
DecodedFrame decode_msgpack_frame(std::span<const std::uint8_t> bytes);

}  // namespace canvoy::host
