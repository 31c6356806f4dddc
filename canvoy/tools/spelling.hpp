// Which of the known words somebody may have meant who wrote another one.
//
//     did_you_mean("tempersture", {"temperature", "voltage"});  // "; did you mean 'temperature'?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

/// How many letters are to be put in, left out, exchanged or swapped with their neighbour to make
/// one word of the other; case does not matter. Its cost is the product of both lengths.
std::size_t distance(std::string_view a, std::string_view b);

/// The end of a message: empty where no known word is close, which is at most a third of its
/// letters away, and one of a short word.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace canvoy::tools
