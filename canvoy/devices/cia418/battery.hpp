// A CiA 418 battery module: reports its measurements to a charger, and whether it may be charged.
//
//     Battery battery(node, tpdos, hardware, {.capacity_ampere_hours = 400});
//     node.start(now);
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia418 {

/// Settings of a battery module; the defaults are a traction battery of 48 V.
struct BatterySettings {
  std::uint8_t type = 0;               ///< a code of CiA 418; the list is not public
  double capacity_ampere_hours = 400;  ///< 6020h:02h
  double current_max_ampere = 60;      ///< 6020h:03h
  std::uint16_t cells = 24;            ///< in series, 6020h:04h
  Duration sensing_period = 100ms;     ///< of the hardware
  /// False: TPDO 3 is invalid, so that the charger goes by a curve of its own (CiA 419, 6.2.7).
  bool requests_current = true;
};

class Battery {
 public:
  /// All arguments must outlive the battery. `hardware` is read every sensing_period.
  Battery(Node& node, const BatteryHardware& hardware, const BatterySettings& settings);

  /// True if the charger has reported that it is ready to deliver.
  bool charger_ready() const { return charger_status_.is(Readiness::ready); }
  /// What the hardware reported last.
  const BatteryReadings& readings() const { return readings_; }

 private:
  void reset(ResetScope scope);
  void withdraw_request();
  void sense(Time now);

  Node& node_;
  BatteryHardware hardware_;
  BatterySettings settings_;
  BatteryReadings readings_;
  Bound<status> status_;
  Bound<charger_status> charger_status_;
  Bound<temperature> temperature_;
  Bound<voltage> voltage_;
  Bound<charge_current_requested> requested_;
  Bound<battery_state_of_charge> state_of_charge_;
  Bound<ah_expended_since_last_charge> expended_;
  Bound<cumulative_total_ah_charge> total_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia418
