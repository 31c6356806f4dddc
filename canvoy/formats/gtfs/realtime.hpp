// Writes a GTFS-Realtime feed message as protobuf (gtfs.org, Realtime reference, version 2.0):
// positions and occupancy of vehicles, and delays of trips.
//
//     RealtimeFeed feed{.timestamp = 1'795'449'600, .vehicles = {...}, .trips = {...}};
//     const std::string bytes = realtime_bytes(feed);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/formats/gtfs/feed.hpp"

namespace canvoy::gtfs {

/// The trip of a schedule.
struct TripReference {
  std::string trip{};                       ///< trip_id
  std::string route{};                      ///< route_id
  std::optional<std::uint8_t> direction{};  ///< 0 or 1
  std::optional<Date> start_date{};         ///< the day of service
  std::optional<TimeOfDay> start_time{};    ///< required if frequencies.txt has the trip
};

/// A vehicle.
struct VehicleReference {
  std::string id{};     ///< unique in the feed
  std::string label{};  ///< shown to passengers
};

/// Where a vehicle is in relation to its stop.
enum class StopStatus : std::uint8_t { incoming_at = 0, stopped_at = 1, in_transit_to = 2 };

/// How full a vehicle is.
enum class Occupancy : std::uint8_t {
  empty = 0,
  many_seats = 1,
  few_seats = 2,
  standing_room = 3,
  crushed_standing_room = 4,
  full = 5,
  not_accepting = 6,
  no_data = 7,
  not_boardable = 8,
};

/// Position and occupancy of a vehicle.
struct VehicleReport {
  VehicleReference vehicle{};           ///< which one
  std::optional<TripReference> trip{};  ///< empty: not on a trip
  std::optional<double> latitude{};     ///< WGS 84, degrees; both are needed for a position
  std::optional<double> longitude{};    ///< WGS 84, degrees
  std::optional<double> bearing{};      ///< degrees clockwise from north
  std::optional<double> odometer_m{};   ///< of the vehicle
  std::optional<double> speed_m_s{};    ///< metres per second
  std::optional<std::uint32_t> stop_sequence{};      ///< of the stop that `status` refers to
  std::string stop{};                                ///< stop_id
  std::optional<StopStatus> status{};                ///< in relation to the stop
  std::optional<Occupancy> occupancy{};              ///< how full it is
  std::optional<std::uint32_t> occupancy_percent{};  ///< above 100 if overcrowded
  std::uint64_t timestamp = 0;                       ///< POSIX time; 0: unknown
};

/// Times at a stop of a trip: a positive delay is late; times are POSIX times, also of forecasts.
struct StopReport {
  std::uint32_t sequence = 0;                       ///< stop_sequence
  std::string stop{};                               ///< stop_id
  std::optional<std::int32_t> arrival_delay_s{};    ///< seconds; negative: early
  std::optional<std::int64_t> arrival_time{};       ///< s since 1970
  std::optional<std::int32_t> departure_delay_s{};  ///< seconds; negative: early
  std::optional<std::int64_t> departure_time{};     ///< s since 1970
  bool is_skipped = false;                          ///< the trip does not call here
};

/// Delays of a trip.
struct TripReport {
  TripReference trip{};                   ///< which one
  VehicleReference vehicle{};             ///< that drives it
  std::vector<StopReport> stops{};        ///< in increasing sequence
  std::optional<std::int32_t> delay_s{};  ///< of the trip as a whole
  std::uint64_t timestamp = 0;            ///< POSIX time; 0: unknown
};

/// A whole feed message.
struct RealtimeFeed {
  std::uint64_t timestamp = 0;            ///< POSIX time of creation
  std::vector<VehicleReport> vehicles{};  ///< one for each vehicle
  std::vector<TripReport> trips{};        ///< one for each trip
};

/// A FeedMessage with the full data set. Names of entities are `vehicle-` with the id of the
/// vehicle, and `trip-` with the id, date and time of the trip.
std::string realtime_bytes(const RealtimeFeed& feed);

}  // namespace canvoy::gtfs
