// Text in lines of so many columns, under a head.
//
//     append_wrapped(lines, "  why    ", text, 80);
#pragma once

#include <string>
#include <string_view>

namespace canvoy::words {

/// Appends whole lines: the first begins with `head`, the others with as many blanks. A word that
/// is longer than a line stands alone on one.
void append_wrapped(std::string& lines, std::string_view head, std::string_view text,
                    std::size_t columns);

}  // namespace canvoy::words
