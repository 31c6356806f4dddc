#include "canvoy/devices/cia417/drive_homing.hpp"

namespace canvoy::cia417 {

bool HomingSearch::goes_up() const {
  return method_ == HomingMethod::home_switch_above ||
         method_ == HomingMethod::upper_limit_switch ||
         method_ == HomingMethod::upper_limit_switch_and_index ||
         method_ == HomingMethod::index_above;
}

void HomingSearch::begin(double position, bool up_is_positive) {
  direction_ = goes_up() == up_is_positive ? 1 : -1;
  if (method_ == HomingMethod::present_position) direction_ = 0;
  seeks_index_ = method_ == HomingMethod::index_below || method_ == HomingMethod::index_above;
  from_ = position;
}

/// Where the switch that is looked for has switched.
std::optional<double> HomingSearch::aim_of(const DriveReadings& readings) const {
  switch (method_) {
    case HomingMethod::lower_limit_switch:
    case HomingMethod::lower_limit_switch_and_index:
      return readings.lower_limit_position;
    case HomingMethod::upper_limit_switch:
    case HomingMethod::upper_limit_switch_and_index:
      return readings.upper_limit_position;
    default:
      return readings.home_position;
  }
}

std::optional<double> HomingSearch::look(const DriveReadings& readings) {
  if (direction_ == 0) return readings.position;
  if (seeks_index_) {
    const auto& index = readings.index_position;
    const bool is_ahead = index && (*index - from_) * direction_ > 0;
    return is_ahead && has_passed(readings.position, *index) ? index : std::nullopt;
  }
  const std::optional<double> aim = aim_of(readings);
  if (!aim || !has_passed(readings.position, *aim)) return std::nullopt;
  const bool is_found = method_ != HomingMethod::lower_limit_switch_and_index &&
                        method_ != HomingMethod::upper_limit_switch_and_index;
  if (is_found) return aim;
  // Back, to the first index pulse where the switch is off again.
  seeks_index_ = true;
  from_ = *aim;
  direction_ = -direction_;
  return std::nullopt;
}

}  // namespace canvoy::cia417
