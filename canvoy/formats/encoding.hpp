// Text of files as UTF-8: byte order marks of UTF-8 and UTF-16 are honoured, what is no UTF-8 is
// read as Windows-1252, and a carriage return alone ends a line.
//
//     DecodedText sheet = decode_text(bytes);
//     if (!sheet.remark().empty()) say(sheet.remark());     // "it is no UTF-8: read as
//     Windows-1252"
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace canvoy::formats {

enum class TextEncoding : std::uint8_t {
  utf8,
  utf8_with_mark,
  utf16_little,
  utf16_big,
  windows_1252
};

/// What a byte order mark at the front says; none where there is none.
std::optional<TextEncoding> marked_encoding(std::string_view bytes);

/// Whether it is well-formed UTF-8 (RFC 3629), control characters included.
bool is_utf8(std::string_view bytes);

/// Of Windows-1252; its five empty places become U+FFFD.
std::string utf8_of_windows_1252(std::string_view bytes);

/// `bytes` themselves where they are UTF-8, else what they are in Windows-1252.
std::string as_utf8(std::string_view bytes);

struct DecodedText {
  std::string text;  ///< lines end with a line feed
  TextEncoding encoding = TextEncoding::utf8;

  /// What a reader should know of it, in a line; empty where it is UTF-8.
  std::string_view remark() const;
};

/// Of a whole file.
DecodedText decode_text(std::string_view bytes);

/// A piece of UTF-16 without its mark: as many characters as there is room for, four bytes for
/// each. A lone half of a pair becomes U+FFFD. `last`: nothing follows.
struct RecodeStep {
  std::size_t taken = 0;
  std::size_t made = 0;
};
RecodeStep recode_utf16(std::string_view bytes, bool big_endian, bool last, std::span<char> into);

}  // namespace canvoy::formats
