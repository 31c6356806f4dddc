// Writes numbers in JSON, digit for digit like nlohmann::json.
//
//     append_json_number(line, 20.125);
//     append_json_decimal(line, 20125, 3);  // the same, in a fifth of the time
#pragma once

#include <cstdint>
#include <string>

namespace canvoy::text {

/// Appends a finite number.
void append_json_number(std::string& line, double number);

/// Appends the double nearest to `number` / 10^places, with at most 15 places; more digits than a
/// double has are written like that double.
void append_json_decimal(std::string& line, std::int64_t number, unsigned places);

}  // namespace canvoy::text
