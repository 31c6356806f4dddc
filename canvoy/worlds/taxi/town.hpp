// The town of the simulated taxi for its navigation system: a road to the north.
//
//     options.places = town_places;
#pragma once

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"

namespace canvoy::taxi {

/// A place on the road of the town, by its latitude in degrees north.
inline constexpr auto place_in_town = [](double latitude, std::string_view street) {
  return cia447::NamedPlace{.position = {.latitude = latitude, .longitude = 11.575},
                            .city = "Munich",
                            .street = street,
                            .country = "Germany"};
};
/// From the south to the north, 12 km apart in all.
inline constexpr cia447::NamedPlace town_places[] = {
    place_in_town(48.1370, "Marienplatz"),    place_in_town(48.1430, "Odeonsplatz"),
    place_in_town(48.1500, "Universitaet"),   place_in_town(48.1565, "Giselastrasse"),
    place_in_town(48.1620, "Freiheit"),       place_in_town(48.1690, "Dietlindenstr."),
    place_in_town(48.1770, "Nordfriedhof"),   place_in_town(48.1850, "Alte Heide"),
    place_in_town(48.1935, "Studentenstadt"), place_in_town(48.2040, "Freimann"),
    place_in_town(48.2130, "Kieferngarten"),  place_in_town(48.2230, "Froettmaning")};

}  // namespace canvoy::taxi
