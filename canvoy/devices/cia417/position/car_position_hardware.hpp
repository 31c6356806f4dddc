// What the encoders of a car position unit sense: the maker of an encoder implements it, or a plant
// in a simulation.
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia417 {

/// As measured, upwards positive, from the encoder's own zero.
struct PositionReadings {
  double position_millimetre = 0;
  double velocity_millimetre_per_second = 0;
  double acceleration_millimetre_per_second_squared = 0;
  /// Bits as CiA 406, 6503h: bit 0 position error, bit 1 commissioning diagnostics, which is told
  /// while bit 1 of 6380h asks for it.
  std::uint16_t alarms = 0;
  std::uint16_t warnings = 0;  ///< bits as CiA 406, 6505h
};

struct CarPositionHardware {
  /// Of position unit 1 to 4.
  Callback<PositionReadings(unsigned unit)> sense;
};

}  // namespace canvoy::cia417
