// What a GTFS feed (gtfs.org, Schedule reference) says of one route: plain data, without a way to
// read it (feed_reader.hpp), so that who simulates it needs no file.
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
/// Since noon minus twelve hours of the day of service; above 24 h after its midnight.
using TimeOfDay = std::chrono::seconds;

/// Where something is that is not there.
inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Agency {
  std::string id{};
  std::string name{};
  std::string timezone{};  ///< as the TZ database has it
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
  std::string code{};  ///< short, as passengers know it
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
  std::optional<TimeOfDay> arrival{};  ///< empty: between those that have one
  std::optional<TimeOfDay> departure{};
  std::optional<double> shape_distance{};  ///< in the unit of the shape
  std::uint32_t sequence = 0;              ///< rising along the trip, with gaps
  std::uint32_t line = 0;                  ///< of stop_times.txt
  Exchange boarding = Exchange::regular;
  Exchange alighting = Exchange::regular;
  bool is_timing_point = true;  ///< its times are kept
  std::string headsign{};       ///< from here on; empty: that of the trip
};

/// A trip that runs again and again instead of at the times of its calls.
struct Frequency {
  TimeOfDay start{};
  TimeOfDay end{};
  std::chrono::seconds headway{};
};

struct Trip {
  std::string id{};
  std::string service{};
  std::string headsign{};
  std::string short_name{};
  std::string block{};  ///< trips of a block are driven by one vehicle
  std::optional<std::uint8_t> direction{};
  std::size_t shape = none;   ///< of Feed::shapes
  std::vector<Call> calls{};  ///< in the order of their sequence
  std::vector<Frequency> frequencies{};
};

struct ShapePoint {
  double latitude = 0;
  double longitude = 0;
  std::optional<double> distance;  ///< in a unit of the feed's choice
  std::uint32_t sequence = 0;
};

struct Shape {
  std::string id{};
  std::vector<ShapePoint> points{};
};

/// On which days trips run.
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

/// All that belongs to one route.
struct Feed {
  Agency agency{};
  FeedInfo info{};
  Route route{};
  std::vector<Stop> stops{};
  std::vector<Trip> trips{};
  std::vector<Shape> shapes{};
  std::vector<Service> services{};

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
