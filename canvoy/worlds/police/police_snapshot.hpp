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

struct PoliceStatistics {
  std::size_t calls = 0;
  std::size_t attended = 0;  ///< and reported
  Duration response_time{};  ///< sum of the times from a call to the arrival, over all attended
                             ///< calls
  unsigned keys = 0;         ///< keys pressed at the terminal
  unsigned statuses = 0;     ///< status messages that the control room received
  Duration longest_wait{};   ///< of a person at the terminal, excused or not
};

/// State of everything.
struct PoliceSnapshot {
  Time at{};  ///< since the start of the run
  BusSnapshot bus;
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  Activity crew = Activity::off_duty;
  Wish wish;
  bool is_asleep = false;
  PoliceStatistics statistics;

  // true state
  Surroundings around;
  std::array<bool, beacon_count> beacons{};  ///< that give light at this instant
  std::array<bool, flasher_count> flashers{};
  bool is_blue = false;            ///< true while it flashes
  bool has_work_light = false;     ///< search lamp and alley lights
  std::optional<Client> client{};  ///< client on display 1
  bool crew_speaks = false;
  bool crew_is_heard = false;
  bool room_speaks = false;
  bool room_is_heard = false;
  double metres = 0;
  double speed = 0;  ///< m/s
};

}  // namespace canvoy::police
