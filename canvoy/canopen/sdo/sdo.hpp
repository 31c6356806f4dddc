// The messages of SDO: eight bytes, taken apart and assembled in a register (CiA 301, 7.2.4.3).
//
//     sdo::Message request(frame);
//     if (request.request() == sdo::Request::initiate_upload) look_up(request.multiplexer());
//     Frame answer = sdo::Message(first_byte, multiplexer, value).frame(can_id);
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/machine.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/sdo/crc16.hpp"

namespace canvoy::sdo {

/// Command of a client: the upper three bits of its first byte.
enum class Request : std::uint8_t {
  download_segment = 0,
  initiate_download = 1,
  initiate_upload = 2,
  upload_segment = 3,
  abort = 4,
  block_upload = 5,
  block_download = 6,
};

/// Command of a server: the upper three bits of its first byte.
enum class Response : std::uint8_t {
  upload_segment = 0,
  download_segment = 1,
  initiate_upload = 2,
  initiate_download = 3,
  abort = 4,
  block_download = 5,
  block_upload = 6,
};

inline constexpr std::size_t expedited_max = 4;   ///< bytes of a value that needs no segments
inline constexpr std::size_t segment_max = 7;     ///< bytes in one segment
inline constexpr std::uint8_t toggle_bit = 0x10;  ///< of segments; 0 in the first one
/// If a register holds a whole segment, nearly all segments take a fast path: those of values in
/// memory that are full and not the last one. The code for the others is kept out of line, since
/// the fast path would otherwise have to save registers for it. On small machines code size matters
/// more.
inline constexpr bool has_short_way = !is_small_machine;

/// The first byte of a message.
constexpr std::uint8_t command(Request request, unsigned flags = 0) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(request) << 5 | flags);
}
/// The first byte of an answer.
constexpr std::uint8_t command(Response response, unsigned flags = 0) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(response) << 5 | flags);
}

/// Flags of an initiate message with all of the data, 1 to 4 bytes: e = 1, s = 1, n unused bytes.
constexpr unsigned expedited(std::size_t size) {
  return static_cast<unsigned>((expedited_max - size) << 2) | 0x03U;
}
/// Flag of an initiate message with the number of bytes that follow in segments: e = 0, s = 1.
inline constexpr unsigned size_indicated = 0x01;
/// Flags of a segment of `size` bytes: toggle bit, n unused bytes, c = no more follow.
constexpr unsigned segment(std::uint8_t toggle, std::size_t size, bool last) {
  return toggle | static_cast<unsigned>((segment_max - size) << 1) | (last ? 1U : 0U);
}

inline constexpr std::uint8_t block_size_max = 127;  ///< segments in one block

/// Messages of a block transfer: in the lower two bits of the first byte. In a message that
/// announces a block (initiate), or its end by the sender of the data, the second bit has another
/// meaning.
inline constexpr unsigned block_initiate = 0;
inline constexpr unsigned block_end = 1;          ///< of the transfer
inline constexpr unsigned block_acknowledge = 2;  ///< of the segments of a block
inline constexpr unsigned block_start = 3;        ///< of an upload

/// Flags of an initiate message of a block transfer: the sender supports checksums; the size is
/// indicated.
inline constexpr unsigned block_crc = 0x04;
inline constexpr unsigned block_size_indicated = 0x02;  ///< of an initiate message
/// Flag in the first byte of a block's segment, beside its number: no more follow.
inline constexpr std::uint8_t block_last = 0x80;

/// Object of a transfer: bytes 1 to 3 of initiate and abort messages.
class Multiplexer {
 public:
  constexpr Multiplexer() = default;
  /// Names an entry; index and sub-index are any.
  constexpr Multiplexer(std::uint16_t index, std::uint8_t sub)
      : bits_(static_cast<std::uint32_t>(index) << 8 | static_cast<std::uint32_t>(sub) << 24) {}

  /// Index, 0000h to FFFFh.
  constexpr std::uint16_t index() const { return static_cast<std::uint16_t>(bits_ >> 8); }
  /// Sub-index, 00h to FFh.
  constexpr std::uint8_t sub() const { return static_cast<std::uint8_t>(bits_ >> 24); }
  friend constexpr bool operator==(Multiplexer, Multiplexer) = default;

 private:
  friend class Message;
  constexpr explicit Multiplexer(std::uint64_t message)
      : bits_(static_cast<std::uint32_t>(message) & 0xFFFF'FF00) {}

  std::uint32_t bits_ = 0;  ///< in their position in a message
};

/// A message of eight bytes, of either direction. Whether a part has a meaning depends on the
/// command: no access checks it.
class Message {
 public:
  /// Takes a frame with eight bytes.
  explicit Message(const Frame& frame) : Message(frame.data) {}
  /// Takes the eight bytes of a frame.
  explicit Message(const std::array<std::uint8_t, Frame::length_max>& bytes)
      : bits_(std::bit_cast<std::uint64_t>(bytes)) {}

  /// Makes an initiate or abort message. `data` are bytes 4 to 7: data, a size, or an abort code.
  constexpr Message(std::uint8_t byte, Multiplexer mux, std::uint32_t data = 0)
      : bits_(byte | mux.bits_ | std::uint64_t{data} << 32) {}
  /// Makes an abort message.
  constexpr Message(Multiplexer mux, AbortCode code)
      : Message(command(Request::abort), mux, static_cast<std::uint32_t>(code)) {}
  /// Makes a confirmation of a segment, or a request for one.
  constexpr explicit Message(std::uint8_t byte) : bits_(byte) {}
  /// Makes an acknowledgement of a block, or its end with a checksum: `low` is byte 1, `high` byte
  /// 2.
  constexpr Message(std::uint8_t byte, std::uint8_t low, std::uint8_t high)
      : bits_(byte | static_cast<unsigned>(low) << 8 | static_cast<unsigned>(high) << 16) {}

  /// Command and flags.
  constexpr std::uint8_t first_byte() const { return static_cast<std::uint8_t>(bits_); }
  /// Command, if the message is from a client; 7 is not assigned.
  constexpr Request request() const { return static_cast<Request>(first_byte() >> 5); }
  /// Command, if the message is from a server; 7 is not assigned.
  constexpr Response response() const { return static_cast<Response>(first_byte() >> 5); }
  /// Object, in initiate and abort messages.
  constexpr Multiplexer multiplexer() const { return Multiplexer(bits_); }
  /// Bytes 4 to 7: data, a size in bytes, or an abort code.
  constexpr std::uint32_t value() const { return static_cast<std::uint32_t>(bits_ >> 32); }
  /// Reason, in an abort message; codes that CiA 301 does not list are possible.
  constexpr AbortCode abort_code() const { return static_cast<AbortCode>(value()); }

  // For an initiate message:
  /// True if the data is in this message (e = 1).
  constexpr bool is_expedited() const { return (bits_ & 0x02) != 0; }
  /// True if the size is indicated (s = 1).
  constexpr bool has_size() const { return (bits_ & size_indicated) != 0; }
  /// Size 1 to 4; only for an expedited message that has_size().
  constexpr std::size_t expedited_size() const { return expedited_max - (bits_ >> 2 & 0x03); }

  // For a segment:
  /// Toggle bit in its place: 0 or 10h.
  constexpr std::uint8_t toggle() const {
    return static_cast<std::uint8_t>(first_byte() & toggle_bit);
  }
  /// True if no more segments follow (c = 1).
  constexpr bool is_last() const { return (bits_ & 0x01) != 0; }
  /// Size 0 to 7.
  constexpr std::size_t segment_size() const { return segment_max - (bits_ >> 1 & 0x07); }

  // For block transfers:
  /// What the lower two bits say: block_initiate to block_start.
  constexpr unsigned block_command() const { return first_byte() & 0x03U; }
  /// True in an initiate message's place for the end of the transfer.
  constexpr bool is_block_end() const { return (bits_ & block_end) != 0; }
  /// True if the sender supports checksums.
  constexpr bool has_block_crc() const { return (bits_ & block_crc) != 0; }
  /// True if the size of the whole value is in bytes 4 to 7.
  constexpr bool has_block_size() const { return (bits_ & block_size_indicated) != 0; }
  /// Number of segments in the next block, in an initiate message.
  constexpr std::uint8_t block_size() const { return static_cast<std::uint8_t>(bits_ >> 32); }
  /// The protocol switch threshold: number of bytes up to which an upload may continue without
  /// blocks.
  constexpr std::uint8_t switch_threshold() const { return static_cast<std::uint8_t>(bits_ >> 40); }
  /// Number of a segment: 1 to 127 if it is one.
  constexpr std::uint8_t sequence_number() const { return first_byte() & 0x7FU; }
  /// True if the segment is the last one of the transfer.
  constexpr bool is_block_last() const { return (bits_ & block_last) != 0; }
  /// In an acknowledgement: the last segment received in sequence, and the segments of the next
  /// block.
  constexpr std::uint8_t acknowledged() const { return static_cast<std::uint8_t>(bits_ >> 8); }
  /// In an acknowledgement: segments of the next block, 1 to 127 if it is valid.
  constexpr std::uint8_t next_block_size() const { return static_cast<std::uint8_t>(bits_ >> 16); }
  /// In the end message: bytes of the last segment that are not data, and the checksum.
  constexpr std::size_t block_unused() const { return bits_ >> 2 & 0x07; }
  /// In the end message: CRC-16-CCITT of all data, or 0 without checksums.
  constexpr std::uint16_t crc() const { return static_cast<std::uint16_t>(bits_ >> 8); }
  /// True if a segment could be the end message that follows it, which has zeros after its
  /// checksum.
  constexpr bool looks_like_block_end() const {
    return (first_byte() & 0xE3U) == command(Request::block_download, block_end) &&
           bits_ >> 24 == 0;
  }

  friend constexpr bool operator==(Message, Message) = default;

  /// Stores the data of a segment with seven bytes, followed by a zero.
  void store_full_segment(std::uint8_t* to) const { store(to, bits_ >> 8); }
  /// Checksum of a segment, after that of the preceding ones.
  std::uint16_t segment_crc(std::size_t size, std::uint16_t crc) const {
    return crc16_of_segment(bits_, size, crc);
  }

  /// The eight bytes as they are sent.
  constexpr std::array<std::uint8_t, Frame::length_max> bytes() const {
    return std::bit_cast<std::array<std::uint8_t, Frame::length_max>>(bits_);
  }

  /// Frame with the message, written at once, as one vector if available: a reader that copies it
  /// while its parts are still on their way to memory would have to wait for them.
  constexpr Frame frame(std::uint16_t can_id) const {
    if constexpr (is_small_machine) {
      return {.id = can_id, .length = Frame::length_max, .data = bytes()};
    }
    constexpr std::uint64_t length = std::uint64_t{Frame::length_max} << 40;
    using Words [[gnu::vector_size(sizeof(Frame))]] = std::uint64_t;
    return std::bit_cast<Frame>(Words{can_id | length, bits_});
  }

 private:
  friend Message segment_message(std::uint8_t first_byte, std::span<const std::uint8_t> bytes);
  friend Message full_segment_message(std::uint8_t first_byte, const std::uint8_t* bytes);
  std::uint64_t bits_;
};

/// Copies the data of a segment. Nearly all segments are full, and need no call.
inline void copy_segment(std::span<const std::uint8_t> from, std::uint8_t* to) {
  if (has_short_way && from.size() == segment_max) {
    std::memcpy(to, from.data(), segment_max);
  } else if (!from.empty()) {
    std::memcpy(to, from.data(), from.size());
  }
}

/// Message with up to seven bytes of a segment, after its first byte.
inline Message segment_message(std::uint8_t first_byte, std::span<const std::uint8_t> bytes) {
  if constexpr (is_small_machine) {
    std::array<std::uint8_t, Frame::length_max> message{first_byte};
    if (!bytes.empty()) std::memcpy(&message[1], bytes.data(), bytes.size());
    return Message(message);
  }
  std::uint64_t bits = 0;
  if (has_short_way && bytes.size() == segment_max) {
    bits = load<std::uint32_t>(bytes.data()) | std::uint64_t{load<std::uint32_t>(bytes.data() + 3)}
                                                   << 24;
  } else if (!bytes.empty()) {
    bits = load_unsigned(bytes);
  }
  Message segment(first_byte);
  segment.bits_ |= bits << 8;
  return segment;
}

/// Message with a full segment; at least one more byte follows its seven in memory.
inline Message full_segment_message(std::uint8_t first_byte, const std::uint8_t* bytes) {
  Message segment(first_byte);
  segment.bits_ |= load<std::uint64_t>(bytes) << 8;
  return segment;
}

/// Converts the data of an expedited message, 1 to 4 bytes, to the form of the register, and back.
/// No loop and no call: most SDO data passes here.
inline std::uint32_t pack(std::span<const std::uint8_t> bytes) {
  if constexpr (is_small_machine) return load_word(bytes);
  const std::uint8_t* from = bytes.data();
  switch (bytes.size()) {
    case 1:
      return *from;
    case 2:
      return load<std::uint16_t>(from);
    case 3:
      return load<std::uint16_t>(from) | static_cast<std::uint32_t>(from[2]) << 16;
    default:
      return load<std::uint32_t>(from);
  }
}
/// Stores 1 to 4 bytes of the register: as many as `bytes` has.
inline void unpack(std::uint32_t value, std::span<std::uint8_t> bytes) {
  std::uint8_t* to = bytes.data();
  if constexpr (is_small_machine) {
    std::memcpy(to, &value, bytes.size());
    return;
  }
  switch (bytes.size()) {
    case 1:
      *to = static_cast<std::uint8_t>(value);
      return;
    case 2:
      return store(to, static_cast<std::uint16_t>(value));
    case 3:
      store(to, static_cast<std::uint16_t>(value));
      to[2] = static_cast<std::uint8_t>(value >> 16);
      return;
    default:
      return store(to, value);
  }
}

}  // namespace canvoy::sdo
