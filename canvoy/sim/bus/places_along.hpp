// Where stops stand along the way of a route: stops of a feed have places beside it, and a street
// may be driven there and back.
//
//     places_along(path, {{50.1, 8.5}, {50.11, 8.51}})     // m from the start, in their order
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/sim/bus/path.hpp"

namespace canvoy::bus {

/// Into at most so many more pieces places_along divides a path.
inline constexpr std::size_t pieces_more_max = 4000;

/// Where each of `places` is along the path, in m: the order kept, as near to them as can be.
/// Takes time and memory in proportion to the product of both numbers of points.
std::vector<double> places_along(const Path& path, const std::vector<GeoPoint>& places);

}  // namespace canvoy::bus
