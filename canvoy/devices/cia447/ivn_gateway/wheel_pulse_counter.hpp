// The wheel pulse counter of a car (6055h, 6056h; CiA 447-3, 4.2.4.6 and 4.2.4.7): pulses out of
// the distance that was driven, in whole micrometres, so that none is lost or counted twice however
// often and unevenly it is asked.
//
//     WheelPulseCounter counter({.pulses_per_rotation = 48, .circumference_m = 2.0});
//     counter.drive(1234.5);  // m in all
//     counter.count();        // 29628
#pragma once

#include <cstdint>
#include <optional>

namespace canvoy::cia447 {

struct WheelPulseSettings {
  unsigned per_rotation = 48;
  double circumference_m = 2.0;
  std::uint16_t count_max = 0xFFFF;  ///< 0 comes after it
};

class WheelPulseCounter {
 public:
  explicit WheelPulseCounter(const WheelPulseSettings& pulses);

  /// The car was driven so far in all, in m. The first call is where counting begins; a distance
  /// below the last one is another origin: what was counted stays.
  void drive(double distance_m);
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
