// Numbers in JSON, digit for digit as nlohmann::json writes them.
//
//     append_json_number(line, 20.125);
//     append_json_decimal(line, 20125, 3);  // the same, in a fifth of the time
#pragma once

#include <cstdint>
#include <string>

namespace canvoy::words {

/// A finite number.
void append_json_number(std::string& line, double number);

/// The double that is next to `number` / 10^places. Of at most 15 digits behind the point; more
/// digits than a double has are written as it would be.
void append_json_decimal(std::string& line, std::int64_t number, unsigned places);

}  // namespace canvoy::words
