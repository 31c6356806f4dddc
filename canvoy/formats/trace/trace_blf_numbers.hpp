// Numbers of Vector BLF, for its reader and its writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace canvoy::formats {

inline constexpr std::string_view blf_file_mark = "LOGG";    ///< a file begins with it
inline constexpr std::string_view blf_object_mark = "LOBJ";  ///< an object begins with it
inline constexpr std::size_t blf_header_size = 144;          ///< bytes of the head of a file
inline constexpr std::size_t blf_base_size = 16;  ///< bytes of the part that all objects share
inline constexpr std::size_t blf_object_header_size = 32;  ///< with time and flags
/// With the size of what is compressed.
inline constexpr std::size_t blf_container_header_size = 32;

/// Types of objects that are read.
enum class BlfKind : std::uint32_t {
  message = 1,
  error = 2,
  container = 10,
  error_ext = 73,
  message_2 = 86,
  fd_message = 100,
  fd_message_64 = 101,
};

/// Bit in the flags of a message.
inline constexpr std::uint8_t blf_sent_bit = 0x01;
inline constexpr std::uint8_t blf_remote_bit = 0x80;  ///< in the flags of a message

}  // namespace canvoy::formats
