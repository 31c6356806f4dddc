#include "canvoy/tools/run/bus_realtime.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "canvoy/can/host/file_draft.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr unsigned full_percent = 100;

gtfs::Occupancy occupancy(unsigned share) {
  using gtfs::Occupancy;
  if (share == 0) return Occupancy::empty;
  if (share < 30) return Occupancy::many_seats;
  if (share < 55) return Occupancy::few_seats;
  if (share < 85) return Occupancy::standing_room;
  return share < full_percent ? Occupancy::crushed_standing_room : Occupancy::full;
}

std::int32_t in_whole_seconds(Duration time) {
  return static_cast<std::int32_t>(std::chrono::floor<std::chrono::seconds>(time).count());
}

}  // namespace

gtfs::RealtimeFeed realtime_of(bus::BusNetwork& network) {
  const bus::BusNetworkSnapshot now = network.snapshot();
  const auto timestamp = static_cast<std::uint64_t>(std::max<bus::EpochSeconds>(now.utc, 0));
  const bus::Passing& passing = now.truth.journey->passings[now.truth.place];
  gtfs::TripReference trip{.trip = now.truth.journey->trip,
                           .route = network.line().id,
                           .direction = now.truth.route->is_backward ? 1 : 0,
                           .start_date = network.options().date};
  if (now.truth.journey->is_repeated) {
    trip.start_time =
        std::chrono::floor<std::chrono::seconds>(now.truth.journey->passings.front().departure);
  }
  const gtfs::VehicleReference vehicle{.id = "407", .label = network.line().name};
  const unsigned capacity = std::max(1U, network.options().vehicle.riders.capacity);
  const unsigned share = now.counted * full_percent / capacity;
  gtfs::RealtimeFeed feed{.timestamp = timestamp};
  feed.vehicles.push_back({.vehicle = vehicle,
                           .trip = trip,
                           .latitude = now.position.latitude,
                           .longitude = now.position.longitude,
                           .bearing = now.heading,
                           .odometer_m = now.odometer,
                           .speed_m_s = now.speed,
                           .stop_sequence = passing.sequence,
                           .stop = now.truth.stop->id,
                           .status = now.truth.is_at_stop ? gtfs::StopStatus::stopped_at
                                                          : gtfs::StopStatus::in_transit_to,
                           .occupancy = occupancy(share),
                           .occupancy_percent = share,
                           .timestamp = timestamp});
  feed.trips.push_back({.trip = trip,
                        .vehicle = vehicle,
                        .stops = {{.sequence = passing.sequence,
                                   .stop = now.truth.stop->id,
                                   .arrival_delay_s = in_whole_seconds(now.delay)}},
                        .delay_s = in_whole_seconds(now.delay),
                        .timestamp = timestamp});
  return feed;
}

void write_realtime(const std::string& path, bus::BusNetwork& network) {
  const std::string feed = gtfs::realtime_bytes(realtime_of(network));
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(feed.data());
  const auto ok = [](const host::Result<void>& result) {
    if (!result) throw Failure("--gtfs-rt: " + result.error().line());
  };
  host::Result<host::FileDraft> draft = host::FileDraft::begin(path);
  if (!draft) throw Failure("--gtfs-rt: " + draft.error().line());
  ok(draft->write({bytes, feed.size()}));
  ok(draft->replace());
}

}  // namespace canvoy::tools
