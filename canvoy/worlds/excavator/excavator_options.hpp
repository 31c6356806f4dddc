// Options of a shift of an excavator: which devices stand where, how long it lasts, what fails; a
// plain struct.
//
//     ExcavatorOptions options;
//     options.faults.faults = {{.kind = FaultKind::stuck_axis, .start = Time(20min)}};
//     ExcavatorNetwork network(options);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/worlds/excavator/armrest_watch.hpp"
#include "canvoy/worlds/excavator/excavator_fault.hpp"
#include "canvoy/worlds/excavator/excavator_operator.hpp"
#include "canvoy/worlds/excavator/host_objects.hpp"

namespace canvoy::excavator {

/// A device on the bus of the machine.
struct DevicePlace {
  NodeId id = 0;          ///< 1 to 127
  std::string_view name;  ///< in files and logs
};
/// In the order of their node-IDs, and along the cable.
inline constexpr std::array<DevicePlace, 3> device_places = {
    {{host_id, "host"}, {seat_id, "seat"}, {valves_id, "valves"}}};
/// On the bus behind the seat.
inline constexpr DevicePlace armrest_place = {armrest_id, "armrest"};

/// Failures beyond those of the plan, so that each referee has something to detect.
struct Sabotage {
  bool trusting_host = false;    ///< the host trusts a sensor without its contact
  bool single_channel = false;   ///< the seat trusts the first sensor of each axis
  bool patient_host = false;     ///< the host waits for the seat for three seconds
  bool patient_valves = false;   ///< the valves wait for the host for three seconds
  bool old_lever = false;        ///< the host uses the last state of the armrest for ever
  bool slow_buttons = false;     ///< the seat filters the buttons for 40 ms
  bool counts_levels = false;    ///< each PDO with a button down counts as a press
  bool coarse_deltas = false;    ///< the host has axes sent at changes of a fifth of their travel
  bool burnt_lamp = false;       ///< of the work light
  bool keeps_lamps = false;      ///< the lamps have no error values
  bool frozen_display = false;   ///< of the first parameter
  bool pierced_bucket = false;   ///< no earth stays in it
  bool obeys_all_seats = false;  ///< the host obeys sticks of a seat without the command
  bool forgetful_host = false;   ///< the host does not start a node again that has rebooted
};

struct ExcavatorOptions {
  FaultPlan faults{};                ///< faults, and the seed of all chance
  std::uint32_t bit_rate = 250'000;  ///< of both buses, in bit/s
  Duration length = 8h;              ///< of the whole run
  Duration sensing_period{};         ///< of the seat; 0: it receives each movement
  OperatorOptions shift{};           ///< its end is that of the run
  std::vector<NodeId> real{};        ///< devices that are not simulated here
  bool records_shift = false;        ///< see recorded_shift()
  bool has_trainer = false;          ///< a trainer on a second seat, of which one has the command
  bool has_armrest = true;           ///< false: the seat has no armrest, and the host expects none
  Sabotage sabotage{};               ///< none by default

  /// True if that device is simulated here.
  bool plays(NodeId id) const { return std::ranges::find(real, id) == real.end(); }
};

}  // namespace canvoy::excavator
