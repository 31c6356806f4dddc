// The sensors of a CiA 418 battery module. The maker of a battery implements it, or a plant in a
// simulation.
#pragma once

#include <optional>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia418 {

/// The readings of a battery. Values that cannot be measured are absent, and sent as the profile's
/// invalid value.
struct BatteryReadings {
  std::optional<double> temperature_celsius;  ///< of the pack
  std::optional<double> voltage_volt;         ///< of the pack
  std::optional<double>
      requested_current_ampere;  ///< request of the battery management; 0 when full
  std::optional<double> state_of_charge_percent;  ///< 0 to 100
  double ampere_hours_since_charge = 0;           ///< taken out since the last charge
  double ampere_hours_total = 0;                  ///< taken out since it was made
  bool ready = false;                             ///< to be charged
};

struct BatteryHardware {
  Callback<BatteryReadings()> sense;  ///< called once a period; costs what the sensors cost
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(BatteryHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::sense; }, "BatteryHardware needs a member function sense");
  hardware.sense = callback<&Plain::sense>(plain);
}

}  // namespace canvoy::cia418
