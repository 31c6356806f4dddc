// Judges the text on the terminal of a taxi: compares tariff, fare, extras and currency with those
// of the meter and of the town, and the place and the distance to the destination with the position
// of the car.
//
//     fare_is_right(screens.fare(), meter.display(), currency_of_town)
//     const TruePlace truth{.here = position, .destination = destination, .places = town_places};
//     place_is_right(screens.place(), truth)
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// While there are passengers, the text must be the tariff's level, the fare and the extras in
/// coins of this currency; otherwise there must be none.
bool fare_is_right(std::string_view text, const cia447::TaximeterDisplay& shown,
                   const cia447::Currency& currency);

/// Position and destination of a car.
struct TruePlace {
  std::optional<cia447::GeoPosition> here{};         ///< empty: unknown
  std::optional<cia447::GeoPosition> destination{};  ///< of the passengers; empty: none
  bool has_satellites = true;  ///< false: the position may be missing, but not wrong
  std::span<const cia447::NamedPlace> places{};  ///< places with their names
};

/// True if the text has the street of the car, that of its destination, and the distance to it.
bool place_is_right(std::string_view text, const TruePlace& truth);

}  // namespace canvoy::taxi
