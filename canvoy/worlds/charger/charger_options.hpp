// Options of a network of a battery and its charger: a plain struct.
//
//     ChargerOptions options;
//     options.faults.faults = {{FaultKind::heartbeat_loss, Time(20min)}};
//     ChargerNetwork network(options);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/wall_clock.hpp"
#include "canvoy/worlds/charger/fault.hpp"

namespace canvoy::charger {

struct ChargerOptions {
  FaultPlan faults{};                ///< faults, and the seed of all chance
  std::uint32_t bit_rate = 125'000;  ///< in bit/s
  NodeId charger_id = 5;             ///< of the charger, 1 to 127
  NodeId battery_id = 10;            ///< of the battery module, 1 to 127
  /// Node-ID of the vehicle's CANopen manager, which gives the charger its connection to the
  /// battery; 0: there is none, and the charger takes the default channel (CiA 419, 6.1).
  NodeId manager_id = 0;
  /// Time of the charger's clock at the start, so that it sends the time; empty: it has no clock
  /// (CiA 419, 4.1).
  std::optional<CivilTime> begin{};
  BatteryDesign battery = BatteryPlant::lead_acid_48v();  ///< cells, capacity and limits
  double state_of_charge = 0.2;                           ///< at the start, 0 to 1
  double ambience_celsius = 20;                           ///< around the battery
  PowerStageOptions stage{};                              ///< limits of the charger's power stage
  double meter_tolerance = 0.003;     ///< greatest error of the charger's meter, drawn by the seed
  cia419::ChargerSettings charger{};  ///< curve and times of the charger
  /// False: it has no power here, so that a real one may be on a bus that is bridged to this one.
  bool plays_charger = true;
  bool plays_battery = true;  ///< likewise
};

}  // namespace canvoy::charger
