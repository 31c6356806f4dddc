#include "canvoy/gateway/visible_string.hpp"

#include <charconv>
#include <cstdio>

namespace canvoy::gateway {

namespace {

/// Letter after the backslash, and the byte that it represents.
constexpr std::string_view escape_letters = "abtnvfr\\\"'?";
constexpr std::string_view escaped_bytes = "\a\b\t\n\v\f\r\\\"'?";
/// The letters that are written; a quote is doubled instead.
constexpr std::string_view written_letters = escape_letters.substr(0, 8);

void append_escaped(std::string& text, std::uint8_t byte) {
  const std::size_t known =
      escaped_bytes.substr(0, written_letters.size()).find(static_cast<char>(byte));
  text += '\\';
  if (known != std::string_view::npos) {
    text += written_letters[known];
    return;
  }
  char octal[4];
  std::snprintf(octal, sizeof octal, "%03o", unsigned{byte});
  text += octal;
}

/// Takes a number of at most `digits_max` digits from the start of `text`.
std::optional<std::uint8_t> take_number(std::string_view& text, std::size_t digits_max, int base) {
  unsigned number = 0;
  const char* last = text.data() + std::min(digits_max, text.size());
  const auto [end, error] = std::from_chars(text.data(), last, number, base);
  if (error != std::errc{} || number > UINT8_MAX) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return static_cast<std::uint8_t>(number);
}

/// Byte of the escape sequence at the start of `text`, after its backslash.
std::optional<std::uint8_t> take_escape(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const char letter = text.front();
  if (letter >= '0' && letter <= '7') return take_number(text, 3, 8);
  text.remove_prefix(1);
  if (letter == 'x') return take_number(text, 2, 16);
  const std::size_t known = escape_letters.find(letter);
  if (known == std::string_view::npos) return std::nullopt;
  return static_cast<std::uint8_t>(escaped_bytes[known]);
}

}  // namespace

std::string quote(std::span<const std::uint8_t> bytes) {
  std::string text = "\"";
  for (const std::uint8_t byte : bytes) {
    if (byte < 0x20 || byte == 0x7F || byte == '\\') {
      append_escaped(text, byte);
    } else {
      if (byte == '"') text += '"';
      text += static_cast<char>(byte);
    }
  }
  return text + '"';
}

std::optional<std::vector<std::uint8_t>> unquote(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  if (!quoted) return std::vector<std::uint8_t>(text.begin(), text.end());
  text = text.substr(1, text.size() - 2);
  std::vector<std::uint8_t> bytes;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '\\') {
      const std::optional<std::uint8_t> byte = take_escape(text);
      if (!byte) return std::nullopt;
      bytes.push_back(*byte);
      continue;
    }
    if (c == '"') {
      if (!text.starts_with('"')) return std::nullopt;
      text.remove_prefix(1);
    }
    bytes.push_back(static_cast<std::uint8_t>(c));
  }
  return bytes;
}

}  // namespace canvoy::gateway
