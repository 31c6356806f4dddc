// What a network of a battery and its charger is made of: a plain struct.
//
//     ChargingOptions options;
//     options.faults.faults = {{FaultKind::heartbeat_loss, Time(20min)}};
//     ChargingNetwork network(options);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/sim/charging/fault.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/sim/wall_clock.hpp"

namespace canvoy::charging {

struct ChargingOptions {
  FaultPlan faults{};  ///< and the seed
  std::uint32_t bit_rate = 125'000;
  NodeId charger_id = 5;
  NodeId battery_id = 10;
  /// Of the vehicle's CANopen manager, which gives the charger its connection to the battery (CiA
  /// 419, 6.1); 0: there is none, and the charger takes the default channel.
  NodeId manager_id = 0;
  /// What the charger's clock shows at the start, so that it tells the time (4.1); nothing: it has
  /// no clock.
  std::optional<CivilTime> begin{};
  BatteryDesign battery = BatteryPlant::lead_acid_48v();
  double state_of_charge = 0.2;  ///< at the start, 0 to 1
  double ambience_celsius = 20;
  PowerStageOptions stage{};
  double meter_tolerance = 0.003;  ///< by as much the seed may make the charger's meter be off
  cia419::ChargerSettings charger{};
  /// False: it has no power here, and a real one may be on a bus that is bridged to this one.
  bool plays_charger = true;
  bool plays_battery = true;
};

}  // namespace canvoy::charging
