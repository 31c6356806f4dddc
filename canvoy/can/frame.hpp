// A CAN data, remote or error frame, as nodes, buses and logs exchange it (ISO 11898-1).
//
//     Frame sync = Frame::data_frame(0x080, {});
//     Frame ask = Frame::remote_frame(0x185, 8);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace canvoy {

/// Properties of a frame beside its identifier. The remaining bits are reserved for CAN FD (FD,
/// BRS, ESI).
enum class FrameFlags : std::uint8_t { none = 0, extended = 1, remote = 2, error = 4 };

constexpr FrameFlags operator|(FrameFlags a, FrameFlags b) {
  return static_cast<FrameFlags>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// True if one of the bits in `flag` is among `flags`.
constexpr bool has(FrameFlags flags, FrameFlags flag) {
  return (static_cast<unsigned>(flags) & static_cast<unsigned>(flag)) != 0;
}

/// A classic CAN frame in 16 bytes, copied by value. Bytes of `data` beyond `length`, and all of
/// them in a remote frame, are zero, so that equal frames compare equal.
struct Frame {
  static constexpr std::uint32_t id_max = 0x7FF;                 ///< of 11 bits
  static constexpr std::uint32_t extended_id_max = 0x1FFF'FFFF;  ///< of 29 bits
  static constexpr std::uint8_t length_max = 8;                  ///< bytes of a classical CAN frame

  /// 11 or 29 bits; in an error frame, the error class as SocketCAN numbers it.
  std::uint32_t id = 0;
  FrameFlags flags = FrameFlags::none;  ///< kind of frame
  std::uint8_t length = 0;              ///< 0 to 8 bytes; in a remote frame, the requested length
  std::uint16_t reserved = 0;           ///< always 0, so that frames compare as memory
  std::array<std::uint8_t, length_max> data{};  ///< bytes in the order of the bus

  /// Makes a data frame; bytes beyond the eighth are dropped, an identifier above 7FFh makes it a
  /// 29-bit frame.
  static constexpr Frame data_frame(std::uint32_t id, std::span<const std::uint8_t> bytes) {
    Frame frame = remote_frame(
        id, static_cast<std::uint8_t>(bytes.size() < length_max ? bytes.size() : length_max));
    frame.flags = id > id_max ? FrameFlags::extended : FrameFlags::none;
    std::copy_n(bytes.begin(), frame.length, frame.data.begin());
    return frame;
  }
  /// Like the above, with the bytes in place.
  static constexpr Frame data_frame(std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
    return data_frame(id, std::span<const std::uint8_t>(bytes.begin(), bytes.size()));
  }

  /// Makes a remote frame that requests `length` bytes.
  static constexpr Frame remote_frame(std::uint32_t id, std::uint8_t length) {
    Frame frame;
    frame.id = id & extended_id_max;
    frame.flags = id > id_max ? FrameFlags::extended | FrameFlags::remote : FrameFlags::remote;
    frame.length = length < length_max ? length : length_max;
    return frame;
  }

  /// True for a 29-bit identifier.
  constexpr bool is_extended() const { return has(flags, FrameFlags::extended); }
  /// True for a request without data (RTR).
  constexpr bool is_remote() const { return has(flags, FrameFlags::remote); }
  /// True for an error frame: not on the wire, but a report of the controller.
  constexpr bool is_error() const { return has(flags, FrameFlags::error); }
  /// True if it is neither extended nor remote nor an error frame: the only kind that CANopen
  /// sends, except for a few remote requests.
  constexpr bool is_plain() const { return flags == FrameFlags::none; }

  /// Payload: `length` bytes, none in a remote frame.
  constexpr std::span<const std::uint8_t> payload() const {
    return {data.data(), is_remote() ? std::size_t{0} : std::size_t{length}};
  }

  friend constexpr bool operator==(const Frame&, const Frame&) = default;
};
static_assert(sizeof(Frame) == 16, "a frame is copied on every hop: two machine words, no more");

}  // namespace canvoy
