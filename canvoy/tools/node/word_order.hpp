// The order of words behind a verb and its bus, as other tools have it: `nmt can0 start 10`, `write
// can0 10 1017 0 u16 500`, `send can0 60A 40 18 10`. Lines of scripts are ordered so, too.
//
//     order_words(words);  // nmt can0 10 start
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// Number of words after the verb and before the first option.
std::size_t count_places(const std::vector<std::string>& words);

/// Decimal, of up to three digits.
bool is_small_number(std::string_view word);

/// Puts the words after a verb and its bus in order: node and state, index and sub-index as one,
/// the bytes of a frame. Throws UsageError with both lines where two are meant.
void order_words(std::vector<std::string>& words);

}  // namespace canvoy::tools
