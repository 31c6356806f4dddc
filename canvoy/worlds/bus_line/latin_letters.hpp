// Spells letters that a display does not have in those of ISO 646-US: without accents, Cyrillic by
// BGN/PCGN, Greek by ELOT 743. It is a table and needs no library, so that the simulator can be
// embedded without one.
//
//     latin_letters(U'\u00DF')     // ss
#pragma once

#include <string_view>

namespace canvoy::bus_line {

/// A question mark for an unknown character; empty for letters that are not written.
std::string_view latin_letters(char32_t character);

}  // namespace canvoy::bus_line
