// Parses a line of a file of places: `lat lon | street | city | country`, degrees with a point,
// south and west below 0. Lines that are empty or begin with # are no places.
//
//     PlaceLine line = parse_place_line("48.13715 11.57538 | Marienplatz 1 | Munich | Germany");
//     if (line.error == PlaceLineError::none && line.has_place) go_to(line.place);
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/devices/cia447/navigation/gazetteer.hpp"

namespace canvoy::cia447 {

/// Why a line is no place.
enum class PlaceLineError : std::uint8_t {
  none,
  fields,     ///< not four fields
  latitude,   ///< missing, no number, or not from -90 to 90
  longitude,  ///< missing, no number, or not from -180 to 180
  position,   ///< characters behind the longitude
  length,     ///< a name has more than place_name_capacity bytes
  city,       ///< missing
};
/// Description of the error, without a full stop.
std::string_view text_of(PlaceLineError error);

struct PlaceLine {
  PlaceLineError error = PlaceLineError::none;  ///< none: see `has_place`
  bool has_place = false;                       ///< false: empty, or a comment
  NamedPlace place{};                           ///< its names refer to the line
};

/// Street and country may be empty.
PlaceLine parse_place_line(std::string_view line);

}  // namespace canvoy::cia447
