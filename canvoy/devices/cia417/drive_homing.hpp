// How a car drive unit finds its home position (CiA 402, homing mode; CiA 417-4, 4.11.5).
//
//     HomingSearch search(HomingMethod::lower_limit_switch_and_index);
//     search.begin(readings.position, true);
//     search.direction()                    // -1: increments go down
//     const std::optional<double> home = search.look(readings);
//
// CiA 417 has the home offset alone, and no object for the method: the maker of the drive chooses
// it. The numbers are those that CiA 402 gives the methods. What a switch or the index pulse told
// counts once the car has passed it in the direction of the search.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia417/car_drive_hardware.hpp"

namespace canvoy::cia417 {

enum class HomingMethod : std::uint8_t {
  home_switch_below,             ///< down to the home switch
  home_switch_above,             ///< up to the home switch
  lower_limit_switch,            ///< 17
  upper_limit_switch,            ///< 18
  lower_limit_switch_and_index,  ///< 1: the first index pulse above the lower limit switch
  upper_limit_switch_and_index,  ///< 2: the first index pulse below the upper limit switch
  index_below,                   ///< 33: the next index pulse
  index_above,                   ///< 34
  present_position,              ///< 35 and 37: the car does not move
};

class HomingSearch {
 public:
  explicit HomingSearch(HomingMethod method) : method_(method) {}

  /// `up_is_positive`: increments grow while the car goes up.
  void begin(double position, bool up_is_positive);
  /// In increments: 1 or -1; 0: the car need not move.
  int direction() const { return direction_; }
  /// The home position, once it is found; the direction may be another one afterwards. To be
  /// called each time that the hardware was sensed.
  std::optional<double> look(const DriveReadings& readings);

 private:
  bool goes_up() const;
  std::optional<double> aim_of(const DriveReadings& readings) const;
  bool has_passed(double position, double aim) const { return (position - aim) * direction_ >= 0; }

  HomingMethod method_;
  int direction_ = 0;
  bool seeks_index_ = false;
  double from_ = 0;  ///< the index pulse lies behind it
};

}  // namespace canvoy::cia417
