// Converts text of files to UTF-8: honours byte order marks of UTF-8 and UTF-16, reads text that is
// not UTF-8 as Windows-1252, and ends a line at a lone carriage return.
//
//     DecodedText sheet = decode_text(bytes);
//     if (!sheet.remark().empty()) say(sheet.remark());  // it is no UTF-8: read as Windows-1252
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace canvoy::formats {

/// Encodings that are understood.
enum class TextEncoding : std::uint8_t {
  utf8,
  utf8_with_mark,
  utf16_little,
  utf16_big,
  windows_1252
};

/// The encoding that a byte order mark at the start gives; nothing if there is none.
std::optional<TextEncoding> marked_encoding(std::string_view bytes);

/// True if it is well-formed UTF-8 (RFC 3629), control characters included.
bool is_utf8(std::string_view bytes);

/// Converts from Windows-1252; its five unassigned codes become U+FFFD.
std::string utf8_of_windows_1252(std::string_view bytes);

/// Returns `bytes` if they are UTF-8, else converts them from Windows-1252.
std::string as_utf8(std::string_view bytes);

/// Text of a file, in UTF-8.
struct DecodedText {
  std::string text;                            ///< lines end with a line feed
  TextEncoding encoding = TextEncoding::utf8;  ///< of the file

  /// A remark for the reader on the encoding, in one line; empty if it is UTF-8.
  std::string_view remark() const;
};

/// Decodes a whole file.
DecodedText decode_text(std::string_view bytes);

/// Converts a piece of UTF-16 without its byte order mark: as many characters as fit, four bytes
/// for each. A lone surrogate becomes U+FFFD. `last`: nothing follows.
struct RecodeStep {
  std::size_t taken = 0;  ///< bytes of the piece
  std::size_t made = 0;   ///< bytes of UTF-8
};
/// Converts a piece; `into` needs at least four bytes.
RecodeStep recode_utf16(std::string_view bytes, bool big_endian, bool last, std::span<char> into);

}  // namespace canvoy::formats
