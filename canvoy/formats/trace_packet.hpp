// CAN frames in captures: the packet of link type 227 (LINKTYPE_CAN_SOCKETCAN), and the numbers of
// files that have the byte order of the machine that wrote them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/can/frame.hpp"
#include "canvoy/formats/trace_parser.hpp"

namespace canvoy::formats {

inline constexpr std::uint32_t link_type_can = 227;

/// Numbers of a file in its byte order. The bytes have to be there.
struct FileNumbers {
  bool big_endian = false;

  std::uint16_t u16(std::string_view bytes, std::size_t at) const {
    return static_cast<std::uint16_t>(number(bytes, at, 2));
  }
  std::uint32_t u32(std::string_view bytes, std::size_t at) const {
    return static_cast<std::uint32_t>(number(bytes, at, 4));
  }
  std::uint64_t u64(std::string_view bytes, std::size_t at) const { return number(bytes, at, 8); }

 private:
  std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size) const {
    std::uint64_t value = 0;
    for (std::size_t byte = 0; byte < size; ++byte) {
      const std::size_t place = at + (big_endian ? byte : size - 1 - byte);
      value = value << 8 | static_cast<std::uint8_t>(bytes[place]);
    }
    return value;
  }
};

/// The frame of a packet: an identifier of 4 bytes, big-endian, with flags; the length, the flags
/// of CAN FD, 2 reserved bytes, the data.
TraceStep read_can_packet(std::string_view packet, Frame& frame);

/// The same, written.
void append_can_packet(std::string& bytes, const Frame& frame);

}  // namespace canvoy::formats
