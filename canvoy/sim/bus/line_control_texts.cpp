// What the on-board computer tells: numbers by its pre-defined messages, texts to displays.
#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/sim/bus/line_control.hpp"
#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

constexpr std::size_t texts_ahead = 8;
constexpr std::uint16_t description_index = cia407::text_line_route_description_object.index;
constexpr std::uint16_t destination_index = cia407::text_of_destination_object.index;
constexpr std::uint16_t stop_index = cia407::text_of_stop_point_object.index;
constexpr std::uint16_t latin_1 = 1;

}  // namespace

/// What is not known is not told.
void LineControl::tell() {
  const Told now = {journey_, knows_stop(), is_located_, place_, reached_};
  if (std::exchange(told_, now) == now) return;
  hardware_.computer->block_tickets(!now.knows_stop);
  if (now.knows_stop) {
    tell_position();
  } else {
    hardware_.computer->set_position({});
  }
  displays_.want([this](DisplayUse use) { return view_of(use); });
  keep_texts();
}

/// Whoever wants one may read it here (5.2).
void LineControl::keep_texts() {
  if (journey_ == nullptr) return;
  DisplayView texts;
  texts.soon = {{description_index, 1, 0, octets_of_text(to_latin_1(route_text(line(), route())))},
                {destination_index, 1, 0, octets_of_text(to_latin_1(route().destination))}};
  add_next_stops(texts);
  for (const DisplayText& text : texts.soon) {
    const Result<Entry> entry = node().dictionary().find(text.index, text.sub);
    if (entry) node().dictionary().set(*entry, text.octets);
  }
}

void LineControl::tell_position() {
  const BusStop& stop = line().stop(journey_->route, place_);
  // On the way to the first stop it has not reached another zone.
  if (is_located_) told_stop_ = route().stops[reached_];
  using cia407::JourneyDirection;
  hardware_.computer->set_line_name(to_ascii(line().name));
  hardware_.computer->set_stop_name(to_ascii(stop.short_name));
  hardware_.computer->set_position(
      {.stop_point_id = stop.number,
       .number_of_running = static_cast<std::uint8_t>(std::min<std::size_t>(place_ + 1, 255)),
       .fare_zone = told_stop_.fare_zone,
       .route_segment = told_stop_.route_segment,
       .direction = route().is_backward ? JourneyDirection::backward : JourneyDirection::forward});
}

DisplayText LineControl::stop_text(std::size_t place) const {
  return {.index = stop_index,
          .sub = stop_text_sub(place),
          .octets = octets_of_text(to_latin_1(line().stop(journey_->route, place).name))};
}

/// From the one it goes to on.
void LineControl::add_next_stops(DisplayView& view) const {
  if (!knows_stop()) return;
  for (std::size_t ahead = 0; ahead <= texts_ahead; ++ahead) {
    if (place_ + ahead < route().stops.size()) view.soon.push_back(stop_text(place_ + ahead));
  }
}

/// The other cars get the texts, and go by the number of the stop in the route (610Ah); a blank is
/// none.
DisplayView LineControl::view_for_train() const {
  const bool is_known = journey_ != nullptr;
  const std::string line_name = is_known ? to_ascii(line().name) : " ";
  const std::string destination = is_known ? to_ascii(route().destination) : " ";
  DisplayView view{.has_mapping = false};
  view.soon = {{description_index, 1, 0, octets_of_text(line_name)},
               {destination_index, 1, 0, octets_of_text(destination)}};
  add_next_stops(view);
  return view;
}

DisplayView LineControl::view_of(DisplayUse use) const {
  DisplayView view;
  if (use == DisplayUse::train) return view_for_train();
  if (journey_ == nullptr) return view;
  switch (use) {
    case DisplayUse::destination:
      view.shown = {{description_index, 1, 0, octets_of_text(to_ascii(line().name))},
                    {destination_index, 1, 0, octets_of_text(to_ascii(route().destination))}};
      break;
    case DisplayUse::next_stop:
      view.character_set = latin_1;
      if (!knows_stop()) break;
      view.shown = {stop_text(place_)};
      add_next_stops(view);
      break;
    case DisplayUse::information:
      view.character_set = latin_1;
      view.shown = {
          {description_index, 1, 0, octets_of_text(to_latin_1(route_text(line(), route())))}};
      break;
    case DisplayUse::train:
      break;
  }
  return view;
}

}  // namespace canvoy::bus
