#include "canvoy/worlds/bus_line/display_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/worlds/bus_line/line_texts.hpp"
#include "canvoy/worlds/bus_line/name_spelling.hpp"

namespace canvoy::bus_line {

namespace {

/// A shorter text of the route has room for another stop.
constexpr std::size_t way_full_from = 100;

bool is_next_stop(DeviceKey key) {
  return key == next_stop_of(car_of(key));
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
      events_(events) {
  for (const BusRoute& route : line.routes) {
    line_names_.push_back(code_points(line.names_of(route).name));
  }
  for (const BusStop& stop : line.stops) names_.push_back(code_points(stop.name));
  seen_.fill(Seen::unreadable);
}

void DisplayWatch::displays_changed() {
  has_news_ = true;
  const Time now = nodes_.world().now();
  for (const DeviceKey key : display_ids) {
    const ShownDisplay* display = displays_.find(key);
    if (display == nullptr) continue;
    const std::string& text = display->text();
    if (text != told_texts_.at(key)) {
      told_texts_.at(key) = text;
      events_.note(now, DisplayShows{nodes_.id(key), text});
      if (!text.empty()) ++texts_;
    }
    const std::u32string& shown = display->reading();
    // Behind the first car, line and destination come one after the other.
    if (std::exchange(readings_.at(key), shown) == shown || car_of(key) != 1) continue;
    referee_.judge_one(InvariantKind::texts, now, shown.empty() || says_any(key, shown));
  }
}

void DisplayWatch::judge(Time now) {
  if (std::exchange(has_news_, false)) {
    for (const DeviceKey key : display_ids) {
      if (displays_.find(key) != nullptr) seen_.at(key) = look(key);
    }
  }
  const bool has_lie = std::ranges::any_of(display_ids, [this](DeviceKey key) {
    return is_led_by_us(key) && seen_.at(key) == Seen::lie;
  });
  referee_.judge(InvariantKind::next_stop, now, can_be_read(next_stop_id));
  referee_.judge(InvariantKind::destination, now,
                 can_be_read(front_display_id) && can_be_read(side_display_id));
  referee_.judge(InvariantKind::information, now, can_be_read(information_id));
  for (unsigned car = 2; car <= nodes_.cars(); ++car) {
    referee_.judge(car_kind(car), now,
                   can_be_read(destination_of(car)) && can_be_read(next_stop_of(car)));
  }
  referee_.judge_honesty(now, !has_lie);
}

bool DisplayWatch::can_be_read(DeviceKey key) const {
  return !nodes_.is_played(key) || seen_.at(key) != Seen::unreadable;
}

/// True if what it shows comes from simulated devices.
bool DisplayWatch::is_led_by_us(DeviceKey key) const {
  return car_of(key) == 1 ||
         (nodes_.is_played(gateway_of(car_of(key))) && nodes_.is_played(train_gateway_id));
}

DisplayWatch::Seen DisplayWatch::look(DeviceKey key) const {
  const std::u32string& shown = displays_.at(key).reading();
  if (shown.empty()) return Seen::unreadable;
  const BusTruth truth = vehicle_.truth();
  if (says(key, shown, *truth.route, {truth.place, truth.reached()})) return Seen::right;
  return says_any(key, shown) ? Seen::lie : Seen::unreadable;
}

/// True if it has its text for this position on this route.
bool DisplayWatch::says(DeviceKey key, const std::u32string& shown, const BusRoute& route,
                        const Place& place) const {
  if (is_next_stop(key)) return is_spelled(shown, name(route, place.next));
  const std::u32string destination = code_points(route.destination_at(place.reached));
  if (key == information_id) return says_way(shown, route, destination);
  return is_spelled(shown, line_name(route) + U" " + destination);
}

/// True if it may show this text on this line at any time.
bool DisplayWatch::says_any(DeviceKey key, const std::u32string& shown) const {
  if (is_next_stop(key)) {
    return std::ranges::any_of(names_, [&](const auto& name) { return is_spelled(shown, name); });
  }
  return std::ranges::any_of(line_.routes, [&](const BusRoute& route) {
    for (std::size_t i = 0; i < route.stops.size(); ++i) {
      const bool is_other = i == 0 || route.destination_at(i) != route.destination_at(i - 1);
      if (is_other && says(key, shown, route, {i, i})) return true;
    }
    return false;
  });
}

/// True if the text has the line, the destination, and as many of the stops between as fit; names
/// that would fill it alone need not be among them.
bool DisplayWatch::says_way(const std::u32string& shown, const BusRoute& route,
                            const std::u32string& destination) const {
  const std::u32string start = line_name(route) + U" to " + destination;
  const std::size_t room = text_octets_max - std::min(start.size(), text_octets_max);
  return says_stops(shown, route, start, text_octets_max) ||
         says_stops(shown, route, start, room / 2);
}

/// True with the names of at most `longest` characters.
bool DisplayWatch::says_stops(const std::u32string& shown, const BusRoute& route,
                              std::u32string text, std::size_t longest) const {
  std::u32string_view separator = U": ";
  for (std::size_t i = 1; i + 1 < route.stops.size(); ++i) {
    if (name(route, i).size() > longest) continue;
    const std::u32string longer = text + std::u32string(separator) + std::u32string(name(route, i));
    const bool is_full = longer.size() > way_full_from;
    if (is_full && is_spelled(shown, text)) return true;
    text = longer;
    separator = U", ";
  }
  return is_spelled(shown, text);
}

}  // namespace canvoy::bus_line
