// Texts that meter and driver's unit of a taxi show on the terminal, in lines of 20 and 16 columns;
// and their readings.
//
//     writer.show(trip_text(display, {}));    // "Tariff 1", "FARE      12.30 EUR"
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

/// Text while there are passengers; otherwise empty.
std::string trip_text(const cia447::TaximeterDisplay& display, const cia447::Currency& currency);
/// Position and destination of a car; what is unknown is empty.
struct ShownPlace {
  std::string_view street{};             ///< of the car
  std::string_view city{};               ///< of the car, shown without a destination
  std::string_view destination{};        ///< a street
  std::optional<double> metres_to_go{};  ///< along the straight line, in m
};
/// The street, that of the destination, and the distance to it; without a destination, street and
/// city.
std::string place_text(const ShownPlace& shown);

/// Fare in the text, in 0.001 of the currency unit.
std::optional<double> read_fare(std::string_view text);
/// Amount in 0.001 of the currency unit, and the code behind it.
struct ShownAmount {
  double amount = 0;            ///< in 0.001 of the currency unit
  std::string_view currency{};  ///< to the end of the line
};
/// Amount in the line with this name; empty: there is none.
std::optional<ShownAmount> read_amount(std::string_view text, std::string_view name);
/// Name of the tariff's level in the text; empty: there is none.
std::string_view read_level(std::string_view text);
/// Street in the text.
std::string_view read_street(std::string_view text);
/// Street of the destination in the text.
std::string_view read_destination(std::string_view text);
/// Distance in the text, in m.
std::optional<double> read_metres_to_go(std::string_view text);

}  // namespace canvoy::taxi
