// The texts of a journey, as displays shall show them and others may read them: line, destination,
// the route, the stops from the next one on.
//
//     const JourneyTexts texts(line, journey, {.place = 3, .is_known = true});
//     displays.want([&](DisplayUse use, CharacterSets sets) { return texts.view_of(use, sets); });
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/sim/bus/bus_line.hpp"
#include "canvoy/sim/bus/display_server.hpp"

namespace canvoy::bus {

class JourneyTexts {
 public:
  /// The stop at which it stands, or the next one, in the route.
  struct NextStop {
    std::size_t place = 0;
    bool is_known = false;
  };

  /// Both must outlive this; no journey: null.
  JourneyTexts(const BusLine& line, const Journey* journey, const NextStop& next)
      : line_(line), journey_(journey), next_(next) {}

  /// Each text in one of the sets that the display offers beside ISO 646-US.
  DisplayView view_of(DisplayUse use, CharacterSets sets) const;
  /// Some text of the line has letters that ISO 8859-1 does not have.
  static bool need_more_sets(const BusLine& line);
  /// All that the on-board computer has in its own dictionary (5.2): the journey is known.
  std::vector<DisplayText> all() const;

 private:
  const BusRoute& route() const { return line_.routes[journey_->route]; }
  DisplayView view_for_train() const;
  DisplayText stop_text(std::size_t place, CharacterSets sets) const;
  void add_next_stops(DisplayView& view, CharacterSets sets) const;

  const BusLine& line_;
  const Journey* journey_;
  NextStop next_;
};

}  // namespace canvoy::bus
