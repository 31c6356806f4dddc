// Reads a sign by its dots, as a person does: each cell of 8 by 16 dots is the character that it
// shows. A cell that shows no character cannot be read: the box for a missing character, a test
// pattern, half a letter.
//
//     read_sign(display.picture_of(0))    // U"407\nHarbour"
#pragma once

#include <string>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy {

/// Stands for a cell that cannot be read.
inline constexpr char32_t unreadable = 0xFFFD;

/// Lines that are not empty, without blanks at their ends. Of characters that look alike, it
/// returns the one with the lowest number.
std::u32string read_sign(const Picture& picture);
/// The character as which a character is read: itself, one that looks alike, or `unreadable`.
char32_t look_of(char32_t character);

}  // namespace canvoy
