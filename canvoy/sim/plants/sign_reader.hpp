// Reads a sign by its dots, as somebody does who stands before it: each cell of 8 by 16 dots is the
// character whose picture it is, and what is no picture of a character cannot be read: a box that
// stands for a missing one, a test pattern, half a letter.
//
//     read_sign(display.picture_of(0))    // U"407\nHarbour"
#pragma once

#include <string>

#include "canvoy/sim/plants/picture.hpp"

namespace canvoy {

/// Stands for a cell that cannot be read.
inline constexpr char32_t unreadable = 0xFFFD;

/// Lines that are not empty, without blanks at their ends. Of characters that look the same it is
/// the one with the lowest number.
std::u32string read_sign(const Picture& picture);
/// As what a character is read: itself, one that looks the same, or `unreadable`.
char32_t look_of(char32_t character);

}  // namespace canvoy
