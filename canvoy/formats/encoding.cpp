#include "canvoy/formats/encoding.hpp"

#include <algorithm>
#include <array>

#include "canvoy/formats/plain_text.hpp"

namespace canvoy::formats {

namespace {

constexpr char32_t replacement = 0xFFFD;
constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
constexpr std::size_t character_max = 4;

/// 80h to 9Fh; the other characters are those of Unicode.
constexpr std::array<char16_t, 32> windows_1252_characters = {
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::uint8_t octet_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

/// Writes 1 to 4 bytes; returns their number.
std::size_t put_utf8(char32_t character, char* into) {
  const auto put = [into](std::size_t at, char32_t value) { into[at] = static_cast<char>(value); };
  const auto rest = [character](unsigned shift) { return 0x80U | (character >> shift & 0x3FU); };
  if (character < 0x80) {
    put(0, character);
    return 1;
  }
  if (character < 0x800) {
    put(0, 0xC0U | character >> 6);
    put(1, rest(0));
    return 2;
  }
  if (character < 0x10000) {
    put(0, 0xE0U | character >> 12);
    put(1, rest(6));
    put(2, rest(0));
    return 3;
  }
  put(0, 0xF0U | character >> 18);
  put(1, rest(12));
  put(2, rest(6));
  put(3, rest(0));
  return 4;
}

/// Changes CR LF and CR to LF.
void end_lines_with_feeds(std::string& text) {
  if (text.find('\r') == std::string::npos) return;
  std::size_t to = 0;
  for (std::size_t from = 0; from < text.size(); ++from) {
    const bool is_of_pair = text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n';
    if (!is_of_pair) text[to++] = text[from] == '\r' ? '\n' : text[from];
  }
  text.resize(to);
}

std::string utf8_of_utf16(std::string_view bytes, bool big_endian) {
  std::string text(bytes.size() / 2 * 3 + character_max, '\0');
  std::size_t made = 0;
  while (true) {
    const RecodeStep step = recode_utf16(bytes, big_endian, true, std::span(text).subspan(made));
    made += step.made;
    bytes.remove_prefix(step.taken);
    if (bytes.empty() || step.taken == 0) break;
    text.resize(text.size() + bytes.size() * 2 + character_max);
  }
  text.resize(made);
  return text;
}

}  // namespace

std::optional<TextEncoding> marked_encoding(std::string_view bytes) {
  if (bytes.starts_with(utf8_mark)) return TextEncoding::utf8_with_mark;
  if (bytes.starts_with("\xFF\xFE")) return TextEncoding::utf16_little;
  if (bytes.starts_with("\xFE\xFF")) return TextEncoding::utf16_big;
  return std::nullopt;
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string utf8_of_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    const bool is_windows = byte >= 0x80 && byte < 0xA0;
    std::array<char, character_max> room{};
    const std::size_t length = put_utf8(
        is_windows ? windows_1252_characters.at(byte - 0x80U) : char32_t{byte}, room.data());
    text.append(room.data(), length);
  }
  return text;
}

std::string as_utf8(std::string_view bytes) {
  return is_utf8(bytes) ? std::string(bytes) : utf8_of_windows_1252(bytes);
}

std::string_view DecodedText::remark() const {
  switch (encoding) {
    case TextEncoding::windows_1252:
      return "it is no UTF-8: read as Windows-1252; save it as UTF-8 where letters are wrong";
    case TextEncoding::utf16_little:
    case TextEncoding::utf16_big:
      return "it is UTF-16: other programs may not read it; save it as UTF-8";
    case TextEncoding::utf8:
    case TextEncoding::utf8_with_mark:
      break;
  }
  return {};
}

DecodedText decode_text(std::string_view bytes) {
  DecodedText decoded;
  const std::optional<TextEncoding> marked = marked_encoding(bytes);
  if (marked) decoded.encoding = *marked;
  if (marked && *marked != TextEncoding::utf8_with_mark) {
    decoded.text = utf8_of_utf16(bytes.substr(2), *marked == TextEncoding::utf16_big);
  } else {
    if (marked) bytes.remove_prefix(utf8_mark.size());
    const bool is_plain = is_utf8(bytes);
    if (!is_plain) decoded.encoding = TextEncoding::windows_1252;
    decoded.text = is_plain ? std::string(bytes) : utf8_of_windows_1252(bytes);
  }
  end_lines_with_feeds(decoded.text);
  return decoded;
}

RecodeStep recode_utf16(std::string_view bytes, bool big_endian, bool last, std::span<char> into) {
  RecodeStep step;
  const auto unit = [&](std::size_t at) -> char32_t {
    const unsigned first = octet_at(bytes, at);
    const unsigned second = octet_at(bytes, at + 1);
    return big_endian ? first << 8 | second : second << 8 | first;
  };
  while (into.size() - step.made >= character_max) {
    const std::size_t left = bytes.size() - step.taken;
    if (left < 2) {
      // Half a character at the end of a file.
      if (last) step.taken = bytes.size();
      break;
    }
    char32_t character = unit(step.taken);
    std::size_t size = 2;
    if (character >= 0xD800 && character <= 0xDBFF) {
      if (left < 4 && !last) break;
      const char32_t low = left < 4 ? 0 : unit(step.taken + 2);
      const bool is_pair = low >= 0xDC00 && low <= 0xDFFF;
      if (is_pair) size = 4;
      character = is_pair ? 0x10000 + ((character - 0xD800) << 10) + (low - 0xDC00) : replacement;
    } else if (character >= 0xDC00 && character <= 0xDFFF) {
      character = replacement;
    }
    step.made += put_utf8(character, into.data() + step.made);
    step.taken += size;
  }
  return step;
}

}  // namespace canvoy::formats
