// Makes text of files and of the bus safe to show: it must not control the terminal.
//
//     fmt::print("{}\n", plain_text(entry.name));      // "Prüfer", "Name\x1B[2J"
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace canvoy::formats {

/// True if it is UTF-8 without control characters, including those that change the direction of
/// writing.
bool is_plain_text(std::string_view text);
/// Replaces each byte that is not part of plain text by `\x1B` notation; the result is UTF-8.
std::string plain_text(std::string_view text);

/// Number of bytes of the UTF-8 character at the start (RFC 3629); 0: none starts there.
std::size_t utf8_length(std::string_view text);

/// The text without blanks at both ends, including a carriage return at its end.
std::string_view trimmed(std::string_view text);

/// Escapes text for HTML and XML, between elements and in attribute values.
std::string markup_text(std::string_view text);

/// Upper-case hexadecimal digits with leading zeros: "0A".
std::string hex(std::uint64_t number, unsigned digits);

}  // namespace canvoy::formats
