// Writes and reads a frame as text in the format of can-utils: 185#1E2F, 00000185#R8,
// 20000004#0004000000000000 (an error frame).
//
//     FrameText text{Frame::data_frame(0x185, {0x1E, 0x2F})};
//     text.view();  // 185#1E2F
//     ParsedFrame parsed = parse_frame("123#DEADBEEF");
//     if (parsed) send(parsed.frame);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// Text of a frame. Three hexadecimal digits are an 11-bit identifier, eight a 29-bit one, or an
/// error frame if bit 29 is set. Data follows in pairs of upper-case digits; `R` is a remote frame,
/// followed by its length unless that is 0.
class FrameText {
 public:
  /// Characters of the longest text.
  static constexpr std::size_t length_max = 8 + 1 + 2 * Frame::length_max;

  /// Writes the text; constant time, no memory beyond the object.
  explicit FrameText(const Frame& frame);
  /// The text, valid as long as this object.
  std::string_view view() const { return {characters_.data(), length_}; }

 private:
  void put(char character) { characters_[length_++] = character; }
  void put_hex(std::uint32_t value, int digits);

  std::array<char, length_max> characters_{};
  std::size_t length_ = 0;
};

/// Why a text is not a classic CAN frame.
enum class FrameTextError : std::uint8_t {
  none,
  identifier_length,  ///< not 3 or 8 characters, or not followed by '#'
  identifier_digit,   ///< not hexadecimal
  identifier_range,   ///< 11 bits with 3 digits: 7FFh; 29 bits with 8: 1FFFFFFFh
  data_digit,         ///< not hexadecimal, or half a byte
  data_length,        ///< more than 8 bytes
  remote_length,      ///< `R` is followed by something other than 0 to 8
  remote_error,       ///< an error frame cannot be remote
  fd,                 ///< `##`: CAN FD, not supported
};

/// Short description of the error, as "the identifier needs 3 or 8 hexadecimal digits and a #".
std::string_view describe(FrameTextError error);

/// Result of parsing; `frame` is empty if there is an error.
struct ParsedFrame {
  Frame frame;                                  ///< empty if there is an error
  FrameTextError error = FrameTextError::none;  ///< why there is no frame
  explicit operator bool() const { return error == FrameTextError::none; }
};

/// Parses all of `text`. Accepts the format of FrameText, and also lower-case letters, dots between
/// bytes, and the raw DLC of 9 to F that newer can-utils append to 8 bytes as `_F` (it is dropped).
ParsedFrame parse_frame(std::string_view text);

}  // namespace canvoy
