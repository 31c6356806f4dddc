// Content of a GTFS feed (gtfs.org, Schedule reference) for one route. Plain data; feed_reader.hpp
// reads it, so a simulation needs no file.
//
//     const Trip& trip = feed.trips.front();
//     feed.stops[trip.calls.front().stop].name;
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace canvoy::gtfs {

/// A day of service.
using Date = std::chrono::year_month_day;
/// Time since noon minus twelve hours of the day of service; above 24 h after its midnight.
using TimeOfDay = std::chrono::seconds;

/// Index of a missing element.
inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Agency {
  std::string id{};
  std::string name{};
  std::string timezone{};  ///< from the TZ database
  std::string language{};
};

struct FeedInfo {
  std::string publisher{};
  std::string language{};
  std::string version{};
  std::optional<Date> start{};
  std::optional<Date> end{};
};

struct Stop {
  std::string id{};
  std::string code{};  ///< short, for passengers
  std::string name{};
  std::string zone{};    ///< of fares
  double latitude = 0;   ///< WGS 84, degrees
  double longitude = 0;  ///< WGS 84, degrees
};

struct Route {
  std::string id{};
  std::string agency{};
  std::string short_name{};
  std::string long_name{};
  unsigned type = 3;  ///< 3: bus

  const std::string& name() const { return short_name.empty() ? long_name : short_name; }
};

/// How passengers get on or off at a call.
enum class Exchange : std::uint8_t { regular = 0, not_offered = 1, by_phone = 2, by_driver = 3 };

/// A stop time: a trip calls at a stop.
struct Call {
  std::size_t stop = none;             ///< of Feed::stops
  std::optional<TimeOfDay> arrival{};  ///< empty: between the calls with a time
  std::optional<TimeOfDay> departure{};
  std::optional<double> shape_distance{};  ///< in the unit of the shape
  std::uint32_t sequence = 0;              ///< increasing along the trip, with gaps
  std::uint32_t line = 0;                  ///< of stop_times.txt
  Exchange boarding = Exchange::regular;
  Exchange alighting = Exchange::regular;
  bool is_timing_point = true;  ///< departure times are kept
  std::string headsign{};       ///< shown from this stop on; empty: that of the trip
};

/// A trip that repeats at intervals instead of at the times of its calls.
struct Frequency {
  TimeOfDay start{};
  TimeOfDay end{};
  std::chrono::seconds headway{};
};

struct Trip {
  std::string id{};
  std::size_t other_route = none;  ///< index in Feed::other_routes; none: the route itself
  std::string service{};
  std::string headsign{};
  std::string short_name{};
  std::string block{};  ///< one vehicle drives all trips of a block
  std::optional<std::uint8_t> direction{};
  std::size_t shape = none;   ///< of Feed::shapes
  std::vector<Call> calls{};  ///< in the order of their sequence
  std::vector<Frequency> frequencies{};
};

struct ShapePoint {
  double latitude = 0;
  double longitude = 0;
  std::optional<double> distance;  ///< in a unit that the feed chooses
  std::uint32_t sequence = 0;
};

struct Shape {
  std::string id{};
  std::vector<ShapePoint> points{};
};

/// Days on which trips run.
struct Service {
  std::string id{};
  std::uint8_t weekdays = 0;  ///< bit 0 is Monday
  std::optional<Date> start{};
  std::optional<Date> end{};
  std::vector<Date> added{};
  std::vector<Date> removed{};

  bool runs_on(const Date& date) const {
    const auto has = [&](const std::vector<Date>& days) {
      return std::find(days.begin(), days.end(), date) != days.end();
    };
    if (has(added)) return true;
    if (has(removed) || !start || !end || date < *start || date > *end) return false;
    const unsigned day = std::chrono::weekday(date).iso_encoding() - 1;
    return (weekdays >> day & 1U) != 0;
  }
};

/// Content for one route, with the trips of other routes that its vehicles drive in the same
/// blocks.
struct Feed {
  Agency agency{};
  FeedInfo info{};
  Route route{};
  std::vector<Route> other_routes{};  ///< of trips in the same blocks
  std::vector<Stop> stops{};
  std::vector<Trip> trips{};
  std::vector<Shape> shapes{};
  std::vector<Service> services{};
  std::vector<std::string> notes{};  ///< what was omitted and why, one line each

  /// The route of a trip of this feed.
  const Route& route_of(const Trip& trip) const {
    return trip.other_route == none ? route : other_routes[trip.other_route];
  }
  const Service* service(const std::string& id) const {
    const auto found = std::find_if(services.begin(), services.end(),
                                    [&](const Service& each) { return each.id == id; });
    return found == services.end() ? nullptr : &*found;
  }
  bool runs_on(const Trip& trip, const Date& date) const {
    const Service* const found = service(trip.service);
    return found != nullptr && found->runs_on(date);
  }
};

}  // namespace canvoy::gtfs
