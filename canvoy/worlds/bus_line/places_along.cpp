#include "canvoy/worlds/bus_line/places_along.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace canvoy::bus_line {

namespace {

struct Foot {
  double share = 0;   ///< of the piece
  double metres = 0;  ///< from the place
};

/// The point of a piece that is nearest to a place, on a plane that is accurate for some
/// kilometres.
Foot nearest(const GeoPoint& from, const GeoPoint& to, const GeoPoint& place) {
  const double narrow = std::cos(place.latitude * std::numbers::pi / 180);
  const double way_x = (to.longitude - from.longitude) * narrow;
  const double way_y = to.latitude - from.latitude;
  const double x = (place.longitude - from.longitude) * narrow;
  const double y = place.latitude - from.latitude;
  const double length = way_x * way_x + way_y * way_y;
  const double share = length <= 0 ? 0 : std::clamp((x * way_x + y * way_y) / length, 0.0, 1.0);
  return {share, metres_between(between(from, to, share), place)};
}

/// Pieces are not longer than this, unless the path is very long: two places on one piece may be in
/// the wrong order, as where a street is driven there and back.
constexpr double piece_m = 25;

struct Mark {
  GeoPoint place{};
  double metres = 0;
};

std::vector<Mark> marks_along(const Path& path) {
  const double longest = std::max(piece_m, path.metres() / double(pieces_more_max));
  std::vector<Mark> marks;
  const std::vector<GeoPoint>& points = path.points();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double start = path.metres_of(i);
    const double length = path.metres_of(i + 1) - start;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / longest)));
    for (int part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      marks.push_back({between(points[i], points[i + 1], share), start + share * length});
    }
  }
  marks.push_back({points.back(), path.metres()});
  return marks;
}

}  // namespace

std::vector<double> places_along(const Path& path, const std::vector<GeoPoint>& places) {
  if (path.points().size() < 2) return std::vector<double>(places.size(), 0);
  const std::vector<Mark> marks = marks_along(path);
  const std::size_t pieces = marks.size() - 1;
  // For each place and piece: the least sum of squares with this place on that piece or before it,
  // and the piece that gives it.
  std::vector<double> best(pieces, 0);
  std::vector<std::vector<std::uint32_t>> chosen;
  for (const GeoPoint& place : places) {
    std::vector<std::uint32_t> piece_of(pieces);
    double least = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
      const double off = nearest(marks[i].place, marks[i + 1].place, place).metres;
      if (const double sum = best[i] + off * off; sum < least) {
        least = sum;
        at = i;
      }
      best[i] = least;
      piece_of[i] = static_cast<std::uint32_t>(at);
    }
    chosen.push_back(std::move(piece_of));
  }
  std::vector<double> result(places.size());
  std::size_t piece = pieces - 1;
  for (std::size_t i = places.size(); i-- > 0;) {
    piece = chosen[i][piece];
    const Mark& start = marks[piece];
    const Mark& end = marks[piece + 1];
    const Foot foot = nearest(start.place, end.place, places[i]);
    result[i] = start.metres + foot.share * (end.metres - start.metres);
  }
  for (std::size_t i = 1; i < result.size(); ++i) result[i] = std::max(result[i], result[i - 1]);
  return result;
}

}  // namespace canvoy::bus_line
