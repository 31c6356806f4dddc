// A CSV file of people who come to a building: one line each, in any order.
//
//     seconds,from,to,kg
//     12.5,1,7,80
//     13,1,4
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/traffic.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line: the file cannot be read, a line is malformed, a floor does
/// not exist in the building, a person travels to the floor of arrival, there are more than a
/// million lines.
std::vector<lift::Arrival> read_arrivals(const std::string& path, const lift::Building& building);

/// Parses the content of a file; `name` is used in errors.
std::vector<lift::Arrival> parse_arrivals(std::string_view name, std::string_view text,
                                          const lift::Building& building);

}  // namespace canvoy::tools
