// What keys do in all pictures with rows: they scroll, and type a line of text.
//
//     if (const auto rows = rows_moved(key, shown, count)) move(*rows);
//     type_key(typed, key);
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "canvoy/tools/terminal/screen.hpp"

namespace canvoy::tools {

/// By how many of `count` rows a key moves, of which `shown` fit the screen: to the top or the end
/// by all of them. Nothing: it does not move.
std::optional<long> rows_moved(Key key, std::size_t shown, std::size_t count);

/// A row from 0 to `count` - 1, or 0 where there is none.
std::size_t moved_row(std::size_t row, long rows, std::size_t count);

/// Puts a character behind the text, or takes the last one back; of UTF-8, with all of its bytes.
/// Other keys do nothing.
void type_key(std::string& text, Key key);

}  // namespace canvoy::tools
