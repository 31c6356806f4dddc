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

bool is_amount(const std::optional<ShownAmount>& shown, double amount,
               const cia447::Currency& currency) {
  return shown && std::abs(shown->amount - amount) <= currency.coin / 2.0 &&
         shown->currency == currency.code;
}

/// Printable characters of a level's name.
std::string name_of(const std::array<std::uint8_t, 2>& level) {
  std::string name;
  for (const std::uint8_t one : level) {
    if (one >= ' ' && one < 0x7F) name += static_cast<char>(one);
  }
  return name;
}

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

bool fare_is_right(std::string_view text, const cia447::TaximeterDisplay& shown,
                   const cia447::Currency& currency) {
  const bool has_passengers =
      shown.state == cia447::Taximeter::hired || shown.state == cia447::Taximeter::stopped;
  if (!has_passengers) return !read_fare(text).has_value();
  const cia447::TripData& trip = shown.trip;
  const bool has_extras = trip.supplements != 0 && trip.supplements != cia447::TripData::unknown;
  return is_amount(read_amount(text, "FARE"), trip.fare, currency) &&
         read_level(text) == name_of(trip.level) &&
         (!has_extras || is_amount(read_amount(text, "EXTRAS"), trip.supplements, currency));
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
