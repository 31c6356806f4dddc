// What meter and navigation system of a taxi have the terminal show, in lines of 20 and 16 columns.
//
//     writer.show(trip_text(display, "EUR"));    // "Tariff 1", "FARE      12.30 EUR"
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// While there are passengers; else empty.
std::string trip_text(const cia447::TaximeterDisplay& display, std::string_view currency);
/// The street, and the city or how far it is.
std::string place_text(const cia447::NamedPlace* here, std::optional<double> metres_to_go);

/// The fare that somebody reads there, in 0,001 of the currency unit.
std::optional<double> read_fare(std::string_view text);
/// The street that somebody reads there.
std::string_view read_street(std::string_view text);

}  // namespace canvoy::taxi
