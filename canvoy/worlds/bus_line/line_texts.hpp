// The texts of a bus line as its displays receive them: octets of the character set that a display
// offers and that has all letters of the text (CiA 407, 9.2.8.6), or of ISO 646-US for displays
// without character sets (6205h; CiA 407, 6.4), at most 128 (errata 106).
//
//     const EncodedText text = encode("Zürich HB", display.sets);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/worlds/bus_line/bus_line.hpp"

namespace canvoy::bus_line {

inline constexpr std::size_t text_octets_max = 128;  ///< of an entry for a text

/// Values of 6205h: ISO 646-US; for ISO 8859-n, the number n.
inline constexpr std::uint16_t us_ascii = 0;
inline constexpr std::uint16_t latin_1 = 1;  ///< ISO 8859-1

/// A text of one display.
struct EncodedText {
  std::uint16_t character_set = us_ascii;  ///< value of 6205h
  std::string octets{};                    ///< in that set
};

/// Characters of UTF-8; U+FFFD for invalid octets.
std::u32string code_points(std::string_view utf_8);
/// True if ISO 8859-1, or 646-US, has all characters of the text.
bool is_latin_1(std::string_view utf_8);

/// Encodes a text in the first of ISO 8859-1, ISO 646-US and the others of `offered`, in their
/// order, that has all its characters; where none has, in ISO 8859-1 or 646-US, with other
/// characters spelled in the letters of that set. A set other than ISO 646-US must be in `offered`.
/// A text that is too long is cut.
EncodedText encode(std::string_view utf_8, std::span<const std::uint16_t> offered);
/// Spells a text in ASCII: letters lose their accents, and others become Latin letters
/// (latin_letters.hpp).
std::string to_ascii(std::string_view utf_8);
/// Like to_ascii(), but letters of ISO 8859-1 stay.
std::string to_latin_1(std::string_view utf_8);

/// Text of the information display for a route, in UTF-8: `407 to Harbour: Market Square, Town
/// Hall`. It has as many stops as fit in a set of `offered`; a stop that would take more than half
/// of the space is left out.
std::string route_text(const BusLine& line, const BusRoute& route, std::string_view destination,
                       std::span<const std::uint16_t> offered);

/// The bytes of a text, without change.
std::vector<std::uint8_t> octets_of_text(std::string_view text);

}  // namespace canvoy::bus_line
