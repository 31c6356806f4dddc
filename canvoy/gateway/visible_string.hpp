// A visible string between quotes, so that it stays on one line: "Hello, ""World""!"
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

/// A quote becomes two, a backslash and what is not printable an escape sequence of C. Bytes from
/// 80h on stay as they are, since many devices send ISO 8859-1 or UTF-8.
std::string quote(std::span<const std::uint8_t> bytes);

/// With its quotes, or a word without any. Nothing where an escape sequence is none of C's.
std::optional<std::vector<std::uint8_t>> unquote(std::string_view text);

}  // namespace canvoy::gateway
