// What meter and driver's unit of a taxi have the terminal show, in lines of 20 and 16 columns; and
// what somebody reads there.
//
//     writer.show(trip_text(display, "EUR"));    // "Tariff 1", "FARE      12.30 EUR"
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// While there are passengers; else empty.
std::string trip_text(const cia447::TaximeterDisplay& display, std::string_view currency);
/// Where a car is and goes; what is not known is empty.
struct ShownPlace {
  std::string_view street{};
  std::string_view city{};
  std::string_view destination{};  ///< a street
  std::optional<double> metres_to_go{};
};
/// The street, that of the destination, and how far it is; without a destination street and city.
std::string place_text(const ShownPlace& shown);

/// The fare that somebody reads there, in 0,001 of the currency unit.
std::optional<double> read_fare(std::string_view text);
/// The street that somebody reads there.
std::string_view read_street(std::string_view text);
/// The street of the destination.
std::string_view read_destination(std::string_view text);
/// How far it is, in m.
std::optional<double> read_metres_to_go(std::string_view text);

}  // namespace canvoy::taxi
