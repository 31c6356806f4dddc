// State of a bus at one instant: its two cables and their devices, the displays, the vehicle on its
// route, and its passengers.
//
//     const BusNetworkSnapshot look = network.snapshot();
//     print(look.truth.stop->name, look.delay);
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/local_clock.hpp"

namespace canvoy::bus_line {

struct BusNetworkStatistics {
  std::size_t journeys = 0;  ///< journeys begun
  std::size_t stops = 0;     ///< stops at which it stood, or which it passed
  std::size_t announced = 0;
  std::size_t texts = 0;  ///< texts that appeared on displays
  Duration worst_delay{};
};

/// State of the whole network.
struct BusNetworkSnapshot {
  Time at{};
  std::array<BusSnapshot, 2> buses{};  ///< of each car
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  struct Shown {
    NodeId node = 0;
    std::string text;
    bool is_sign_lit = false;
  };
  std::vector<Shown> displays;
  cia407::CivilTime local_time{};
  EpochSeconds utc = 0;
  BusTruth truth;  ///< its pointers are valid as long as the network
  BusState state = BusState::at_stop;
  GeoPoint position;
  double heading = 0;
  double speed = 0;  ///< m/s
  double odometer = 0;
  double metres_on_route = 0;
  Duration delay{};
  std::vector<DoorState> doors;
  unsigned counted = 0;  ///< people aboard, by the on-board computer
  RiderStatistics riders;
  BusNetworkStatistics statistics;

  /// Both cars together: the higher load, and all frames.
  BusSnapshot traffic() const {
    return {.load = std::max(buses[0].load, buses[1].load),
            .frames = buses[0].frames + buses[1].frames,
            .error_frames = buses[0].error_frames + buses[1].error_frames};
  }
};

}  // namespace canvoy::bus_line
