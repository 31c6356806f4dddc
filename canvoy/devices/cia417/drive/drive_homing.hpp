// The search of a car drive unit for its home position (CiA 402, homing mode; CiA 417-4, 4.11.5).
//
//     HomingSearch search(HomingMethod::home_switch_and_index_7);
//     search.begin(readings, true);
//     search.direction()                    // -1: increments go down
//     const std::optional<double> home = search.look(readings);
//
// CiA 417 has only the home offset, and no object for the method: the maker of the drive selects
// it. The numbers are those of the methods in CiA 402. A switch or the index pulse counts when the
// car has passed it in the direction of the search.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"

namespace canvoy::cia417 {

/// Methods with a home switch use one edge of it, passed in one direction, whether the car is below
/// it, at it or above it at the start:
///
/// - 3, 4, 19, 20: the switch is on above some place: its edge, passed down (3, 19) or up
/// - 5, 6, 21, 22: it is on below some place: its edge, passed up (5, 21) or down
/// - 7 to 14, 23 to 30: it is on for a piece of the way: its lower edge, passed down (7, 14) or
///   up (8, 13); its upper edge, passed down (9, 12) or up (10, 11)
///
/// With the switch off, methods 7 to 10 start upwards and 11 to 14 downwards, and turn once at the
/// limit switch if that was the wrong way. Methods 3 to 14 use the first index pulse behind the
/// edge, 19 to 30 (16 more) the edge itself.
enum class HomingMethod : std::int8_t {
  home_switch_below = -1,            ///< down to the home switch, from above
  home_switch_above = -2,            ///< up to the home switch, from below
  lower_limit_switch_and_index = 1,  ///< the first index pulse above the lower limit switch
  upper_limit_switch_and_index = 2,  ///< the first index pulse below the upper limit switch
  home_switch_and_index_3 = 3,
  home_switch_and_index_4,
  home_switch_and_index_5,
  home_switch_and_index_6,
  home_switch_and_index_7,
  home_switch_and_index_8,
  home_switch_and_index_9,
  home_switch_and_index_10,
  home_switch_and_index_11,
  home_switch_and_index_12,
  home_switch_and_index_13,
  home_switch_and_index_14,
  lower_limit_switch = 17,
  upper_limit_switch = 18,
  home_switch_19 = 19,
  home_switch_20,
  home_switch_21,
  home_switch_22,
  home_switch_23,
  home_switch_24,
  home_switch_25,
  home_switch_26,
  home_switch_27,
  home_switch_28,
  home_switch_29,
  home_switch_30,
  index_below = 33,  ///< the next index pulse
  index_above = 34,
  present_position = 37,  ///< and 35: the car does not move
};

/// One search, by one method.
class HomingSearch {
 public:
  /// Makes a search that has not begun.
  explicit HomingSearch(HomingMethod method) : method_(method) {}

  /// `up_is_positive`: increments grow when the car goes up.
  void begin(const DriveReadings& readings, bool up_is_positive);
  /// True if the hardware provides what the method needs.
  bool is_possible(const DriveReadings& readings) const;
  /// Direction in increments: 1 or -1; 0: the car need not move.
  int direction() const { return direction_; }
  /// Returns the home position once it is found; the direction may change afterwards. Call it after
  /// each reading of the hardware.
  std::optional<double> look(const DriveReadings& readings);
  /// True if the search cannot find anything: the car has passed the limit switch in the direction
  /// of the search, and the method does not turn there. Call it when look() has found nothing.
  bool is_at_end(const DriveReadings& readings) const;

 private:
  bool goes_up() const;
  std::optional<double> aim_of(const DriveReadings& readings) const;
  bool has_passed(double position, double aim) const { return (position - aim) * direction_ >= 0; }
  bool is_at_limit(const DriveReadings& readings) const;
  std::optional<double> look_for_index(const DriveReadings& readings) const;
  std::optional<double> look_for_edge(const DriveReadings& readings);
  void turn_at_limit(const DriveReadings& readings);
  bool is_up(double movement) const { return (movement > 0) == up_is_positive_; }

  HomingMethod method_;
  int direction_ = 0;
  bool up_is_positive_ = true;
  bool seeks_index_ = false;
  bool has_turned_ = false;  ///< at a limit switch
  bool was_on_ = false;      ///< the home switch
  double from_ = 0;          ///< the index pulse lies behind it
};

}  // namespace canvoy::cia417
