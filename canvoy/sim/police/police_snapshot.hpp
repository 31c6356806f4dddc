// What can be seen of a police car at one instant: its bus and devices, what the crew does and
// wishes, and what is really seen, heard and read.
//
//     const PoliceSnapshot look = network.snapshot();
//     if (look.is_blue) ...
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/sim/police/client.hpp"
#include "canvoy/sim/police/crew.hpp"
#include "canvoy/sim/police/signal_devices.hpp"
#include "canvoy/sim/police/surroundings.hpp"
#include "canvoy/sim/snapshot.hpp"

namespace canvoy::police {

struct PoliceStatistics {
  std::size_t calls = 0;
  std::size_t attended = 0;  ///< and reported
  Duration response_time{};  ///< from a call to the arrival: of all that were attended to, together
  unsigned keys = 0;         ///< pressed at the terminal
  unsigned statuses = 0;     ///< status messages that the control room got
  Duration longest_wait{};   ///< of somebody at the terminal, excused or not
};

/// A look at everything.
struct PoliceSnapshot {
  Time at{};
  BusSnapshot bus;
  std::vector<NodeSnapshot> nodes;
  std::vector<std::string_view> names;  ///< of the nodes

  Activity crew = Activity::off_duty;
  Wish wish;
  bool is_asleep = false;
  PoliceStatistics statistics;

  // The truth
  Surroundings around;
  std::array<bool, beacon_count> beacons{};  ///< that give light at this instant
  std::array<bool, flasher_count> flashers{};
  bool is_blue = false;            ///< flashes
  std::optional<Client> client{};  ///< who is read on display 1
  bool crew_speaks = false;
  bool crew_is_heard = false;
  bool room_speaks = false;
  bool room_is_heard = false;
  double metres = 0;
  double speed = 0;  ///< m/s
};

}  // namespace canvoy::police
