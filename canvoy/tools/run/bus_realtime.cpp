#include "canvoy/tools/run/bus_realtime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "canvoy/can/host/file_draft.hpp"
#include "canvoy/gateway/tcp_address.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/run/http_server.hpp"

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

namespace {

class RealtimeFile : public RealtimeOutlet {
 public:
  explicit RealtimeFile(std::string path) : path_(std::move(path)) {}

  void tell(bus::BusNetwork& network) override {
    const std::string feed = gtfs::realtime_bytes(realtime_of(network));
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(feed.data());
    host::Result<host::FileDraft> draft = host::FileDraft::begin(path_);
    if (!draft) throw Failure("--gtfs-rt: " + draft.error().line());
    ok(draft->write({bytes, feed.size()}));
    ok(draft->replace());
  }

 private:
  static void ok(const host::Result<void>& result) {
    if (!result) throw Failure("--gtfs-rt: " + result.error().line());
  }

  std::string path_;
};

class RealtimeServer : public RealtimeOutlet {
 public:
  explicit RealtimeServer(std::unique_ptr<HttpServer> server) : server_(std::move(server)) {}

  void tell(bus::BusNetwork& network) override {
    server_->publish(gtfs::realtime_bytes(realtime_of(network)));
  }

 private:
  std::unique_ptr<HttpServer> server_;
};

/// Where to listen, the first of these that can be had; none: `where` is a file.
std::vector<std::string> addresses_of(const std::string& where) {
  if (!where.starts_with(':')) {
    return gateway::parse_tcp_address(where) ? std::vector{where} : std::vector<std::string>{};
  }
  // The first one takes IPv4 as well, where the machine has both.
  std::vector<std::string> all = {"[::]" + where, "0.0.0.0" + where};
  if (!gateway::parse_tcp_address(all.back())) {
    throw UsageError(fmt::format(
        "--gtfs-rt: '{}' is no port; write :8080, or ./{} for a file of this name", where, where));
  }
  return all;
}

}  // namespace

std::unique_ptr<RealtimeOutlet> open_realtime(const std::string& where, bus::BusNetwork& network) {
  const std::vector<std::string> addresses = addresses_of(where);
  std::string problem;
  for (const std::string& address : addresses) {
    auto server = HttpServer::create(address, "application/x-protobuf",
                                     gtfs::realtime_bytes(realtime_of(network)));
    if (server) {
      fmt::print(stderr, "canvoy: GTFS-Realtime is served at http://{}/\n", (*server)->address());
      return std::make_unique<RealtimeServer>(*std::move(server));
    }
    problem = server.error().line();
  }
  if (!addresses.empty()) throw Failure("--gtfs-rt: " + problem);
  auto file = std::make_unique<RealtimeFile>(where);
  file->tell(network);
  return file;
}

}  // namespace canvoy::tools
