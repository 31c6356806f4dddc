// The wiring of the input and output module of an excavator, and its scale in digits: common to the
// module's plant and to the host that reads it.
#pragma once

#include <cstdint>

namespace canvoy::excavator {

/// Digital outputs, bits of 6200h:01h.
enum class Switched : std::uint8_t { horn, light, beacon, fast_travel, pilot_pressure };
/// Mask of an output in 6200h:01h.
constexpr unsigned bit_of(Switched output) {
  return 1U << static_cast<unsigned>(output);
}

/// Analogue outputs 1 to 7 are the valves, in the order of Movement.
inline constexpr unsigned throttle_output = 8;
inline constexpr double valve_digits = 32'000;  ///< digits of a valve that is wholly open

/// Analogue inputs, 6401h: sub-indices.
enum class Sensor : std::uint8_t { boom = 1, stick, bucket, slew, fuel, oil, rpm, pressure };
/// Number of analogue inputs.
inline constexpr unsigned sensors = static_cast<unsigned>(Sensor::pressure);
/// Digits for a unit of the sensor: degrees, percent, rpm, degrees Celsius, bar.
constexpr double digits_of(Sensor sensor) {
  switch (sensor) {
    case Sensor::boom:
    case Sensor::stick:
    case Sensor::bucket:
    case Sensor::slew:
    case Sensor::fuel:
      return 100;  // of a degree, of a percent
    case Sensor::rpm:
      return 1;
    case Sensor::oil:
    case Sensor::pressure:
      return 10;
  }
  return 1;
}

inline constexpr double low_fuel_percent = 15;  ///< below it, the lamp low_fuel is lit

}  // namespace canvoy::excavator
