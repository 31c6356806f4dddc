// Letters that a display does not have, in those of ISO 646-US: without accents, Cyrillic by
// BGN/PCGN, Greek by ELOT 743. Table and not library: who embeds the simulator needs no other one.
//
//     latin_letters(U'\u00DF')     // ss
#pragma once

#include <string_view>

namespace canvoy::bus {

/// A question mark for what it does not know; nothing for letters that are not written.
std::string_view latin_letters(char32_t character);

}  // namespace canvoy::bus
