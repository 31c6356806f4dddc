// CAN frames in captures: packets of link type 227 (LINKTYPE_CAN_SOCKETCAN), and numbers of files
// in the byte order of the machine that wrote them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

inline constexpr std::uint32_t link_type_can = 227;  ///< LINKTYPE_CAN_SOCKETCAN

// Flags beside the identifier in its word, as in SocketCAN.
inline constexpr std::uint32_t extended_flag = 0x8000'0000;  ///< 29-bit identifier
inline constexpr std::uint32_t remote_flag = 0x4000'0000;    ///< without data
inline constexpr std::uint32_t error_flag = 0x2000'0000;     ///< of the controller

/// Reads numbers of a file in its byte order. The bytes must exist.
struct FileNumbers {
  bool big_endian = false;  ///< as the head of the file tells

  /// Two bytes at `at`.
  std::uint16_t u16(std::string_view bytes, std::size_t at) const {
    return number<std::uint16_t>(bytes, at);
  }
  /// Four bytes at `at`.
  std::uint32_t u32(std::string_view bytes, std::size_t at) const {
    return number<std::uint32_t>(bytes, at);
  }
  /// Eight bytes at `at`.
  std::uint64_t u64(std::string_view bytes, std::size_t at) const {
    return number<std::uint64_t>(bytes, at);
  }

 private:
  static std::uint16_t swapped(std::uint16_t number) { return __builtin_bswap16(number); }
  static std::uint32_t swapped(std::uint32_t number) { return __builtin_bswap32(number); }
  static std::uint64_t swapped(std::uint64_t number) { return __builtin_bswap64(number); }

  template <class Number>
  Number number(std::string_view bytes, std::size_t at) const {
    Number value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return big_endian == (std::endian::native == std::endian::big) ? value : swapped(value);
  }
};

/// Appends the lowest `size` bytes, at most 8, lowest first.
inline void append_little(std::string& bytes, std::uint64_t value, unsigned size) {
  static_assert(std::endian::native == std::endian::little, "the bytes stand in this order");
  bytes.append(reinterpret_cast<const char*>(&value), size);
}

/// Reads the frame of a packet: an identifier of 4 bytes, big-endian, with flags; the length, the
/// flags of CAN FD, 2 reserved bytes, the data.
TraceStep read_can_packet(std::string_view packet, TraceFrame& frame);

/// Appends the packet of a frame, as read_can_packet() reads it.
void append_can_packet(std::string& bytes, const Frame& frame);

}  // namespace canvoy::formats
