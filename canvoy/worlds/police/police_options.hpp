// Options for a patrol of a police car: the plan of faults and the seed, its duration, the devices
// that are not simulated here; and the node-IDs of its devices.
//
//     PoliceOptions options;
//     options.faults.faults = {{.kind = FaultKind::restart, .start = Time(20min), .node = 2}};
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/worlds/car/real_identity.hpp"
#include "canvoy/worlds/police/fault.hpp"

namespace canvoy::police {

inline constexpr NodeId roof_light_id = 3;  ///< light of the roof bar
/// Sound of the roof bar, with the control of the signals.
inline constexpr NodeId roof_sound_id = 4;
inline constexpr NodeId blue_light_id = 5;    ///< blue light flashers
inline constexpr NodeId radio_id = 6;         ///< radio
inline constexpr NodeId audio_switch_id = 7;  ///< audio switch
inline constexpr NodeId hands_free_id = 8;    ///< hands-free system
inline constexpr NodeId power_supply_id = 9;  ///< power supply of radio and periphery
inline constexpr NodeId inputs_id = 10;       ///< discrete inputs: handset
inline constexpr NodeId navigation_id = 11;   ///< GPS and navigation
/// In the order of their node-IDs, from 1 on.
inline constexpr std::array<std::string_view, 11> device_names = {
    "ivn-gateway",  "terminal",   "roof-bar-light", "roof-bar-sound",  "blue-light",    "radio",
    "audio-switch", "hands-free", "power-supply",   "discrete-inputs", "gps-navigation"};

inline constexpr NodeId fire_extinguishing_id = 12;  ///< of an armoured car
inline constexpr NodeId fresh_air_id = 13;           ///< likewise
/// Like device_names, plus the devices that only an armoured car has.
inline constexpr auto armoured_names = [] {
  std::array<std::string_view, device_names.size() + 2> names{};
  std::ranges::copy(device_names, names.begin());
  names[fire_extinguishing_id - 1] = "fire-extinguishing";
  names[fresh_air_id - 1] = "emergency-fresh-air";
  return names;
}();

/// Failures beyond those of the plan, so that each referee has something to detect. Those that are
/// settings of a client must be chosen before the network is made.
struct Sabotage {
  bool greedy_navigation = false;   ///< the navigation takes keys of another client
  bool hogging_signals = false;     ///< the signals do not give the number pad back
  bool cuts_flashers = false;       ///< the wires to the blue flashers
  bool cuts_siren = false;          ///< the wire to the loudspeaker
  bool cuts_work_lights = false;    ///< the wires to search lamp and alley lights
  bool cuts_emergency_key = false;  ///< its contact
  bool slow_blue_light = false;     ///< its lamps follow their command a second late
  bool slow_handset = false;        ///< its contact closes four seconds late
  bool sticking_relay = false;      ///< of the transmitter: it goes on
  bool cuts_display = false;        ///< the wires to display 2
  bool cuts_locks = false;          ///< the wires to the motors of the locks
  bool welded_supply = false;       ///< the relay of the radio's power never opens
  bool speaks_asleep = false;       ///< a frame is sent while all devices sleep
  bool sleepy_crew = false;         ///< the crew does not answer calls
};

struct PoliceOptions {
  FaultPlan faults{};                    ///< faults, and the seed of all chance
  std::uint32_t bit_rate = 125'000;      ///< in bit/s
  Duration length = 8h;                  ///< of the whole run
  cia447::PowerSupplySettings supply{};  ///< after-run times of radio and periphery
  /// With fire extinguishing and emergency fresh-air systems (4.2.5, 4.2.6).
  bool is_armoured = false;
  std::vector<NodeId> real{};                   ///< devices that are not simulated here
  std::vector<car::RealIdentity> identities{};  ///< of those among them that have one
  Sabotage sabotage{};                          ///< none by default
};

}  // namespace canvoy::police
