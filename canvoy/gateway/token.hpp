// The words of a command line: numbers, names, and texts in quotes; what follows a # is a comment.
//
//     split("r 0x1018 1 u32  # the vendor-ID")  // r, 0x1018, 1, u32
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace canvoy::gateway {

/// A word as it stands in the line; of a text, with its quotes.
using Token = std::string_view;
using Tokens = std::span<const Token>;

/// Nothing where a text has no end, or something stands right behind it. Two quotes in a text, and
/// what follows a backslash, do not end it.
std::optional<std::vector<Token>> split(std::string_view line);

/// Whether the word is `pattern`: capitals do not matter, and what stands in brackets there may be
/// left out, as in r[ead].
bool matches(std::string_view pattern, Token word);

}  // namespace canvoy::gateway
