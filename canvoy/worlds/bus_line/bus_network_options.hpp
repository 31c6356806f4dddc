// Options for a day of a bus: the plan of faults and the seed, its line and block, the day, and the
// devices that are not simulated here.
//
//     BusNetworkOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 1}};
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/bus_line/bus_design.hpp"
#include "canvoy/worlds/bus_line/bus_fault.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/local_clock.hpp"

namespace canvoy::bus_line {

/// Failures beyond those of the plan, so that each referee has something to detect.
struct Sabotage {
  bool cuts_next_stop = false;       ///< the wires to its lamps
  bool cuts_destination = false;     ///< of the front display
  bool cuts_information = false;     ///< of the information display
  bool freezes_destination = false;  ///< the side display keeps showing its first text
  bool short_memory = false;         ///< the information display keeps 40 octets
  bool no_sign_lamp = false;         ///< of the next stop indicator
  bool mute_announcer = false;       ///< the wire to the loudspeakers
  bool stuck_zone_wheel = false;     ///< of the canceller's stamp
  bool blind_counter = false;        ///< of the first door
  bool false_messages = false;       ///< a foreign device sends the driver's message
  bool slow_clocks = false;          ///< satellites and own clock are ten minutes late
  bool jammed_canceller = false;     ///< its slot takes no tickets
  // Each in one of the cars 2 to 4; 0: in none.
  unsigned cut_car = 0;          ///< wires of the lamps of its next stop indicator
  unsigned frozen_car = 0;       ///< its next stop indicator keeps showing its first text
  unsigned mute_car = 0;         ///< the wire to its loudspeakers
  unsigned unlit_car = 0;        ///< its next stop indicator has no lamp of the sign
  unsigned dead_button_car = 0;  ///< the wire from its buttons
  bool stuck_sign = false;       ///< of the next stop indicator: it is always lit
  bool hasty_driver = false;     ///< the driver waits for the first departure alone
  bool unkind_driver = false;    ///< the driver opens only for passengers who get out
  bool crowd = false;            ///< people get in beyond the capacity
};

/// A driver who takes over from the beginning of a journey on.
struct DriverChange {
  std::uint32_t journey = 0;  ///< number (6195h) within the block
  std::uint32_t driver = 0;   ///< number (6190h)
};

struct BusNetworkOptions {
  FaultPlan faults{};                ///< faults, and the seed of all chance
  std::uint32_t bit_rate = 125'000;  ///< of all cables, in bit/s
  Duration length{};  ///< of the whole run; 0: until ten minutes after the end of the block
  BusLine line = built_in_line();  ///< timetable; the built-in one without a feed
  std::size_t block = 0;           ///< of the line; it has a journey
  std::chrono::year_month_day date{std::chrono::year(2026), std::chrono::month(11),
                                   std::chrono::day(23)};  ///< of the day of service
  LocalClock clock{{OffsetChange{.offset = 3600}}};        ///< of the line: UTC + 1 h
  BusOptions vehicle{};  ///< its seed is that of the faults; each third person rides behind
  BusDesign design{};    ///< of the vehicle and its network
  std::vector<DriverChange> drivers{};  ///< those after the first one
  std::vector<DeviceKey> real{};        ///< devices that are not simulated here
  Sabotage sabotage{};                  ///< none by default
};

/// Number of people that the bus has room for.
unsigned capacity_of(const BusNetworkOptions& options);
/// End of a run.
Time end_of(const BusNetworkOptions& options);
/// Options of the vehicle: the seed of the faults, riders in the cars behind, and doors and
/// capacity of the design.
BusOptions vehicle_options(const BusNetworkOptions& options);

}  // namespace canvoy::bus_line
