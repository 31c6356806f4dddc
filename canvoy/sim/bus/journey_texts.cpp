#include "canvoy/sim/bus/journey_texts.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

constexpr std::size_t texts_ahead = 8;
constexpr std::uint16_t description_index = cia407::text_line_route_description_object.index;
constexpr std::uint16_t destination_index = cia407::text_of_destination_object.index;
constexpr std::uint16_t stop_index = cia407::text_of_stop_point_object.index;
/// Of the on-board computer itself, and of the other cars: who reads there has no 6205h.
constexpr std::uint16_t known_set[] = {latin_1};

}  // namespace

std::vector<DisplayText> JourneyTexts::all() const {
  DisplayView texts;
  texts.soon = {
      {description_index, 1, 0, octets_of_text(to_latin_1(route_text(line_, route(), known_set)))},
      {destination_index, 1, 0, octets_of_text(to_latin_1(route().destination))}};
  add_next_stops(texts, known_set);
  return std::move(texts.soon);
}

DisplayText JourneyTexts::stop_text(std::size_t place, CharacterSets sets) const {
  return {.index = stop_index,
          .sub = stop_text_sub(place),
          .octets = octets_of_text(encode(line_.stop(journey_->route, place).name, sets).octets)};
}

/// From the one it goes to on.
void JourneyTexts::add_next_stops(DisplayView& view, CharacterSets sets) const {
  if (!next_.is_known) return;
  for (std::size_t place = next_.place; place <= next_.place + texts_ahead; ++place) {
    if (place < route().stops.size()) view.soon.push_back(stop_text(place, sets));
  }
}

/// The other cars get the texts, and go by the number of the stop in the route (610Ah); a blank is
/// none.
DisplayView JourneyTexts::view_for_train() const {
  const bool is_known = journey_ != nullptr;
  const std::string line_name = is_known ? to_ascii(line_.name) : " ";
  const std::string destination = is_known ? to_ascii(route().destination) : " ";
  DisplayView view{.has_mapping = false};
  view.soon = {{description_index, 1, 0, octets_of_text(line_name)},
               {destination_index, 1, 0, octets_of_text(destination)}};
  add_next_stops(view, known_set);
  return view;
}

bool JourneyTexts::need_more_sets(const BusLine& line) {
  const auto is_beyond = [](const std::string& text) { return !is_latin_1(text); };
  return is_beyond(line.name) || std::ranges::any_of(line.stops, is_beyond, &BusStop::name) ||
         std::ranges::any_of(line.routes, is_beyond, &BusRoute::destination);
}

DisplayView JourneyTexts::view_of(DisplayUse use, CharacterSets sets) const {
  DisplayView view;
  if (use == DisplayUse::train) return view_for_train();
  if (journey_ == nullptr) return view;
  switch (use) {
    case DisplayUse::destination:
      view.shown = {{description_index, 1, 0, octets_of_text(to_ascii(line_.name))},
                    {destination_index, 1, 0, octets_of_text(to_ascii(route().destination))}};
      break;
    case DisplayUse::next_stop:
      if (!next_.is_known) break;
      view.character_set =
          encode(line_.stop(journey_->route, next_.place).name, sets).character_set;
      view.shown = {stop_text(next_.place, sets)};
      add_next_stops(view, sets);
      break;
    case DisplayUse::information: {
      const EncodedText text = encode(route_text(line_, route(), sets), sets);
      view.character_set = text.character_set;
      view.shown = {{description_index, 1, 0, octets_of_text(text.octets)}};
      break;
    }
    case DisplayUse::train:
      break;
  }
  return view;
}

}  // namespace canvoy::bus
