// The words of a command line: numbers, names, and texts in quotes. A # begins a comment.
//
//     split("r 0x1018 1 u32  # the vendor-ID")  // r, 0x1018, 1, u32
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace canvoy::gateway {

/// A word as written in the line; a text with its quotes.
using Token = std::string_view;
using Tokens = std::span<const Token>;  ///< of a line, in order

/// Words of a line. Nothing if a text has no end, or is directly followed by another character. Two
/// quotes in a text, or a backslash and a character, do not end it.
std::optional<std::vector<Token>> split(std::string_view line);

/// True if the word matches `pattern`: case is ignored, and the part in brackets may be left out,
/// as in r[ead].
bool matches(std::string_view pattern, Token word);

}  // namespace canvoy::gateway
