// The order of words behind a verb and its bus, as other tools have it: `nmt can0 start 10`, `write
// can0 10 1017 0 u16 500`, `send can0 60A 40 18 10`. Lines of scripts are ordered so, too.
//
//     order_words(words);  // nmt can0 10 start
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// Number of words after the verb and before the first option.
std::size_t count_places(const std::vector<std::string>& words);

/// Takes out `count` words from the one at `at` on.
void erase_words(std::vector<std::string>& words, std::size_t at, std::size_t count = 1);
/// Takes out the first option with one of these names, and its value, where the value is one.
std::optional<std::string> take_option(
    std::vector<std::string>& words, std::initializer_list<std::string_view> names,
    bool (*is_value)(std::string_view) = [](std::string_view) { return true; });

/// Decimal, of up to three digits.
bool is_small_number(std::string_view word);

/// Puts the words after a verb and its bus in order: node and state, index and sub-index as one,
/// the bytes of a frame. Throws UsageError with both lines where two are meant.
void order_words(std::vector<std::string>& words);

}  // namespace canvoy::tools
