// A visible string in quotes, on one line: "Hello, ""World""!"
//
//     quote(bytes);  unquote("\"a\\n\"");
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::gateway {

/// Quotes a string. A quote becomes two, a backslash or an unprintable character an escape sequence
/// of C. Bytes from 80h on stay as they are, since many devices send ISO 8859-1 or UTF-8.
std::string quote(std::span<const std::uint8_t> bytes);

/// Reads a string with quotes, or a word without. Nothing if an escape sequence is not one of C.
std::optional<std::vector<std::uint8_t>> unquote(std::string_view text);

}  // namespace canvoy::gateway
