// The texts of a bus line as its displays get them: octets of the character set that a display
// offers and that has all letters of the text (CiA 407, 9.2.8.6), or of ISO 646-US for those that
// have no character sets (6.4: 6205h), 128 at most (errata 106).
//
//     const EncodedText text = encode("Zürich HB", display.sets);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

inline constexpr std::size_t text_octets_max = 128;

/// ISO 646-US, and its number n in ISO 8859-n, as values of 6205h.
inline constexpr std::uint16_t us_ascii = 0;
inline constexpr std::uint16_t latin_1 = 1;  ///< ISO 8859-1

/// A text of one display.
struct EncodedText {
  std::uint16_t character_set = us_ascii;  ///< of 6205h
  std::string octets{};                    ///< of that set
};

/// Of UTF-8; U+FFFD for what is none.
std::u32string code_points(std::string_view utf_8);
/// ISO 8859-1, or 646-US, has all of its characters.
bool is_latin_1(std::string_view utf_8);

/// In the first of ISO 8859-1, ISO 646-US and the others of `offered`, in their order, that has all
/// characters; where none has, in ISO 8859-1 or 646-US, with others in the letters of that. Of
/// those sets only that `offered` has; ISO 646-US is always there. Cut where it is too long.
EncodedText encode(std::string_view utf_8, std::span<const std::uint16_t> offered);
/// Letters lose their accents, and others are written in Latin ones (latin_letters.hpp).
std::string to_ascii(std::string_view utf_8);
/// The same, but for the letters of ISO 8859-1.
std::string to_latin_1(std::string_view utf_8);

/// What the information display says of a route, UTF-8: `407 to Harbour: Market Square, Town Hall`.
/// As many stops as it has room for in a set of `offered`.
std::string route_text(const BusLine& line, const BusRoute& route,
                       std::span<const std::uint16_t> offered);

std::vector<std::uint8_t> octets_of_text(std::string_view text);

}  // namespace canvoy::bus
