// The feed of a simulated bus equals what is heard on it, and is valid by the rules of the
// GTFS-Realtime validator of MobilityData: the rules that are checked here have their numbers. Time
// 0 is 4:55, the first journey begins at 5:00.
#include "canvoy/tools/play/bus_realtime.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace canvoy::tools::bus_realtime_test {
namespace {

using gtfs::RealtimeFeed;

/// Numbers of the rules that a feed violates.
class Rules {
 public:
  explicit Rules(bus_line::BusNetwork& network) : network_(network) {}

  std::string broken_by(const RealtimeFeed& feed) {
    broken_.clear();
    check_times(feed);
    for (const gtfs::TripReport& trip : feed.trips) check_trip(trip, feed);
    for (const gtfs::VehicleReport& vehicle : feed.vehicles) check_vehicle(vehicle, feed);
    const bool has_both = !feed.trips.empty() && !feed.vehicles.empty();
    rule("W003", !has_both || feed.trips[0].vehicle.id == feed.vehicles[0].vehicle.id);
    last_ = std::max(last_, feed.timestamp);
    return broken_;
  }

 private:
  void rule(const char* number, bool holds) {
    if (!holds) broken_ += std::string(number) + " ";
  }

  void check_times(const RealtimeFeed& feed) {
    rule("E048", feed.timestamp != 0);      // timestamp of the header
    rule("E018", feed.timestamp >= last_);  // it does not decrease
    rule("E001", feed.timestamp > 1'000'000'000 && feed.timestamp < 10'000'000'000);  // POSIX time
    rule("W008", network_.snapshot().utc - std::int64_t(feed.timestamp) <= 65);       // its age
    rule("E050", std::int64_t(feed.timestamp) <= network_.snapshot().utc);  // not in the future
  }

  const bus_line::Journey* journey_of(const std::string& trip) const {
    for (const bus_line::Journey& journey : network_.line().blocks[0].journeys) {
      if (journey.trip == trip) return &journey;
    }
    return nullptr;
  }

  const bus_line::Journey* check_reference(const gtfs::TripReference& trip) {
    const bus_line::Journey* const journey = journey_of(trip.trip);
    rule("E003", journey != nullptr);                                 // trip_id of the timetable
    rule("E004", trip.route == network_.line().id);                   // route_id of the timetable
    rule("E021", trip.start_date && trip.start_date->ok());           // start_date
    rule("E020", !trip.start_time || trip.start_time->count() >= 0);  // start_time
    if (journey == nullptr) return nullptr;
    const auto first = std::chrono::floor<std::chrono::seconds>(journey->passings[0].arrival);
    rule("E023", !trip.start_time || *trip.start_time == first);  // start_time of the timetable
    const bool is_backward = network_.line().routes[journey->route].is_backward;
    rule("E024", !trip.direction || (*trip.direction == 1) == is_backward);  // direction_id
    return journey;
  }

  const std::string& stop_id(const bus_line::Journey& journey, std::size_t place) const {
    return network_.line().stop(journey.route, place).id;
  }

  void check_trip(const gtfs::TripReport& trip, const RealtimeFeed& feed) {
    rule("E012", trip.timestamp <= feed.timestamp);  // the timestamp of the header is the last one
    rule("W001", trip.timestamp != 0);
    rule("W002", !trip.vehicle.id.empty());
    rule("E041", !trip.stops.empty());  // a trip has updates of stops
    const bus_line::Journey* const journey = check_reference(trip.trip);
    if (journey == nullptr) return;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < trip.stops.size(); ++i) {
      const gtfs::StopReport& stop = trip.stops[i];
      if (i > 0) check_order(trip.stops[i - 1], stop);
      check_stop(stop, *journey, before);
    }
  }

  void check_order(const gtfs::StopReport& before, const gtfs::StopReport& stop) {
    rule("E002", before.sequence < stop.sequence);   // sorted
    rule("E036", before.sequence != stop.sequence);  // no stop_sequence twice
    rule("E037", before.stop != stop.stop);          // no consecutive equal stop_id
  }

  void check_stop(const gtfs::StopReport& stop, const bus_line::Journey& journey,
                  std::int64_t& before) {
    const auto passing =
        std::ranges::find(journey.passings, stop.sequence, &bus_line::Passing::sequence);
    rule("E051", passing != journey.passings.end());  // stop_sequence of the timetable
    if (passing == journey.passings.end()) return;
    const auto place = static_cast<std::size_t>(passing - journey.passings.begin());
    rule("E045", stop.stop == stop_id(journey, place));        // stop_id of the stop_sequence
    rule("E040", !stop.stop.empty());                          // a stop
    rule("E043", stop.arrival_time || stop.departure_time);    // an event
    rule("E044", (!stop.arrival_time || stop.arrival_delay_s)  // a delay or a time
                     && (!stop.departure_time || stop.departure_delay_s));
    const std::int64_t first = stop.arrival_time.value_or(stop.departure_time.value_or(0));
    rule("E022", first > before);  // times increase from stop to stop
    before = stop.departure_time.value_or(first);
    rule("E025", before >= first);  // no departure before the arrival
    rule("E001", first > 1'000'000'000 && first < 10'000'000'000);
    // A rule of this project: a vehicle at a timing point leaves at its time or later.
    const bool leaves_early = stop.departure_delay_s.value_or(0) < 0;
    rule("timing-point", !passing->is_timing_point || !leaves_early);
    check_delays(stop, *passing);
  }

  /// A delay is the difference to the timetable: 4:55 is time 0 of the run.
  void check_delays(const gtfs::StopReport& stop, const bus_line::Passing& passing) {
    const std::int64_t midnight =
        network_.snapshot().utc -
        std::chrono::floor<std::chrono::seconds>(4h + 55min + (network_.now() - Time{})).count();
    const auto agrees = [midnight](std::optional<std::int64_t> time,
                                   std::optional<std::int32_t> delay, Duration planned) {
      const auto at = std::chrono::floor<std::chrono::seconds>(planned).count();
      return !time || !delay || *time - *delay == midnight + at;
    };
    rule("delay", agrees(stop.arrival_time, stop.arrival_delay_s, passing.arrival) &&
                      agrees(stop.departure_time, stop.departure_delay_s, passing.departure));
  }

  void check_vehicle(const gtfs::VehicleReport& vehicle, const RealtimeFeed& feed) {
    rule("E012", vehicle.timestamp <= feed.timestamp);
    rule("W001", vehicle.timestamp != 0);
    rule("W002", !vehicle.vehicle.id.empty());
    rule("E052", feed.vehicles.size() == 1);  // unique vehicle id
    rule("E027", !vehicle.bearing || (*vehicle.bearing >= 0 && *vehicle.bearing <= 360));
    rule("W004", !vehicle.speed_m_s || (*vehicle.speed_m_s >= 0 && *vehicle.speed_m_s <= 26));
    if (vehicle.latitude) {
      rule("E026", std::abs(*vehicle.latitude) <= 90 && std::abs(*vehicle.longitude) <= 180);
      const bus_line::GeoPoint at{*vehicle.latitude, *vehicle.longitude};
      // E029: at most 200 m from its route; here it is that close to the true position.
      rule("E029", bus_line::metres_between(at, network_.vehicle().position()) < 200);
    }
    if (!vehicle.trip) return;
    const bus_line::Journey* const journey = check_reference(*vehicle.trip);
    const bool has_same = feed.trips.empty() || feed.trips[0].trip.trip == vehicle.trip->trip;
    rule("E047", has_same);  // one vehicle, one trip
    if (journey == nullptr || !vehicle.stop_sequence) return;
    const auto passing =
        std::ranges::find(journey->passings, *vehicle.stop_sequence, &bus_line::Passing::sequence);
    rule("E051", passing != journey->passings.end());
    if (passing == journey->passings.end()) return;
    const auto place = static_cast<std::size_t>(passing - journey->passings.begin());
    rule("E011", vehicle.stop == stop_id(*journey, place));  // stop_id of the timetable
  }

  bus_line::BusNetwork& network_;
  std::uint64_t last_ = 0;
  std::string broken_;
};

bus_line::BusNetworkOptions with_faults(std::vector<NodeId> lost, Duration from, Duration length) {
  bus_line::BusNetworkOptions options;
  options.faults.seed = 1;
  for (const NodeId node : lost) {
    options.faults.faults.push_back({.kind = bus_line::FaultKind::lost_node,
                                     .start = Time(from),
                                     .duration = length,
                                     .node = node});
  }
  return options;
}

TEST(BusRealtime, IsValidAllTheWay) {
  bus_line::BusNetwork network(with_faults({}, {}, {}));
  Rules rules(network);
  unsigned trips = 0;
  unsigned positions = 0;
  for (Time at(15s); at <= Time(43min); at += 15s) {
    network.run_until(at);
    const RealtimeFeed feed = realtime_of(network);
    EXPECT_EQ(rules.broken_by(feed), "") << (at - Time{}) / 1s << " s";
    trips += feed.trips.empty() ? 0U : 1U;
    positions += !feed.vehicles.empty() && feed.vehicles[0].latitude ? 1U : 0U;
  }
  // 172 messages; between two journeys the stop is unknown for a moment.
  EXPECT_GE(trips, 165u);
  EXPECT_GE(positions, 170u);
}

TEST(BusRealtime, SaysNothingThatNobodyHasHeard) {
  const std::vector<NodeId> dead = {bus_line::computer_id, bus_line::positioning_id,
                                    bus_line::counting_manager_id};
  bus_line::BusNetwork network(with_faults(dead, 10min, 150s));
  Rules rules(network);
  network.run_until(Time(10min));
  RealtimeFeed feed = realtime_of(network);
  EXPECT_EQ(feed.trips.size(), 1u);
  EXPECT_TRUE(feed.vehicles.at(0).latitude && feed.vehicles.at(0).occupancy);
  // A heartbeat of the failed devices may be 1 s old at that time, and is valid for 2.5 s.
  for (Time at(10min + 4s); at <= Time(12min + 29s); at += 5s) {
    network.run_until(at);
    feed = realtime_of(network);
    EXPECT_TRUE(feed.trips.empty()) << (at - Time{}) / 1s << " s";
    EXPECT_TRUE(feed.vehicles.empty()) << (at - Time{}) / 1s << " s";
    EXPECT_EQ(rules.broken_by(feed), "");
  }
  network.run_until(Time(14min));
  feed = realtime_of(network);
  EXPECT_EQ(feed.trips.size(), 1u);
  ASSERT_EQ(feed.vehicles.size(), 1u);
  EXPECT_TRUE(feed.vehicles[0].latitude);
}

TEST(BusRealtime, WithoutSatellitesThereIsNoPosition) {
  bus_line::BusNetworkOptions options = with_faults({}, {}, {});
  options.faults.faults = {
      {.kind = bus_line::FaultKind::no_satellites, .start = Time(10min), .duration = 60s}};
  bus_line::BusNetwork network(options);
  network.run_until(Time(10min + 30s));
  const RealtimeFeed feed = realtime_of(network);
  ASSERT_EQ(feed.vehicles.size(), 1u);
  EXPECT_FALSE(feed.vehicles[0].latitude || feed.vehicles[0].longitude);
  EXPECT_FALSE(feed.vehicles[0].stop.empty()) << "the on-board computer counts pulses";
  network.run_until(Time(11min + 5s));
  EXPECT_TRUE(realtime_of(network).vehicles.at(0).latitude);
}

TEST(BusRealtime, WithoutACounterNobodyKnowsHowFullItIs) {
  bus_line::BusNetwork network(with_faults({bus_line::counting_manager_id}, 10min, 60s));
  network.run_until(Time(10min + 30s));
  const RealtimeFeed feed = realtime_of(network);
  ASSERT_EQ(feed.vehicles.size(), 1u);
  EXPECT_FALSE(feed.vehicles[0].occupancy || feed.vehicles[0].occupancy_percent);
}

TEST(BusRealtime, ForecastsTheStopsThatAreBeforeIt) {
  bus_line::BusNetwork network(with_faults({}, {}, {}));
  network.run_until(Time(3min));  // at the first stop until 5:00
  const RealtimeFeed feed = realtime_of(network);
  const gtfs::TripReport& trip = feed.trips.at(0);
  ASSERT_EQ(trip.stops.size(), 8u);
  EXPECT_FALSE(trip.stops[0].arrival_time);
  // 2026-11-23 5:00 at UTC + 1 h.
  EXPECT_EQ(trip.stops[0].departure_time, 1'795'406'400);
  EXPECT_EQ(trip.stops[0].departure_delay_s, 0);
  EXPECT_FALSE(trip.stops[7].departure_time);
  EXPECT_EQ(trip.stops[7].arrival_delay_s, 0);
  EXPECT_EQ(feed.vehicles.at(0).status, gtfs::StopStatus::stopped_at);
}

}  // namespace
}  // namespace canvoy::tools::bus_realtime_test
