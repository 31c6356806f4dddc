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

/// An operator (agency.txt).
struct Agency {
  std::string id{};        ///< agency_id; may be empty if there is one agency
  std::string name{};      ///< for passengers
  std::string timezone{};  ///< from the TZ database
  std::string language{};  ///< BCP 47; may be empty
};

/// The feed itself (feed_info.txt); all may be empty.
struct FeedInfo {
  std::string publisher{};      ///< for passengers
  std::string language{};       ///< BCP 47
  std::string version{};        ///< of the feed, as the publisher counts
  std::optional<Date> start{};  ///< first day of validity
  std::optional<Date> end{};    ///< last day of validity
};

/// A place where vehicles stop (stops.txt).
struct Stop {
  std::string id{};      ///< stop_id
  std::string code{};    ///< short, for passengers
  std::string name{};    ///< for passengers
  std::string zone{};    ///< of fares
  double latitude = 0;   ///< WGS 84, degrees
  double longitude = 0;  ///< WGS 84, degrees
};

/// A line of the timetable (routes.txt).
struct Route {
  std::string id{};          ///< route_id
  std::string agency{};      ///< agency_id; may be empty if there is one agency
  std::string short_name{};  ///< for passengers: `42`
  std::string long_name{};   ///< for passengers: `Airport`
  unsigned type = 3;         ///< 3: bus

  /// What passengers call it: the short name if there is one.
  const std::string& name() const { return short_name.empty() ? long_name : short_name; }
};

/// How passengers get on or off at a call.
enum class Exchange : std::uint8_t { regular = 0, not_offered = 1, by_phone = 2, by_driver = 3 };

/// A stop time: a trip calls at a stop.
struct Call {
  std::size_t stop = none;                 ///< of Feed::stops
  std::optional<TimeOfDay> arrival{};      ///< empty: between the calls with a time
  std::optional<TimeOfDay> departure{};    ///< empty: between the calls with a time
  std::optional<double> shape_distance{};  ///< in the unit of the shape
  std::uint32_t sequence = 0;              ///< increasing along the trip, with gaps
  std::uint32_t line = 0;                  ///< of stop_times.txt
  Exchange boarding = Exchange::regular;   ///< pickup_type
  Exchange alighting = Exchange::regular;  ///< drop_off_type
  bool is_timing_point = true;             ///< departure times are kept
  std::string headsign{};                  ///< shown from this stop on; empty: that of the trip
};

/// A trip that repeats at intervals instead of at the times of its calls.
struct Frequency {
  TimeOfDay start{};  ///< first departure
  TimeOfDay end{};
  std::chrono::seconds headway{};  ///< from one departure to the next
};

/// One journey of a vehicle (trips.txt), on each day of its service.
struct Trip {
  std::string id{};                         ///< trip_id
  std::size_t other_route = none;           ///< index in Feed::other_routes; none: the route itself
  std::string service{};                    ///< service_id
  std::string headsign{};                   ///< destination, for passengers
  std::string short_name{};                 ///< for passengers
  std::string block{};                      ///< one vehicle drives all trips of a block
  std::optional<std::uint8_t> direction{};  ///< 0 or 1, as the feed defines
  std::size_t shape = none;                 ///< of Feed::shapes
  std::vector<Call> calls{};                ///< in the order of their sequence
  std::vector<Frequency> frequencies{};     ///< empty: at the times of its calls
};

/// A point of the path of a vehicle (shapes.txt).
struct ShapePoint {
  double latitude = 0;             ///< WGS 84, degrees
  double longitude = 0;            ///< WGS 84, degrees
  std::optional<double> distance;  ///< in a unit that the feed chooses
  std::uint32_t sequence = 0;      ///< increasing along the path, with gaps
};

/// The path of a vehicle.
struct Shape {
  std::string id{};                  ///< shape_id
  std::vector<ShapePoint> points{};  ///< in the order of their sequence
};

/// Days on which trips run.
struct Service {
  std::string id{};             ///< service_id
  std::uint8_t weekdays = 0;    ///< bit 0 is Monday
  std::optional<Date> start{};  ///< first day of `weekdays`
  std::optional<Date> end{};    ///< last day of `weekdays`, included
  std::vector<Date> added{};    ///< service in addition
  std::vector<Date> removed{};  ///< no service, though a weekday says so

  /// True if trips run on this day. Linear in the days added and removed.
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
  Agency agency{};                    ///< of the route
  FeedInfo info{};                    ///< of the feed
  Route route{};                      ///< that was asked for
  std::vector<Route> other_routes{};  ///< of trips in the same blocks
  std::vector<Stop> stops{};          ///< in the order of the file
  std::vector<Trip> trips{};          ///< in the order of the file
  std::vector<Shape> shapes{};        ///< of the trips
  std::vector<Service> services{};    ///< of the trips
  std::vector<std::string> notes{};   ///< what was omitted and why, one line each

  /// The route of a trip of this feed.
  const Route& route_of(const Trip& trip) const {
    return trip.other_route == none ? route : other_routes[trip.other_route];
  }
  /// The service with this id, or null. Linear in the services.
  const Service* service(const std::string& id) const {
    const auto found = std::find_if(services.begin(), services.end(),
                                    [&](const Service& each) { return each.id == id; });
    return found == services.end() ? nullptr : &*found;
  }
  /// True if a trip runs on this day of service.
  bool runs_on(const Trip& trip, const Date& date) const {
    const Service* const found = service(trip.service);
    return found != nullptr && found->runs_on(date);
  }
};

}  // namespace canvoy::gtfs
