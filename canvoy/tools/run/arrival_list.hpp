// People who come to a building, as a CSV file: a line each, by their times or not.
//
//     seconds,from,to,kg
//     12.5,1,7,80
//     13,1,4
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/traffic.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line: it cannot be read, a line is malformed, a floor is none of
/// the building, somebody goes where he is, there are more than a million.
std::vector<lift::Arrival> read_arrivals(const std::string& path, const lift::Building& building);

/// The contents of a file; `name` is how errors call it.
std::vector<lift::Arrival> parse_arrivals(std::string_view name, std::string_view text,
                                          const lift::Building& building);

}  // namespace canvoy::tools
