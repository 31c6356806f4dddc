#include "canvoy/can/host/socketcand_message.hpp"

#include <algorithm>
#include <charconv>

namespace canvoy::host {

namespace {

constexpr std::size_t extended_digits = 8;
constexpr std::size_t timestamp_length_max = 32;

void append_hex(std::string& text, std::uint32_t value, int digits) {
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    text += "0123456789ABCDEF"[value >> shift & 0xF];
  }
}

std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

std::optional<std::uint32_t> parse_number(std::string_view text, int base) {
  std::uint32_t number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number, base);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

bool is_timestamp(std::string_view text) {
  return !text.empty() && text.size() <= timestamp_length_max &&
         std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

/// Appends pairs of digits; a single digit is a byte if it is a separate word.
bool append_bytes(Frame& frame, std::string_view word) {
  const bool is_single = word.size() == 1;
  if (!is_single && word.size() % 2 != 0) return false;
  for (std::size_t at = 0; at < word.size(); at += 2) {
    const auto byte = parse_number(word.substr(at, 2), 16);
    if (!byte || frame.length == Frame::length_max) return false;
    frame.data[frame.length++] = static_cast<std::uint8_t>(*byte);
  }
  return true;
}

std::optional<Frame> parse_data(Frame frame, std::string_view rest) {
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (!append_bytes(frame, word)) return std::nullopt;
  }
  return frame;
}

std::optional<Frame> parse_remote(Frame frame, std::string_view rest) {
  const auto length = parse_number(next_word(rest), 10);
  if (!length || *length > Frame::length_max || !next_word(rest).empty()) return std::nullopt;
  frame.flags = frame.flags | FrameFlags::remote;
  frame.length = static_cast<std::uint8_t>(*length);
  return frame;
}

std::optional<Frame> error_frame(std::uint32_t error_class) {
  if (error_class > Frame::extended_id_max) return std::nullopt;
  Frame frame;
  frame.id = error_class;
  frame.flags = FrameFlags::error;
  frame.length = Frame::length_max;
  return frame;
}

}  // namespace

std::string socketcand_send_message(const Frame& frame) {
  std::string text = frame.is_remote() ? "< sendrtr " : "< send ";
  append_hex(text, frame.id, frame.is_extended() ? static_cast<int>(extended_digits) : 3);
  text += ' ';
  append_hex(text, frame.length, 1);
  for (const std::uint8_t byte : frame.payload()) {
    text += ' ';
    append_hex(text, byte, 2);
  }
  return text + " >";
}

std::optional<Frame> parse_socketcand_frame(std::string_view message) {
  const std::string_view kind = next_word(message);
  if (kind != "frame" && kind != "rtr" && kind != "error") return std::nullopt;
  const std::string_view digits = next_word(message);
  const auto id = parse_number(digits, 16);
  if (!id || !is_timestamp(next_word(message))) return std::nullopt;
  if (kind == "error") return error_frame(*id);
  const bool is_extended = digits.size() == extended_digits;
  if (*id > (is_extended ? Frame::extended_id_max : Frame::id_max)) return std::nullopt;
  Frame frame;
  frame.id = *id;
  frame.flags = is_extended ? FrameFlags::extended : FrameFlags::none;
  return kind == "rtr" ? parse_remote(frame, message) : parse_data(frame, message);
}

std::optional<std::string_view> SocketcandMessages::next() {
  const std::size_t begin = bytes_.find('<', read_);
  if (begin == std::string::npos) {
    clear();
    return std::nullopt;
  }
  const std::size_t end = bytes_.find('>', begin);
  if (end == std::string::npos) {
    bytes_.erase(0, begin);
    read_ = 0;
    if (bytes_.size() > length_max) {
      ++malformed_;
      clear();
    }
    return std::nullopt;
  }
  read_ = end + 1;
  std::string_view message = std::string_view(bytes_).substr(begin + 1, end - begin - 1);
  while (message.starts_with(' ')) message.remove_prefix(1);
  while (message.ends_with(' ')) message.remove_suffix(1);
  return message;
}

void SocketcandMessages::clear() {
  bytes_.clear();
  read_ = 0;
}

}  // namespace canvoy::host
