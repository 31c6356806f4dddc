// The texts of a bus line as its displays get them: octets of ISO 8859-1, or of ISO 646-US for
// those that have no character sets (CiA 407, 6.4: 6205h), 128 at most (errata 106).
//
//     octets_of_text(to_latin_1("Zürich HB"));
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

inline constexpr std::size_t text_octets_max = 128;

/// Of UTF-8; what the set does not have is a question mark. Cut where it is too long.
std::string to_latin_1(std::string_view utf_8);
/// Letters lose their accents.
std::string to_ascii(std::string_view utf_8);
/// Back again.
std::string latin_1_as_utf_8(std::string_view latin_1);

/// What the information display says of a route, UTF-8: `407 to Harbour: Market Square, Town Hall`.
/// As many stops as it has room for.
std::string route_text(const BusLine& line, const BusRoute& route);

std::vector<std::uint8_t> octets_of_text(std::string_view text);

}  // namespace canvoy::bus
