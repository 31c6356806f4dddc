// Numbers of the pcapng format (draft-ietf-opsawg-pcapng), for its reader and its writer.
#pragma once

#include <cstdint>

namespace canvoy::formats {

inline constexpr std::uint32_t section_block = 0x0A0D0D0A;  ///< a file begins with it
inline constexpr std::uint32_t interface_block = 1;         ///< a bus
inline constexpr std::uint32_t packet_block = 6;            ///< a frame, with its time

inline constexpr std::uint16_t option_name = 2;   ///< of an interface
inline constexpr std::uint16_t option_flags = 2;  ///< of a packet

}  // namespace canvoy::formats
