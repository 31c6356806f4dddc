#include "canvoy/worlds/bus_line/line_of_feed.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "canvoy/worlds/bus_line/places_along.hpp"

namespace canvoy::bus_line {

namespace {

constexpr unsigned links_of_segment = 1;
constexpr std::size_t products_max = 20'000'000;  ///< of stops and points of a shape
constexpr Duration turn_least = 2min;
constexpr double turn_near_m = 400;
constexpr unsigned zone_max = 255;
constexpr unsigned line_number_max = 0xFFFF;  ///< 6192h
constexpr double way_least_m = 20;            ///< from the first stop of a trip to the last
constexpr double beside_way_m = 1000;         ///< a stop that is farther off is not on this path

GeoPoint place_of(const gtfs::Stop& stop) {
  return {stop.latitude, stop.longitude};
}

/// Value of a text that is a number from 1 to `most`.
std::optional<unsigned> number_in(const std::string& text, unsigned most) {
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || rest != end || value < 1 || value > most) return std::nullopt;
  return value;
}

LineNames names_of(const gtfs::Route& route) {
  return {.number = number_in(route.short_name, line_number_max).value_or(0),
          .id = route.id,
          .name = route.name().empty() ? route.id : route.name()};
}

/// A trip as it is driven: two consecutive calls at one stop are one.
gtfs::Trip driven(gtfs::Trip trip) {
  std::vector<gtfs::Call> calls;
  for (gtfs::Call& call : trip.calls) {
    if (calls.empty() || calls.back().stop != call.stop) {
      calls.push_back(std::move(call));
      continue;
    }
    gtfs::Call& one = calls.back();
    if (!one.arrival) one.arrival = call.arrival;
    if (call.departure) one.departure = call.departure;
    if (call.boarding == gtfs::Exchange::regular) one.boarding = call.boarding;
    if (call.alighting == gtfs::Exchange::regular) one.alighting = call.alighting;
    one.is_timing_point = one.is_timing_point || call.is_timing_point;
    one.headsign = std::move(call.headsign);
  }
  trip.calls = std::move(calls);
  return trip;
}

/// True if a shape passes the stops in their order; `along` receives their distances along it.
bool is_way_of(const Path& path, const std::vector<GeoPoint>& places,
               const std::vector<double>& along) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (metres_between(path.at(along[i]), places[i]) > beside_way_m) return false;
  }
  return along.back() - along.front() >= way_least_m;
}

class Maker {
 public:
  Maker(const gtfs::Feed& feed, const gtfs::Date& date) : feed_(feed), date_(date) {}
  LineOfFeed make();

 private:
  using Times = std::vector<Passing>;

  void name_lines();
  void make_stops();
  void number_zones();
  std::uint8_t zone_of(std::size_t stop) const;
  std::size_t route_of(const gtfs::Trip& trip);
  BusRoute make_route(const gtfs::Trip& trip) const;
  Times times_of(const gtfs::Trip& trip, const BusRoute& route) const;
  void add_trip(const gtfs::Trip& trip);
  std::string problem_of(const BusRoute& route, const gtfs::Trip& trip) const;
  void add_journey(const gtfs::Trip& trip, std::size_t route, const Times& times,
                   std::optional<Duration> start);
  void make_blocks();
  bool is_own(const Journey& journey) const { return !line_.routes[journey.route].other_line; }
  Block& block_for(const Journey& journey, const std::string& id);
  double metres_to_turn(const Journey& before, const Journey& after) const;

  const gtfs::Feed& feed_;
  gtfs::Date date_;
  BusLine line_;
  std::map<std::string, std::uint8_t> zones_;
  /// Trips of a line with the same stops, headsigns and shape share a route.
  using Way = std::tuple<std::size_t, std::vector<std::pair<std::size_t, std::string>>, std::size_t,
                         std::string>;
  std::map<Way, std::size_t> routes_;
  std::vector<LineNames> other_lines_;
  std::string problem_;
  std::vector<std::pair<std::string, Journey>> journeys_;  ///< with their block_id
};

/// Gives a unique number to each line with a name that is not a number.
void Maker::name_lines() {
  const LineNames own = names_of(feed_.route);
  line_.number = own.number == 0 ? 1 : own.number;
  line_.id = own.id;
  line_.name = own.name;
  std::set<std::uint32_t> used = {0, line_.number};
  for (const gtfs::Route& route : feed_.other_routes) {
    LineNames& names = other_lines_.emplace_back(names_of(route));
    std::uint32_t next = 1;
    while (used.contains(names.number)) names.number = next++;
    used.insert(names.number);
  }
}

void Maker::make_stops() {
  for (const gtfs::Stop& stop : feed_.stops) {
    const auto count = static_cast<std::uint32_t>(line_.stops.size() + 1);
    line_.stops.push_back({.number = count,
                           .id = stop.id,
                           .name = stop.name.empty() ? stop.id : stop.name,
                           .short_name = stop.code,
                           .place = place_of(stop)});
  }
}

/// Numbers the zones as in the feed, where it has numbers; otherwise in the order of their names.
/// Beyond 255 there is no number: they get 0.
void Maker::number_zones() {
  std::set<std::string> names;
  for (const gtfs::Stop& stop : feed_.stops) {
    if (!stop.zone.empty()) names.insert(stop.zone);
  }
  const bool are_numbers = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return number_in(name, zone_max).has_value();
  });
  unsigned count = 0;
  for (const std::string& name : names) {
    ++count;
    const unsigned number = are_numbers ? number_in(name, zone_max).value_or(0) : count;
    zones_[name] = static_cast<std::uint8_t>(number > zone_max ? 0 : number);
  }
}

std::uint8_t Maker::zone_of(std::size_t stop) const {
  const auto found = zones_.find(feed_.stops[stop].zone);
  return found == zones_.end() ? std::uint8_t{0} : found->second;
}

BusRoute Maker::make_route(const gtfs::Trip& trip) const {
  BusRoute route{.number = static_cast<std::uint32_t>(line_.routes.size() + 1),
                 .destination = trip.headsign.empty() ? line_.stops[trip.calls.back().stop].name
                                                      : trip.headsign,
                 .is_backward = trip.direction == 1};
  if (trip.other_route != gtfs::none) route.other_line = other_lines_[trip.other_route];
  std::vector<GeoPoint> places;
  places.reserve(trip.calls.size());
  for (const gtfs::Call& call : trip.calls) places.push_back(place_of(feed_.stops[call.stop]));
  std::vector<GeoPoint> points;
  if (trip.shape != gtfs::none) {
    for (const gtfs::ShapePoint& point : feed_.shapes[trip.shape].points) {
      points.push_back({point.latitude, point.longitude});
    }
  }
  // Without a usable shape, the path goes straight from stop to stop.
  bool is_straight =
      points.size() < 2 || (points.size() + pieces_more_max) * places.size() > products_max;
  std::vector<double> along;
  if (!is_straight) {
    route.path = Path(std::move(points));
    along = places_along(route.path, places);
    is_straight = !is_way_of(route.path, places, along);
  }
  if (is_straight) route.path = Path(places);
  for (std::size_t i = 0; i < trip.calls.size(); ++i) {
    route.stops.push_back({.stop = trip.calls[i].stop,
                           .metres = is_straight ? route.path.metres_of(i) : along[i],
                           .fare_zone = zone_of(trip.calls[i].stop),
                           .destination = trip.calls[i].headsign});
  }
  // No passengers get on at the last stop.
  route.stops.back().destination = route.stops[route.stops.size() - 2].destination;
  number_segments(route, links_of_segment);
  return route;
}

std::size_t Maker::route_of(const gtfs::Trip& trip) {
  std::vector<std::pair<std::size_t, std::string>> stops;
  stops.reserve(trip.calls.size());
  for (const gtfs::Call& call : trip.calls) stops.emplace_back(call.stop, call.headsign);
  const auto [found, is_new] = routes_.try_emplace(
      Way(trip.other_route, std::move(stops), trip.shape, trip.headsign), line_.routes.size());
  if (is_new) line_.routes.push_back(make_route(trip));
  return found->second;
}

/// Calls without a time lie between those that have one, by their distances.
Maker::Times Maker::times_of(const gtfs::Trip& trip, const BusRoute& route) const {
  Times times;
  std::size_t before = 0;
  for (std::size_t i = 0; i < trip.calls.size(); ++i) {
    const gtfs::Call& call = trip.calls[i];
    Passing passing{.sequence = call.sequence,
                    .is_timing_point = call.is_timing_point,
                    .boards = call.boarding != gtfs::Exchange::not_offered,
                    .alights = call.alighting != gtfs::Exchange::not_offered};
    if (call.arrival) {
      passing.arrival = *call.arrival;
      passing.departure = *call.departure;
      before = i;
    } else {
      std::size_t after = i + 1;
      while (!trip.calls[after].arrival) ++after;
      const double way = route.stops[after].metres - route.stops[before].metres;
      const double share =
          way <= 0 ? 0 : (route.stops[i].metres - route.stops[before].metres) / way;
      const auto time = *trip.calls[after].arrival - *trip.calls[before].departure;
      passing.arrival = *trip.calls[before].departure +
                        std::chrono::seconds(
                            static_cast<std::int64_t>(share * static_cast<double>(time.count())));
      passing.departure = passing.arrival;
    }
    times.push_back(passing);
  }
  return times;
}

void Maker::add_journey(const gtfs::Trip& trip, std::size_t route, const Times& times,
                        std::optional<Duration> start) {
  Journey journey{.trip = trip.id, .route = route, .passings = times};
  journey.is_repeated = start.has_value();
  const Duration shift = start ? *start - times.front().departure : Duration{};
  for (Passing& passing : journey.passings) {
    passing.arrival += shift;
    passing.departure += shift;
  }
  journeys_.emplace_back(trip.block, std::move(journey));
}

std::string Maker::problem_of(const BusRoute& route, const gtfs::Trip& trip) const {
  const auto wrong = [&trip](const std::string& what) { return "trip '" + trip.id + "' " + what; };
  if (route.stops.size() > route_stops_max) {
    return wrong("has " + std::to_string(route.stops.size()) +
                 " stops: CiA 407 counts 255 of a route (610Ah)");
  }
  const bool has_way = route.stops.back().metres - route.stops.front().metres >= way_least_m;
  return has_way ? "" : wrong("has all of its stops at one place");
}

void Maker::add_trip(const gtfs::Trip& trip) {
  const std::size_t route = route_of(trip);
  if (problem_.empty()) problem_ = problem_of(line_.routes[route], trip);
  if (!problem_.empty()) return;
  const Times times = times_of(trip, line_.routes[route]);
  if (trip.frequencies.empty()) return add_journey(trip, route, times, std::nullopt);
  for (const gtfs::Frequency& each : trip.frequencies) {
    for (auto at = each.start; at < each.end; at += each.headway) {
      if (journeys_.size() > journeys_max) return;
      add_journey(trip, route, times, at);
    }
  }
}

double Maker::metres_to_turn(const Journey& before, const Journey& after) const {
  const BusRoute& end = line_.routes[before.route];
  const BusRoute& start = line_.routes[after.route];
  return metres_between(end.path.at(end.stops.back().metres),
                        start.path.at(start.stops.front().metres));
}

/// The block that continues with a journey, or a new one.
Block& Maker::block_for(const Journey& journey, const std::string& id) {
  for (Block& block : line_.blocks) {
    const Journey& last = block.journeys.back();
    const Duration free = last.passings.back().departure;
    const Duration start = journey.passings.front().departure;
    if (!id.empty()) {
      // Two trips of a block at the same time need two vehicles.
      if (block.id == id && free <= start) return block;
    } else if (block.id.empty() && free + turn_least <= start &&
               metres_to_turn(last, journey) <= turn_near_m) {
      return block;
    }
  }
  line_.blocks.push_back({.number = static_cast<std::uint32_t>(line_.blocks.size() + 1), .id = id});
  return line_.blocks.back();
}

void Maker::make_blocks() {
  std::stable_sort(journeys_.begin(), journeys_.end(), [](const auto& a, const auto& b) {
    return a.second.passings.front().departure < b.second.passings.front().departure;
  });
  // Blocks of other lines alone are ignored.
  std::set<std::string> own_blocks;
  for (const auto& [id, journey] : journeys_) {
    if (is_own(journey)) own_blocks.insert(id);
  }
  std::erase_if(journeys_, [&](const auto& each) {
    return !is_own(each.second) && !own_blocks.contains(each.first);
  });
  std::uint32_t number = 0;
  for (auto& [id, journey] : journeys_) {
    journey.number = ++number;
    Block& block = block_for(journey, id);
    block.journeys.push_back(std::move(journey));
  }
  // Two vehicles may have one block_id at a time: one of them with journeys of other lines alone.
  std::erase_if(line_.blocks, [this](const Block& block) {
    return std::none_of(block.journeys.begin(), block.journeys.end(),
                        [this](const Journey& journey) { return is_own(journey); });
  });
  std::uint32_t blocks = 0;
  for (Block& block : line_.blocks) block.number = ++blocks;
}

LineOfFeed Maker::make() {
  name_lines();
  make_stops();
  number_zones();
  for (const gtfs::Trip& trip : feed_.trips) {
    if (!feed_.runs_on(trip, date_)) continue;
    if (const gtfs::Trip as = driven(trip); as.calls.size() >= 2) add_trip(as);
  }
  if (!problem_.empty()) return {.problem = problem_};
  const bool has_own = std::any_of(journeys_.begin(), journeys_.end(),
                                   [this](const auto& each) { return is_own(each.second); });
  if (!has_own) return {.problem = "no trip of the route runs on this day"};
  if (journeys_.size() > journeys_max) return {.problem = "more than 100000 journeys on this day"};
  make_blocks();
  return {.line = std::move(line_)};
}

}  // namespace

LineOfFeed line_of_feed(const gtfs::Feed& feed, const gtfs::Date& date) {
  return Maker(feed, date).make();
}

}  // namespace canvoy::bus_line
