// Judges what is read on the terminal of a taxi: the fare against what the meter shows, the place
// and the way to the destination against where the car is.
//
//     fare_is_right(screens.fare(), meter.display())
//     const TruePlace truth{.here = position, .destination = destination, .places = town_places};
//     place_is_right(screens.place(), truth)
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// While there are passengers the fare is read, in hundredths, and else none.
bool fare_is_right(std::string_view text, const cia447::TaximeterDisplay& shown);

/// Where a car is and goes.
struct TruePlace {
  std::optional<cia447::GeoPosition> here{};  ///< nothing: nobody knows
  std::optional<cia447::GeoPosition> destination{};
  bool has_satellites = true;  ///< who has none may say nothing of where he is, but nothing wrong
  std::span<const cia447::NamedPlace> places{};  ///< by which places are named
};

/// The street where the car is, that of its destination, and how far it is to it.
bool place_is_right(std::string_view text, const TruePlace& truth);

}  // namespace canvoy::taxi
