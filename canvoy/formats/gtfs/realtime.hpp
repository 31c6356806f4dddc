// A GTFS-Realtime feed message (gtfs.org, Realtime reference, version 2.0): where vehicles are and
// how full, and how late their trips. Written as protobuf, for a file or whoever asks.
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

/// The trip of a schedule that is meant.
struct TripReference {
  std::string trip{};   ///< trip_id
  std::string route{};  ///< route_id
  std::optional<std::uint8_t> direction{};
  std::optional<Date> start_date{};       ///< the day of service
  std::optional<TimeOfDay> start_time{};  ///< needed where frequencies.txt has the trip
};

struct VehicleReference {
  std::string id{};
  std::string label{};  ///< what passengers read on it
};

enum class StopStatus : std::uint8_t { incoming_at = 0, stopped_at = 1, in_transit_to = 2 };

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

struct VehicleReport {
  VehicleReference vehicle{};
  std::optional<TripReference> trip{};  ///< empty: it is on none
  std::optional<double> latitude{};     ///< WGS 84, degrees; without both it has no position
  std::optional<double> longitude{};
  std::optional<double> bearing{};     ///< degrees from north, clockwise
  std::optional<double> odometer_m{};  ///< of the vehicle
  std::optional<double> speed_m_s{};
  std::optional<std::uint32_t> stop_sequence{};  ///< of the stop that `status` means
  std::string stop{};                            ///< stop_id
  std::optional<StopStatus> status{};
  std::optional<Occupancy> occupancy{};
  std::optional<std::uint32_t> occupancy_percent{};  ///< above 100 where it is overcrowded
  std::uint64_t timestamp = 0;                       ///< POSIX time; 0: unknown
};

/// Of a stop of a trip: late is positive; times are POSIX times, those of a forecast as well.
struct StopReport {
  std::uint32_t sequence = 0;
  std::string stop{};  ///< stop_id
  std::optional<std::int32_t> arrival_delay_s{};
  std::optional<std::int64_t> arrival_time{};  ///< s since 1970
  std::optional<std::int32_t> departure_delay_s{};
  std::optional<std::int64_t> departure_time{};  ///< s since 1970
  bool is_skipped = false;
};

struct TripReport {
  TripReference trip{};
  VehicleReference vehicle{};
  std::vector<StopReport> stops{};        ///< with rising sequences
  std::optional<std::int32_t> delay_s{};  ///< of the trip as a whole
  std::uint64_t timestamp = 0;
};

struct RealtimeFeed {
  std::uint64_t timestamp = 0;  ///< POSIX time at which it was made
  std::vector<VehicleReport> vehicles{};
  std::vector<TripReport> trips{};
};

/// A FeedMessage with the whole data set. Entities are called `vehicle-` and the vehicle's id,
/// `trip-` and the trip's with its date and time.
std::string realtime_bytes(const RealtimeFeed& feed);

}  // namespace canvoy::gtfs
