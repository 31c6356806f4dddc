// The encoders of a car position unit. The maker of an encoder implements it, or a plant in a
// simulation.
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia417 {

/// As measured, positive upwards, from the encoder's own zero.
struct PositionReadings {
  double position_millimetre = 0;                         ///< of the car
  double velocity_millimetre_per_second = 0;              ///< of the car
  double acceleration_millimetre_per_second_squared = 0;  ///< of the car
  /// Bits of CiA 406, 6503h: bit 0 position error, bit 1 commissioning diagnostics, which is
  /// reported while bit 1 of 6380h requests it.
  std::uint16_t alarms = 0;
  std::uint16_t warnings = 0;  ///< bits of CiA 406, 6505h
};

struct CarPositionHardware {
  /// Reads position unit 1 to 4.
  Callback<PositionReadings(unsigned unit)> sense;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(CarPositionHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::sense; }, "CarPositionHardware needs a member function sense");
  hardware.sense = callback<&Plain::sense>(plain);
}

}  // namespace canvoy::cia417
