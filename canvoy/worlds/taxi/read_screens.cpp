#include "canvoy/worlds/taxi/read_screens.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/worlds/taxi/screen_text.hpp"

namespace canvoy::taxi {

namespace {

/// Distance that a car drives from a look of the receiver until the position is read.
constexpr double stale_metres = 150;
/// The distance to a destination is shown in hundreds of metres.
constexpr double told_step = 100;
constexpr double half_a_cent = 5;  ///< in 0.001 of the currency unit

/// True if a place of this name is the nearest one there, or not much farther.
bool is_near(std::string_view street, const cia447::GeoPosition& position,
             std::span<const cia447::NamedPlace> places) {
  const cia447::NamedPlace* nearest = cia447::Gazetteer(places).nearest(position);
  if (nearest == nullptr) return true;
  return std::ranges::any_of(places, [&](const cia447::NamedPlace& place) {
    return place.street == street &&
           cia447::metres_between(position, place.position) <=
               cia447::metres_between(position, nearest->position) + 2 * stale_metres;
  });
}

}  // namespace

bool fare_is_right(std::string_view text, const cia447::TaximeterDisplay& shown) {
  const std::optional<double> fare = read_fare(text);
  const bool has_passengers =
      shown.state == cia447::Taximeter::hired || shown.state == cia447::Taximeter::stopped;
  if (!has_passengers) return !fare.has_value();
  return fare && std::abs(*fare - shown.trip.fare) <= half_a_cent;
}

bool place_is_right(std::string_view text, const TruePlace& truth) {
  const cia447::GeoPosition here = truth.here.value_or(cia447::GeoPosition{});
  const std::string_view street = read_street(text);
  const bool is_dark = !truth.has_satellites && street.empty();
  if (truth.here && !is_dark && !is_near(street, here, truth.places)) return false;
  if (!truth.destination) return read_destination(text).empty();
  if (!is_near(read_destination(text), *truth.destination, truth.places)) return false;
  const std::optional<double> to_go = read_metres_to_go(text);
  const double truly_to_go = cia447::metres_between(here, *truth.destination);
  return !to_go || std::abs(*to_go - truly_to_go) <= stale_metres + told_step;
}

}  // namespace canvoy::taxi
