// State of a police car at one instant: its bus and devices, what the crew does and wants, and what
// is really seen, heard and read.
//
//     const PoliceSnapshot look = network.snapshot();
//     if (look.is_blue) ...
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/police/client.hpp"
#include "canvoy/worlds/police/crew.hpp"
#include "canvoy/worlds/police/signal_devices.hpp"
#include "canvoy/worlds/police/surroundings.hpp"

namespace canvoy::police {

/// Counts since the start of a patrol.
struct PoliceStatistics {
  std::size_t calls = 0;     ///< calls for help
  std::size_t attended = 0;  ///< and reported
  Duration response_time{};  ///< sum of the times from a call to the arrival, over all attended
                             ///< calls
  unsigned keys = 0;         ///< keys pressed at the terminal
  unsigned statuses = 0;     ///< status messages that the control room received
  Duration longest_wait{};   ///< of a person at the terminal, excused or not
};

/// State of everything.
struct PoliceSnapshot {
  Time at{};                            ///< since the start of the run
  BusSnapshot bus;                      ///< of the car, with its load since the start
  std::vector<NodeSnapshot> nodes;      ///< in the order of their node-IDs
  std::vector<std::string_view> names;  ///< of the nodes

  Activity crew = Activity::off_duty;  ///< what the crew does
  Wish wish;                           ///< what the crew wants
  bool is_asleep = false;              ///< all devices sleep
  PoliceStatistics statistics;         ///< counts up to now

  // true state
  Surroundings around;                         ///< heard and read
  std::array<bool, beacon_count> beacons{};    ///< that give light at this instant
  std::array<bool, flasher_count> flashers{};  ///< that give light at this instant
  bool is_blue = false;                        ///< true while it flashes
  bool has_work_light = false;                 ///< search lamp and alley lights
  std::optional<Client> client{};              ///< client on display 1
  bool crew_speaks = false;                    ///< a person in the car speaks to the radio
  bool crew_is_heard = false;                  ///< in the control room
  bool room_speaks = false;                    ///< a person in the control room speaks
  bool room_is_heard = false;                  ///< in the car
  double metres = 0;                           ///< m driven since the start
  double speed = 0;                            ///< m/s
};

}  // namespace canvoy::police
