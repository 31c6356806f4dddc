#include "canvoy/can/frame_text.hpp"

#include <cstring>

namespace canvoy {

namespace {

constexpr std::uint32_t error_flag = 0x2000'0000;  // CAN_ERR_FLAG of SocketCAN
constexpr unsigned no_digit = 16;

constexpr unsigned digit_of(char character) {
  if (character >= '0' && character <= '9') return static_cast<unsigned>(character - '0');
  if (character >= 'A' && character <= 'F') return static_cast<unsigned>(character - 'A') + 10;
  if (character >= 'a' && character <= 'f') return static_cast<unsigned>(character - 'a') + 10;
  return no_digit;
}

constexpr ParsedFrame refused(FrameTextError error) {
  return {Frame{}, error};
}

// `_9` to `_F` after eight bytes: the DLC on the wire.
bool is_raw_dlc(std::string_view text) {
  return text.size() == 2 && text[0] == '_' && digit_of(text[1]) > 8 &&
         digit_of(text[1]) < no_digit;
}

FrameTextError parse_identifier(std::string_view digits, Frame& frame) {
  for (const char character : digits) {
    const unsigned digit = digit_of(character);
    if (digit == no_digit) return FrameTextError::identifier_digit;
    frame.id = frame.id << 4 | digit;
  }
  if (digits.size() == 3) {
    return frame.id <= Frame::id_max ? FrameTextError::none : FrameTextError::identifier_range;
  }
  if ((frame.id & ~(Frame::extended_id_max | error_flag)) != 0)
    return FrameTextError::identifier_range;
  frame.flags = (frame.id & error_flag) != 0 ? FrameFlags::error : FrameFlags::extended;
  frame.id &= Frame::extended_id_max;
  return FrameTextError::none;
}

FrameTextError parse_remote(std::string_view text, Frame& frame) {
  if (frame.is_error()) return FrameTextError::remote_error;
  frame.flags = frame.flags | FrameFlags::remote;
  if (text.empty()) return FrameTextError::none;
  const unsigned length = digit_of(text[0]);
  if (length > Frame::length_max) return FrameTextError::remote_length;
  frame.length = static_cast<std::uint8_t>(length);
  text.remove_prefix(1);
  if (text.empty() || (length == Frame::length_max && is_raw_dlc(text)))
    return FrameTextError::none;
  return FrameTextError::remote_length;
}

FrameTextError parse_data(std::string_view text, Frame& frame) {
  while (!text.empty()) {
    if (frame.length > 0 && text[0] == '.') text.remove_prefix(1);
    if (frame.length == Frame::length_max) {
      return is_raw_dlc(text) ? FrameTextError::none : FrameTextError::data_length;
    }
    if (text.size() < 2) return FrameTextError::data_digit;
    const unsigned high = digit_of(text[0]);
    const unsigned low = digit_of(text[1]);
    if (high == no_digit || low == no_digit) return FrameTextError::data_digit;
    frame.data[frame.length++] = static_cast<std::uint8_t>(high << 4 | low);
    text.remove_prefix(2);
  }
  return FrameTextError::none;
}

FrameTextError parse_into(std::string_view text, Frame& frame) {
  const std::size_t hash = text.find('#');
  if (hash != 3 && hash != 8) return FrameTextError::identifier_length;
  const FrameTextError error = parse_identifier(text.substr(0, hash), frame);
  if (error != FrameTextError::none) return error;
  text.remove_prefix(hash + 1);
  if (text.starts_with('#')) return FrameTextError::fd;
  if (text.starts_with('R') || text.starts_with('r')) return parse_remote(text.substr(1), frame);
  return parse_data(text, frame);
}

constexpr char digits_of_hex[] = "0123456789ABCDEF";
constexpr std::array<char, 512> pairs_of_hex = [] {
  std::array<char, 512> made{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    made[2 * byte] = digits_of_hex[byte >> 4];
    made[2 * byte + 1] = digits_of_hex[byte & 0xF];
  }
  return made;
}();

}  // namespace

FrameText::FrameText(const Frame& frame) {
  if (frame.is_error()) {
    put_hex((frame.id & Frame::extended_id_max) | error_flag, 8);
  } else if (frame.is_extended() || frame.id >> 12 != 0) {
    put_hex(frame.id, frame.is_extended() ? 8 : 3);
  } else {
    characters_[0] = digits_of_hex[frame.id >> 8];
    std::memcpy(&characters_[1], &pairs_of_hex[std::size_t{2} * (frame.id & 0xFF)], 2);
    length_ = 3;
  }
  put('#');
  if (frame.is_remote()) {
    put('R');
    if (frame.length > 0) put_hex(frame.length, 1);
    return;
  }
  // All bytes, whatever the length: a loop whose end differs from frame to frame is not predicted.
  static_assert(length_max >= 8 + 1 + 2 * Frame::length_max);
  char* const at = characters_.data() + length_;
  for (std::size_t i = 0; i < Frame::length_max; ++i)
    std::memcpy(at + 2 * i, &pairs_of_hex[std::size_t{2} * frame.data[i]], 2);
  length_ += 2 * std::size_t{frame.length};
}

void FrameText::put_hex(std::uint32_t value, int digits) {
  char* at = characters_.data() + length_;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    *at++ = digits_of_hex[value >> shift & 0xF];
  }
  length_ = static_cast<std::size_t>(at - characters_.data());
}

std::string_view describe(FrameTextError error) {
  switch (error) {
    case FrameTextError::none:
      return "";
    case FrameTextError::identifier_length:
      return "the identifier needs 3 or 8 hexadecimal digits and a #";
    case FrameTextError::identifier_digit:
      return "the identifier is not hexadecimal";
    case FrameTextError::identifier_range:
      return "the identifier is above 7FF (3 digits) or 1FFFFFFF (8 digits)";
    case FrameTextError::data_digit:
      return "the data is not made of pairs of hexadecimal digits";
    case FrameTextError::data_length:
      return "there are more than 8 bytes of data";
    case FrameTextError::remote_length:
      return "the length behind R is not one digit from 0 to 8";
    case FrameTextError::remote_error:
      return "an error frame cannot be remote";
    case FrameTextError::fd:
      return "it is a CAN FD frame";
  }
  return "";
}

ParsedFrame parse_frame(std::string_view text) {
  Frame frame;
  const FrameTextError error = parse_into(text, frame);
  return error == FrameTextError::none ? ParsedFrame{frame, error} : refused(error);
}

}  // namespace canvoy
