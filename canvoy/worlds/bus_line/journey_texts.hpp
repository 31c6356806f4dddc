// The texts of a journey that displays must show and other devices may read: line, destination, the
// route, the stops from the next one on.
//
//     const JourneyTexts texts(line, journey, {.place = 3, .is_known = true});
//     displays.want([&](DisplayUse use, CharacterSets sets) { return texts.view_of(use, sets); });
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/display_server.hpp"

namespace canvoy::bus_line {

class JourneyTexts {
 public:
  /// The stop at which it stands, or the next one, as an index in the route.
  struct NextStop {
    std::size_t place = 0;    ///< index in the route
    bool is_known = false;    ///< false: the position of the vehicle is not known
    std::size_t reached = 0;  ///< the last stop that it has reached; the first stop before that
  };

  /// Both must outlive this object; null: no journey.
  JourneyTexts(const BusLine& line, const Journey* journey, const NextStop& next)
      : line_(line), journey_(journey), next_(next) {}

  /// Required contents of a display, each text in one of the sets that the display offers beside
  /// ISO 646-US.
  DisplayView view_of(DisplayUse use, CharacterSets sets) const;
  /// True if a text of the line has letters that ISO 8859-1 does not have.
  static bool need_more_sets(const BusLine& line);
  /// All texts of the on-board computer's own dictionary, where the journey is known (CiA 407,
  /// 5.2).
  std::vector<DisplayText> all() const;

 private:
  const BusRoute& route() const { return line_.routes[journey_->route]; }
  const std::string& destination() const { return route().destination_at(next_.reached); }
  std::string line_name() const { return line_.names_of(route()).name; }
  std::string whole_route(CharacterSets sets) const;
  DisplayView view_for_train() const;
  DisplayText stop_text(std::size_t place, CharacterSets sets) const;
  void add_next_stops(DisplayView& view, CharacterSets sets) const;

  const BusLine& line_;
  const Journey* journey_;
  NextStop next_;
};

}  // namespace canvoy::bus_line
