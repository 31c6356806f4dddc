// Text in lines of limited width, after a head.
//
//     append_wrapped(lines, "  why    ", text, 80);
#pragma once

#include <string>
#include <string_view>

namespace canvoy::text {

/// Appends whole lines: the first begins with `head`, the others with as many blanks. A word longer
/// than a line gets a line of its own.
void append_wrapped(std::string& lines, std::string_view head, std::string_view text,
                    std::size_t columns);

}  // namespace canvoy::text
