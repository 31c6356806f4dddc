#include "canvoy/tools/play/bus_realtime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/gateway/tcp_address.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/web/document_server.hpp"
#include "canvoy/worlds/bus_line/journey_forecast.hpp"

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

std::chrono::seconds in_whole_seconds(Duration time) {
  return std::chrono::floor<std::chrono::seconds>(time);
}

/// A stop of the forecast, with delays relative to the timetable.
gtfs::StopReport report_of(const bus_line::StopForecast& stop, const bus_line::Journey& journey,
                           const std::string& id, std::int64_t service_begin) {
  const bus_line::Passing& passing = journey.passings[stop.place];
  gtfs::StopReport report{.sequence = passing.sequence, .stop = id};
  const auto late = [](std::chrono::seconds time, Duration planned) {
    return static_cast<std::int32_t>((time - in_whole_seconds(planned)).count());
  };
  if (stop.arrival) {
    report.arrival_delay_s = late(*stop.arrival, passing.arrival);
    report.arrival_time = service_begin + stop.arrival->count();
  }
  if (stop.departure) {
    report.departure_delay_s = late(*stop.departure, passing.departure);
    report.departure_time = service_begin + stop.departure->count();
  }
  return report;
}

/// Makes a feed from the heard messages, with a clock of its own.
class FeedMaker {
 public:
  explicit FeedMaker(bus_line::BusNetwork& network)
      : network_(network),
        heard_(network.heard()),
        now_(network.now()),
        utc_(std::max<std::int64_t>(network.snapshot().utc, 0)),
        journey_(heard_.journey(now_)),
        stop_(heard_.stop(now_)),
        vehicle_{.id = "407", .label = network.line().name} {}

  gtfs::RealtimeFeed feed() const {
    gtfs::RealtimeFeed made{.timestamp = posix(now_)};
    const auto position = heard_.position(now_);
    if (stop_ && has_trip()) made.trips.push_back(trip_report());
    if (position || (stop_ && has_trip())) made.vehicles.push_back(vehicle_report(position));
    return made;
  }

 private:
  using Position = std::optional<bus_line::HeardBus::Aged<bus_line::GeoPoint>>;

  std::uint64_t posix(Time at) const {
    const auto age = std::chrono::ceil<std::chrono::seconds>(now_ - at).count();
    return static_cast<std::uint64_t>(std::max<std::int64_t>(utc_ - age, 0));
  }
  std::chrono::seconds of_day(Time at) const {
    return in_whole_seconds(network_.time_of_day() - (now_ - at));
  }
  /// The ways from the depot and back to it are not in the timetable of passengers.
  bool has_trip() const { return journey_ != nullptr && !journey_->trip.empty(); }
  const std::string& stop_id(std::size_t place) const {
    return network_.line().stop(journey_->route, place).id;
  }

  gtfs::TripReference trip() const {
    gtfs::TripReference made{
        .trip = journey_->trip,
        .route = network_.line().names_of(network_.line().routes[journey_->route]).id,
        .direction = network_.line().routes[journey_->route].is_backward ? 1 : 0,
        .start_date = network_.options().date};
    if (journey_->is_repeated) {
      made.start_time = in_whole_seconds(journey_->passings.front().departure);
    }
    return made;
  }

  gtfs::TripReport trip_report() const {
    const bus_line::HeardBus::Stop& stop = stop_->value;
    bus_line::JourneyProgress progress{.place = stop.place};
    if (stop.arrived) progress.arrived = of_day(*stop.arrived);
    if (stop.left_before) progress.left_before = of_day(*stop.left_before);
    gtfs::TripReport report{.trip = trip(), .vehicle = vehicle_, .timestamp = posix(stop_->heard)};
    const std::int64_t service_begin = utc_ - of_day(now_).count();
    for (const bus_line::StopForecast& each :
         bus_line::forecast(*journey_, progress, of_day(now_))) {
      report.stops.push_back(report_of(each, *journey_, stop_id(each.place), service_begin));
    }
    const gtfs::StopReport& next = report.stops.front();
    report.delay_s = next.arrival_delay_s ? next.arrival_delay_s : next.departure_delay_s;
    return report;
  }

  gtfs::VehicleReport vehicle_report(const Position& position) const {
    gtfs::VehicleReport report{.vehicle = vehicle_, .timestamp = posix(now_)};
    if (has_trip()) report.trip = trip();
    if (position) {
      report.latitude = position->value.latitude;
      report.longitude = position->value.longitude;
      report.odometer_m = heard_.odometer(now_);
      report.speed_m_s = heard_.speed(now_);
      report.timestamp = posix(position->heard);
    }
    if (stop_ && has_trip()) {
      report.stop_sequence = journey_->passings[stop_->value.place].sequence;
      report.stop = stop_id(stop_->value.place);
      report.status =
          stands_at_stop(position) ? gtfs::StopStatus::stopped_at : gtfs::StopStatus::in_transit_to;
      if (!position) report.timestamp = posix(stop_->heard);
    }
    if (const std::optional<unsigned> aboard = heard_.aboard(now_)) {
      const unsigned capacity = bus_line::capacity_of(network_.options());
      report.occupancy_percent = *aboard * full_percent / capacity;
      report.occupancy = occupancy(*report.occupancy_percent);
    }
    return report;
  }

  /// True if the doors are open, or it stands at the position of the stop.
  bool stands_at_stop(const Position& position) const {
    constexpr double at_stop_m = 25;
    if (heard_.has_open_door(now_).value_or(false)) return true;
    const std::optional<double> speed = heard_.speed(now_);
    if (!speed || *speed > 0 || !position) return false;
    const bus_line::BusStop& stop = network_.line().stop(journey_->route, stop_->value.place);
    return bus_line::metres_between(position->value, stop.place) <= at_stop_m;
  }

  bus_line::BusNetwork& network_;
  const bus_line::HeardBus& heard_;
  Time now_;
  std::int64_t utc_;
  const bus_line::Journey* journey_;
  std::optional<bus_line::HeardBus::Aged<bus_line::HeardBus::Stop>> stop_;
  gtfs::VehicleReference vehicle_;
};

}  // namespace

gtfs::RealtimeFeed realtime_of(bus_line::BusNetwork& network) {
  return FeedMaker(network).feed();
}

namespace {

class RealtimeFile : public RealtimeOutlet {
 public:
  explicit RealtimeFile(std::string path) : path_(std::move(path)) {}

  void tell(bus_line::BusNetwork& network) override {
    const std::string feed = gtfs::realtime_bytes(realtime_of(network));
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(feed.data());
    host::Result<host::AtomicFile> draft = host::AtomicFile::begin(path_);
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
  explicit RealtimeServer(std::unique_ptr<web::DocumentServer> server)
      : server_(std::move(server)) {}

  void tell(bus_line::BusNetwork& network) override {
    server_->publish(gtfs::realtime_bytes(realtime_of(network)));
  }

 private:
  std::unique_ptr<web::DocumentServer> server_;
};

/// Addresses to listen on, in order of preference; none: `where` is a file.
std::vector<std::string> addresses_of(const std::string& where) {
  if (!where.starts_with(':')) {
    return gateway::parse_tcp_address(where) ? std::vector{where} : std::vector<std::string>{};
  }
  // The first one accepts IPv4 as well, if the machine has both.
  std::vector<std::string> all = {"[::]" + where, "0.0.0.0" + where};
  if (!gateway::parse_tcp_address(all.back())) {
    throw UsageError(fmt::format(
        "--gtfs-rt: '{}' is no port; write :8080, or ./{} for a file of this name", where, where));
  }
  return all;
}

}  // namespace

std::unique_ptr<RealtimeOutlet> open_realtime(const std::string& where,
                                              bus_line::BusNetwork& network) {
  const std::vector<std::string> addresses = addresses_of(where);
  std::string problem;
  for (const std::string& address : addresses) {
    auto server = web::DocumentServer::create(address, "application/x-protobuf",
                                              gtfs::realtime_bytes(realtime_of(network)));
    if (server) {
      print_message(fmt::format("canvoy: GTFS-Realtime is served at {}", (*server)->url()));
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
