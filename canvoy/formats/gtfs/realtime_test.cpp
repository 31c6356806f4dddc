#include "canvoy/formats/gtfs/realtime.hpp"

#include <gtest/gtest.h>

// Another program reads the whole message in tests/strangers/gtfs. This test has bytes, assembled
// by hand from the numbers of gtfs-realtime.proto and the encoding of Protocol Buffers.
namespace canvoy::gtfs::realtime_test {
namespace {

using namespace std::chrono_literals;
using namespace std::string_literals;

const std::string header =
    "\x0A\x0B"  // header, 11 bytes
    "\x0A\x03"
    "2.0"                 // gtfs_realtime_version
    "\x10\x00"            // incrementality: FULL_DATASET
    "\x18\x80\xA3\x05"s;  // timestamp 86400, in groups of seven bits: 5, 35, 0

TEST(Realtime, AFeedWithoutVehiclesIsItsHeader) {
  const std::string bytes = realtime_bytes({.timestamp = 86'400});
  EXPECT_EQ(bytes, header);
}

TEST(Realtime, AVehicleIsWhereItIs) {
  const std::string bytes = realtime_bytes({.timestamp = 86'400,
                                            .vehicles = {{.vehicle = {.id = "7"},
                                                          .latitude = 0.5,
                                                          .longitude = -2,
                                                          .status = StopStatus::stopped_at,
                                                          .occupancy = Occupancy::empty}}});
  EXPECT_EQ(bytes, header +
                       "\x12\x22"  // entity: 11 + 23
                       "\x0A\x09"
                       "vehicle-7"             // id
                       "\x22\x15"              // vehicle: 12 + 2 + 5 + 2
                       "\x12\x0A"              // position
                       "\x0D\x00\x00\x00\x3F"  // latitude 0.5
                       "\x15\x00\x00\x00\xC0"  // longitude -2
                       "\x20\x01"              // current_status: STOPPED_AT
                       "\x42\x03\x0A\x01"
                       "7"            // vehicle, id
                       "\x48\x00"s);  // occupancy_status: EMPTY
}

TEST(Realtime, AnEarlyTripHasANegativeDelayOfTenBytes) {
  const std::string bytes =
      realtime_bytes({.timestamp = 86'400,
                      .trips = {{.trip = {.trip = "t", .start_time = 25h + 5min},
                                 .vehicle = {.id = "7"},
                                 .stops = {{.sequence = 3, .arrival_delay_s = -1}}}}});
  EXPECT_EQ(bytes, header +
                       "\x12\x38"  // entity: 17 + 39
                       "\x0A\x0F"
                       "trip-t-25:05:00"
                       "\x1A\x25"  // trip_update: 15 + 17 + 5
                       "\x0A\x0D"  // trip
                       "\x0A\x01"
                       "t"
                       "\x12\x08"
                       "25:05:00"
                       "\x12\x0F"                                              // stop_time_update
                       "\x08\x03"                                              // stop_sequence
                       "\x12\x0B\x08\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x01"  // arrival, delay
                       "\x1A\x03\x0A\x01"
                       "7"s);  // vehicle
}

}  // namespace
}  // namespace canvoy::gtfs::realtime_test
