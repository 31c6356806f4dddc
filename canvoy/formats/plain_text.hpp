// Text of files and of the bus, as a terminal can show it: it must not command the terminal.
//
//     fmt::print("{}\n", plain_text(entry.name));      // "Prüfer", "Name\x1B[2J"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace canvoy::formats {

/// Whether it is UTF-8 without control characters, those that turn the direction of writing
/// included.
bool is_plain_text(std::string_view text);
/// Each byte that is not of such a text becomes `\x1B`; the result is UTF-8.
std::string plain_text(std::string_view text);

/// Without the blanks before and behind it, a carriage return at its end among them.
std::string_view trimmed(std::string_view text);

/// Capital hexadecimal digits, with zeros in front: "0A".
std::string hex(std::uint64_t number, unsigned digits);

}  // namespace canvoy::formats
