// Keys in all pictures with rows: scrolling, and typing a line of text.
//
//     if (const auto rows = rows_moved(key, shown, count)) move(*rows);
//     type_key(typed, key);
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "canvoy/tools/terminal/screen.hpp"

namespace canvoy::tools {

/// Number of rows by which a key moves, with `count` rows of which `shown` fit the screen: to the
/// top or the end by all of them. Nothing: the key does not move.
std::optional<long> rows_moved(Key key, std::size_t shown, std::size_t count);

/// A row from 0 to `count` - 1; 0 if there are no rows.
std::size_t moved_row(std::size_t row, long rows, std::size_t count);

/// Appends a character to the text, or removes the last one with all of its UTF-8 bytes. Ignores
/// other keys.
void type_key(std::string& text, Key key);

}  // namespace canvoy::tools
