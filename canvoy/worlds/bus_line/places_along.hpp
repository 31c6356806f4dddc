// Finds the positions of stops along the path of a route: stops of a feed stand beside it, and a
// street may be driven there and back.
//
//     places_along(path, {{50.1, 8.5}, {50.11, 8.51}})     // m from the start, in their order
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/worlds/bus_line/path.hpp"

namespace canvoy::bus_line {

/// Most pieces that places_along() adds when it divides a path.
inline constexpr std::size_t pieces_more_max = 4000;

/// Position of each of `places` along the path, in m: in the same order, as near to them as
/// possible. Takes time and memory in proportion to the product of both numbers of points.
std::vector<double> places_along(const Path& path, const std::vector<GeoPoint>& places);

}  // namespace canvoy::bus_line
