#include "canvoy/devices/cia447/navigation/place_line.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "canvoy/devices/cia447/gps/nmea_fields.hpp"
#include "canvoy/profiles/cia447/positioning.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::string_view blanks = " \t\r";

constexpr std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  text.remove_suffix(text.size() - 1 - text.find_last_not_of(blanks));
  text.remove_prefix(first);
  return text;
}

/// Removes and returns the first word of `text`, with the blanks behind it.
constexpr std::string_view take_word(std::string_view& text) {
  const std::string_view word(text.data(), std::min(text.size(), text.find_first_of(blanks)));
  text.remove_prefix(word.size());
  text = trimmed(text);
  return word;
}

constexpr std::optional<double> angle(std::string_view word, double most) {
  const std::optional<double> degrees = decimal(word);
  if (!degrees || *degrees < -most || *degrees > most) return std::nullopt;
  return degrees;
}

PlaceLineError take_position(std::string_view text, GeoPosition& position) {
  const auto latitude = angle(take_word(text), 90);
  if (!latitude) return PlaceLineError::latitude;
  const auto longitude = angle(take_word(text), 180);
  if (!longitude) return PlaceLineError::longitude;
  position = {.latitude = *latitude, .longitude = *longitude};
  return text.empty() ? PlaceLineError::none : PlaceLineError::position;
}

}  // namespace

std::string_view text_of(PlaceLineError error) {
  switch (error) {
    case PlaceLineError::none:
      break;
    case PlaceLineError::fields:
      return "a place is: latitude longitude | street | city | country";
    case PlaceLineError::latitude:
      return "the latitude has to be a number of degrees from -90 to 90";
    case PlaceLineError::longitude:
      return "the longitude has to be a number of degrees from -180 to 180";
    case PlaceLineError::position:
      return "behind the longitude there has to be a |";
    case PlaceLineError::length:
      static_assert(place_name_capacity == 64);
      return "a name has more than 64 bytes";
    case PlaceLineError::city:
      return "the city is missing";
  }
  return "";
}

PlaceLine parse_place_line(std::string_view line) {
  line = trimmed(line);
  PlaceLine parsed;
  if (line.empty() || line.front() == '#') return parsed;
  std::array<std::string_view, 4> fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t bar = line.find('|');
    const bool is_last = i + 1 == fields.size();
    if ((bar == std::string_view::npos) != is_last) return {.error = PlaceLineError::fields};
    fields[i] = trimmed({line.data(), std::min(line.size(), bar)});
    if (!is_last) line.remove_prefix(bar + 1);
  }
  parsed.place = {.city = fields[2], .street = fields[1], .country = fields[3]};
  parsed.error = take_position(fields[0], parsed.place.position);
  for (const std::string_view name : {fields[1], fields[2], fields[3]}) {
    if (name.size() > place_name_capacity) parsed.error = PlaceLineError::length;
  }
  if (parsed.place.city.empty()) parsed.error = PlaceLineError::city;
  parsed.has_place = parsed.error == PlaceLineError::none;
  return parsed;
}

}  // namespace canvoy::cia447
