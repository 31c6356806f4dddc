// State of a bus at one instant: its cables and their devices, the displays, the vehicle on its
// route, and its passengers.
//
//     const BusNetworkSnapshot look = network.snapshot();
//     print(look.truth.stop->name, look.delay);
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/headways.hpp"
#include "canvoy/worlds/bus_line/local_clock.hpp"

namespace canvoy::bus_line {

/// Counts since the start of a run.
struct BusNetworkStatistics {
  std::size_t journeys = 0;   ///< journeys begun
  std::size_t stops = 0;      ///< stops at which it stood, or which it passed
  std::size_t announced = 0;  ///< stops announced, in the first car
  std::size_t texts = 0;      ///< texts that appeared on displays
  Duration worst_delay{};     ///< behind the timetable, at a stop
  Headways headways{};        ///< to the vehicle ahead, where people come at random
};

/// State of the whole network.
struct BusNetworkSnapshot {
  Time at{};                            ///< since the start of the run
  std::vector<BusSnapshot> buses{};     ///< of each car; two where there is one car
  std::vector<NodeSnapshot> nodes;      ///< of the devices, real ones too
  std::vector<std::string_view> names;  ///< of the nodes

  /// What a display shows.
  struct Shown {
    NodeId node = 0;           ///< of the display
    std::string text;          ///< UTF-8, a line for each element; empty: dark
    bool is_sign_lit = false;  ///< the lamp "stop requested"
  };
  std::vector<Shown> displays;         ///< for passengers, in all cars
  cia407::CivilTime local_time{};      ///< where the line runs
  EpochSeconds utc = 0;                ///< seconds since 1970-01-01
  BusTruth truth;                      ///< its pointers are valid as long as the network
  BusState state = BusState::at_stop;  ///< what the vehicle does
  GeoPoint position;                   ///< of the vehicle
  double heading = 0;                  ///< degrees clockwise from north
  double speed = 0;                    ///< m/s
  double odometer = 0;                 ///< m since the start
  double metres_on_route = 0;          ///< m from the first stop
  Duration delay{};                 ///< at the last arrival, departure or passing; negative: early
  std::vector<DoorState> doors;     ///< the first door first
  unsigned counted = 0;             ///< people aboard, by the on-board computer
  RiderStatistics riders;           ///< counts of its passengers
  BusNetworkStatistics statistics;  ///< counts of its network

  /// All cars together: the highest load, and all frames.
  BusSnapshot traffic() const {
    BusSnapshot all;
    for (const BusSnapshot& bus : buses) {
      all.load = std::max(all.load, bus.load);
      all.frames += bus.frames;
      all.error_frames += bus.error_frames;
    }
    return all;
  }
};

}  // namespace canvoy::bus_line
