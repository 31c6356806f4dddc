// Motion of a vehicle, for 6484h and 6521h: it is recognized when the motion sensor has sent more
// than one pulse a second for at least 5 seconds (CiA 407, 9.2.15.4, 9.2.17.2).
//
//     recognition.take(pulses_per_second, now);
//     recognition.motion();
#pragma once

#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia407/vehicle.hpp"

namespace canvoy::cia407 {

inline constexpr double kmh_of_metres_per_second = 3.6;  ///< factor

class MotionRecognition {
 public:
  static constexpr Duration recognition_time = 5s;  ///< of more than one pulse a second

  /// Nothing: no signal from the sensor.
  void take(std::optional<double> pulses_per_second, Time now) {
    is_available_ = pulses_per_second.has_value();
    const bool is_pulsing = pulses_per_second && *pulses_per_second > 1;
    if (!is_pulsing) {
      since_ = std::nullopt;
    } else if (!since_) {
      since_ = now;
    }
    is_moving_ = since_ && now - *since_ >= recognition_time;
  }
  /// Motion as it is recognized at present.
  Motion motion() const {
    if (!is_available_) return Motion::not_available;
    return is_moving_ ? Motion::detected : Motion::not_detected;
  }

 private:
  std::optional<Time> since_;
  bool is_available_ = false;
  bool is_moving_ = false;
};

}  // namespace canvoy::cia407
