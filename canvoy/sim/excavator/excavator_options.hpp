// What a shift of an excavator is made of: who stands where, how long, what goes wrong; a plain
// struct.
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

#include "canvoy/sim/excavator/armrest_watch.hpp"
#include "canvoy/sim/excavator/excavator_fault.hpp"
#include "canvoy/sim/excavator/excavator_operator.hpp"
#include "canvoy/sim/excavator/host_objects.hpp"

namespace canvoy::excavator {

struct DevicePlace {
  NodeId id = 0;
  std::string_view name;
};
/// In the order of their node-IDs, and along the cable.
inline constexpr std::array<DevicePlace, 3> device_places = {
    {{host_id, "host"}, {seat_id, "seat"}, {valves_id, "valves"}}};
/// On the bus behind the seat.
inline constexpr DevicePlace armrest_place = {armrest_id, "armrest"};

/// What no fault of a plan does, so that each referee has something to see.
struct Sabotage {
  bool trusting_host = false;   ///< it believes a sensor without its contact
  bool patient_host = false;    ///< it waits for the seat for three seconds
  bool patient_valves = false;  ///< they wait for the host so long
  bool old_lever = false;       ///< the host believes what the armrest said last
  bool slow_buttons = false;    ///< the seat filters them for 40 ms
  bool counts_levels = false;   ///< each PDO with a button that is down is a press
  bool coarse_deltas = false;   ///< the host has axes told by a fifth of their way
  bool burnt_lamp = false;      ///< of the work light
  bool keeps_lamps = false;     ///< they have no error values
  bool frozen_display = false;  ///< its first parameter
  bool pierced_bucket = false;  ///< no earth stays in it
  bool forgetful_host = false;  ///< who has booted again is not started again
};

struct ExcavatorOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 250'000;
  Duration length = 8h;        ///< of the whole run
  Duration sensing_period{};   ///< of the seat; 0: it is told of each movement
  OperatorOptions shift{};     ///< its end is that of the run
  std::vector<NodeId> real{};  ///< who is not played here
  bool records_shift = false;  ///< see recorded_shift()
  bool has_armrest = true;     ///< where the seat has none, the host asks for none
  Sabotage sabotage{};

  bool plays(NodeId id) const { return std::ranges::find(real, id) == real.end(); }
};

}  // namespace canvoy::excavator
