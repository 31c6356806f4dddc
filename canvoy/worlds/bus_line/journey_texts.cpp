#include "canvoy/worlds/bus_line/journey_texts.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/worlds/bus_line/line_texts.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::size_t texts_ahead = 8;
constexpr std::uint16_t description_index = cia407::text_line_route_description_object.index;
constexpr std::uint16_t destination_index = cia407::text_of_destination_object.index;
constexpr std::uint16_t stop_index = cia407::text_of_stop_point_object.index;
/// Set of the on-board computer itself, and of the other cars: their readers have no 6205h.
constexpr std::uint16_t known_set[] = {latin_1};

}  // namespace

std::vector<DisplayText> JourneyTexts::all() const {
  DisplayView texts;
  texts.soon = {{description_index, 1, 0, octets_of_text(to_latin_1(whole_route(known_set)))},
                {destination_index, 1, 0, octets_of_text(to_latin_1(destination()))}};
  add_next_stops(texts, known_set);
  return std::move(texts.soon);
}

std::string JourneyTexts::whole_route(CharacterSets sets) const {
  return route_text(line_, route(), destination(), sets);
}

DisplayText JourneyTexts::stop_text(std::size_t place, CharacterSets sets) const {
  return {.index = stop_index,
          .sub = stop_text_sub(place),
          .octets = octets_of_text(encode(line_.stop(journey_->route, place).name, sets).octets)};
}

/// Adds the stops from the next one on.
void JourneyTexts::add_next_stops(DisplayView& view, CharacterSets sets) const {
  if (!next_.is_known) return;
  for (std::size_t place = next_.place; place <= next_.place + texts_ahead; ++place) {
    if (place < route().stops.size()) view.soon.push_back(stop_text(place, sets));
  }
}

/// The other cars receive the texts, and select by the number of the stop in the route (610Ah); a
/// blank is none.
DisplayView JourneyTexts::view_for_train() const {
  const bool is_known = journey_ != nullptr;
  const std::string line = is_known ? to_ascii(line_name()) : " ";
  const std::string where_to = is_known ? to_ascii(destination()) : " ";
  DisplayView view{.has_mapping = false};
  view.soon = {{description_index, 1, 0, octets_of_text(line)},
               {destination_index, 1, 0, octets_of_text(where_to)}};
  add_next_stops(view, known_set);
  return view;
}

bool JourneyTexts::need_more_sets(const BusLine& line) {
  const auto is_beyond = [](const std::string& text) { return !is_latin_1(text); };
  const auto has_beyond = [&](const BusRoute& route) {
    return is_beyond(line.names_of(route).name) || is_beyond(route.destination) ||
           std::ranges::any_of(route.stops, is_beyond, &RouteStop::destination);
  };
  return is_beyond(line.name) || std::ranges::any_of(line.stops, is_beyond, &BusStop::name) ||
         std::ranges::any_of(line.routes, has_beyond);
}

DisplayView JourneyTexts::view_of(DisplayUse use, CharacterSets sets) const {
  DisplayView view;
  if (use == DisplayUse::train) return view_for_train();
  if (journey_ == nullptr) return view;
  switch (use) {
    case DisplayUse::destination:
      view.shown = {{description_index, 1, 0, octets_of_text(to_ascii(line_name()))},
                    {destination_index, 1, 0, octets_of_text(to_ascii(destination()))}};
      break;
    case DisplayUse::next_stop:
      if (!next_.is_known) break;
      view.character_set =
          encode(line_.stop(journey_->route, next_.place).name, sets).character_set;
      view.shown = {stop_text(next_.place, sets)};
      add_next_stops(view, sets);
      break;
    case DisplayUse::information: {
      const EncodedText text = encode(whole_route(sets), sets);
      view.character_set = text.character_set;
      view.shown = {{description_index, 1, 0, octets_of_text(text.octets)}};
      break;
    }
    case DisplayUse::train:
      break;
  }
  return view;
}

}  // namespace canvoy::bus_line
