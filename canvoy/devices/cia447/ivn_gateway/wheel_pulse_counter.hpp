// The wheel pulse counter of a car (6055h, 6056h; CiA 447-3, 4.2.4.6 and 4.2.4.7): converts the
// driven distance to pulses, in whole micrometres, so that no pulse is lost or counted twice,
// however often and irregularly it is called.
//
//     WheelPulseCounter counter({.per_rotation = 48, .circumference_m = 2.0});
//     counter.drive(1234.5);  // m in all
//     counter.count();        // 29628
#pragma once

#include <cstdint>
#include <optional>

namespace canvoy::cia447 {

/// Conversion of distance to pulses.
struct WheelPulseSettings {
  unsigned per_rotation = 48;        ///< of a wheel
  double circumference_m = 2.0;      ///< of a wheel
  std::uint16_t count_max = 0xFFFF;  ///< followed by 0
};

class WheelPulseCounter {
 public:
  /// Makes a counter at 0.
  explicit WheelPulseCounter(const WheelPulseSettings& pulses);

  /// Sets the total distance of the car, in m. Counting starts with the first call. A distance
  /// below the last one is another origin: the count stays.
  void drive(double distance_m);
  /// Count at present, as 6055h has it.
  std::uint16_t count() const { return count_; }

 private:
  std::int64_t per_rotation_;
  std::int64_t circumference_um_;
  std::int64_t count_max_;
  std::optional<std::int64_t> last_um_;
  std::int64_t rest_ = 0;  ///< of a pulse, in per_rotation_ths of a micrometre
  std::uint16_t count_ = 0;
};

}  // namespace canvoy::cia447
