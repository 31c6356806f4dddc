#include "canvoy/sim/bus/display_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/bus/line_texts.hpp"
#include "canvoy/sim/bus/name_spelling.hpp"

namespace canvoy::bus {

namespace {

/// A text of the way that is shorter has room for another stop.
constexpr std::size_t way_full_from = 100;

bool is_next_stop(NodeId id) {
  return id == next_stop_id || id == second_next_stop_id;
}

}  // namespace

DisplayWatch::DisplayWatch(BusNodes& nodes, const BusLine& line, const BusDisplays& displays,
                           const BusVehicle& vehicle, BusReferee& referee,
                           EventLog<NetworkEvent>& events)
    : nodes_(nodes),
      line_(line),
      displays_(displays),
      vehicle_(vehicle),
      referee_(referee),
      events_(events),
      line_name_(code_points(line.name)) {
  for (const BusStop& stop : line.stops) names_.push_back(code_points(stop.name));
  seen_.fill(Seen::unreadable);
}

void DisplayWatch::displays_changed() {
  has_news_ = true;
  const Time now = nodes_.world().now();
  for (const NodeId id : display_ids) {
    const ShownDisplay* display = displays_.find(id);
    if (display == nullptr) continue;
    const std::string& text = display->text();
    if (text != told_texts_.at(id)) {
      told_texts_.at(id) = text;
      events_.note(now, DisplayShows{id, text});
      if (!text.empty()) ++texts_;
    }
    const std::u32string& shown = display->reading();
    // In the second car line and destination come one after the other.
    if (std::exchange(readings_.at(id), shown) == shown || car_of(id) != 1) continue;
    referee_.judge_one(InvariantKind::texts, now, shown.empty() || says_any(id, shown));
  }
}

void DisplayWatch::judge(Time now) {
  if (std::exchange(has_news_, false)) {
    for (const NodeId id : display_ids) seen_.at(id) = look(id);
  }
  const bool has_lie = std::ranges::any_of(
      display_ids, [this](NodeId id) { return is_led_by_us(id) && seen_.at(id) == Seen::lie; });
  referee_.judge(InvariantKind::next_stop, now, can_be_read(next_stop_id));
  referee_.judge(InvariantKind::destination, now,
                 can_be_read(front_display_id) && can_be_read(side_display_id));
  referee_.judge(InvariantKind::information, now, can_be_read(information_id));
  referee_.judge(InvariantKind::second_car, now,
                 can_be_read(second_destination_id) && can_be_read(second_next_stop_id));
  referee_.judge_honesty(now, !has_lie);
}

bool DisplayWatch::can_be_read(NodeId id) const {
  return !nodes_.is_played(id) || seen_.at(id) != Seen::unreadable;
}

/// What it shows comes from devices that are played.
bool DisplayWatch::is_led_by_us(NodeId id) const {
  return car_of(id) == 1 ||
         (nodes_.is_played(second_gateway_id) && nodes_.is_played(train_gateway_id));
}

DisplayWatch::Seen DisplayWatch::look(NodeId id) const {
  const std::u32string& shown = displays_.at(id).reading();
  if (shown.empty()) return Seen::unreadable;
  const BusTruth truth = vehicle_.truth();
  if (says(id, shown, *truth.route, truth.place)) return Seen::right;
  return says_any(id, shown) ? Seen::lie : Seen::unreadable;
}

/// What it shall at this stop of this route.
bool DisplayWatch::says(NodeId id, const std::u32string& shown, const BusRoute& route,
                        std::size_t place) const {
  if (is_next_stop(id)) return is_spelled(shown, name(route, place));
  if (id == information_id) return says_way(shown, route);
  return is_spelled(shown, line_name_ + U" " + code_points(route.destination));
}

/// Something that it may show on this line, some time.
bool DisplayWatch::says_any(NodeId id, const std::u32string& shown) const {
  if (is_next_stop(id)) {
    return std::ranges::any_of(names_, [&](const auto& name) { return is_spelled(shown, name); });
  }
  return std::ranges::any_of(line_.routes,
                             [&](const BusRoute& route) { return says(id, shown, route, 0); });
}

/// The line, where to, and as many of the stops between as there is room for.
bool DisplayWatch::says_way(const std::u32string& shown, const BusRoute& route) const {
  std::u32string text = line_name_ + U" to " + code_points(route.destination);
  std::u32string_view separator = U": ";
  for (std::size_t i = 1; i + 1 < route.stops.size(); ++i) {
    const std::u32string longer = text + std::u32string(separator) + std::u32string(name(route, i));
    const bool is_full = longer.size() > way_full_from;
    if (is_full && is_spelled(shown, text)) return true;
    text = longer;
    separator = U", ";
  }
  return is_spelled(shown, text);
}

}  // namespace canvoy::bus
