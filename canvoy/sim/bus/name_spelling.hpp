// Whether what is to be read on a sign is a name: letter by letter, or in Latin letters as somebody
// may write it who has no others. It knows nothing of how the sender of the text has made it.
//
//     is_spelled(U"Lodz", U"\u0141\u00F3d\u017A")      // true
//     is_spelled(U"?od?", U"\u0141\u00F3d\u017A")      // false
//
// Each letter of Latin, Greek and Cyrillic has the spellings that are in use for it (those of ISO
// 9, BGN/PCGN, ELOT 743, passports, and without the accent), in any case; of other scripts it knows
// none but the letter itself.
#pragma once

#include <string_view>

namespace canvoy::bus {

/// Lines and blanks that come after each other are one blank, at the ends none.
bool is_spelled(std::u32string_view shown, std::u32string_view name);

}  // namespace canvoy::bus
