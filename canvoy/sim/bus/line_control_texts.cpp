// What the on-board computer tells: numbers by its pre-defined messages, texts to displays.
#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/sim/bus/line_control.hpp"
#include "canvoy/sim/bus/line_texts.hpp"

namespace canvoy::bus {

namespace {

/// Of 6112h: as many as the displays have room for.
constexpr std::size_t stop_texts = 64;
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
  for (Served& each : served_) {
    DisplayView view;
    if (journey_ != nullptr) view = view_of(each.use);
    each.feed.want(std::move(view));
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
          .sub = static_cast<std::uint8_t>(place % stop_texts + 1),
          .octets = octets_of_text(to_latin_1(line().stop(journey_->route, place).name))};
}

DisplayView LineControl::view_of(DisplayUse use) const {
  DisplayView view;
  switch (use) {
    case DisplayUse::destination:
      view.shown = {{description_index, 1, 0, octets_of_text(to_ascii(line().name))},
                    {destination_index, 1, 0, octets_of_text(to_ascii(route().destination))}};
      break;
    case DisplayUse::next_stop:
      view.character_set = latin_1;
      if (!knows_stop()) break;
      view.shown = {stop_text(place_)};
      for (std::size_t ahead = 1; ahead <= texts_ahead; ++ahead) {
        if (place_ + ahead < route().stops.size()) view.soon.push_back(stop_text(place_ + ahead));
      }
      break;
    case DisplayUse::information:
      view.character_set = latin_1;
      view.shown = {
          {description_index, 1, 0, octets_of_text(to_latin_1(route_text(line(), route())))}};
      break;
  }
  return view;
}

}  // namespace canvoy::bus
