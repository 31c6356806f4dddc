// Decides whether the text on a sign is a name: letter by letter, or spelled in Latin letters as a
// person may do without the original ones. It is independent of how the sender makes the text.
//
//     is_spelled(U"Lodz", U"\u0141\u00F3d\u017A")      // true
//     is_spelled(U"?od?", U"\u0141\u00F3d\u017A")      // false
//
// Each letter of Latin, Greek and Cyrillic has the spellings that are in use for it (those of ISO
// 9, BGN/PCGN, ELOT 743, passports, and without the accent), in any case; of other scripts, only
// the letter itself is accepted.
#pragma once

#include <string_view>

namespace canvoy::bus_line {

/// Consecutive lines and blanks count as one blank, and as none at the ends.
bool is_spelled(std::u32string_view shown, std::u32string_view name);

}  // namespace canvoy::bus_line
