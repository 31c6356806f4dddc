// What is chosen for a patrol of a police car: the plan of faults and the seed, how long it lasts,
// who is not played here; and the node-IDs of its devices.
//
//     PoliceOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/sim/police/fault.hpp"

namespace canvoy::police {

inline constexpr NodeId roof_light_id = 3;
inline constexpr NodeId roof_sound_id = 4;
inline constexpr NodeId blue_light_id = 5;
inline constexpr NodeId radio_id = 6;
inline constexpr NodeId audio_switch_id = 7;
inline constexpr NodeId hands_free_id = 8;
inline constexpr NodeId power_supply_id = 9;
inline constexpr NodeId inputs_id = 10;
inline constexpr NodeId navigation_id = 11;
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 11> device_names = {
    "ivn-gateway",  "terminal",   "roof-bar-light", "roof-bar-sound",  "blue-light",    "radio",
    "audio-switch", "hands-free", "power-supply",   "discrete-inputs", "gps-navigation"};

/// What no fault of a plan does, so that each referee has something to see. What is a setting of a
/// client has to be chosen before the network is made.
struct Sabotage {
  bool greedy_navigation = false;  ///< it takes keys that are another client's
  bool hogging_signals = false;    ///< they do not give the number pad back
  bool cuts_flashers = false;      ///< the wires to the blue flashers
  bool cuts_siren = false;         ///< the wire to the loudspeaker
  bool slow_handset = false;       ///< its contact closes four seconds late
  bool sticking_relay = false;     ///< of the transmitter: it goes on
  bool cuts_display = false;       ///< the wires to display 2
  bool cuts_locks = false;         ///< the wires to the motors of the locks
  bool welded_supply = false;      ///< the relay of the radio's power never opens
  bool speaks_asleep = false;      ///< somebody sends a frame while all sleep
  bool sleepy_crew = false;        ///< which does not answer calls
};

struct PoliceOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  Duration length = 8h;  ///< of the whole run
  cia447::PowerSupplySettings supply{};
  std::vector<NodeId> real{};  ///< who is not played here
  Sabotage sabotage{};
};

}  // namespace canvoy::police
