#include "canvoy/devices/cia417/drive/drive_parameters.hpp"

#include <algorithm>
#include <limits>

#include "canvoy/profiles/cia417/drive_handles.hpp"

namespace canvoy::cia417 {

namespace {

using cia402::ProfileType;

constexpr std::uint16_t option_codes = control_option_codes_object.index;
constexpr std::uint16_t velocity_limits = max_velocity_object.index;
constexpr std::uint16_t acceleration_limits = max_acceleration_object.index;
constexpr std::uint16_t accelerations = profile_acceleration_object.index;
constexpr std::uint16_t jerks = profile_jerk_object.index;
constexpr std::uint16_t jerk_use = profile_jerk_use_object.index;
constexpr std::uint16_t quick_deceleration = quick_stop_deceleration_object.index;
constexpr std::uint16_t range_limit = position_range_limit_object.index;
constexpr std::uint16_t software_limit = software_position_limit_object.index;

/// For commands, which may come at any time; the rest is configuration.
constexpr bool is_between(std::uint16_t index, const ObjectInfo& first, const ObjectInfo& last) {
  return index >= first.index && index <= last.index;
}
constexpr AbortCode refuse_outside(std::int64_t wanted, std::int64_t low, std::int64_t high) {
  if (wanted < low) return AbortCode::value_too_low;
  return wanted > high ? AbortCode::value_too_high : AbortCode::none;
}
constexpr AbortCode one_of(bool is_known) {
  return is_known ? AbortCode::none : AbortCode::value_range;
}
constexpr bool is_mode(std::int64_t mode) {
  using cia402::DriveMode;
  return mode == static_cast<std::int64_t>(DriveMode::profile_position) ||
         mode == static_cast<std::int64_t>(DriveMode::profile_velocity) ||
         mode == static_cast<std::int64_t>(DriveMode::homing);
}
/// Highest power of ten of a unit.
constexpr std::int64_t notation_max = 9;

}  // namespace

std::int64_t DriveParameters::number(std::uint16_t index, std::uint8_t sub) const {
  const Result<Entry> entry = dictionary_->find(static_cast<std::uint16_t>(index + shift_), sub);
  if (!entry) return 0;
  const std::uint64_t whole = load_unsigned(entry->bytes());
  const DataType type = entry->row->type;
  return is_signed(type) ? sign_extend(whole, bit_length(type)) : static_cast<std::int64_t>(whole);
}
double DriveParameters::magnitude(std::uint16_t index, std::uint8_t sub) const {
  return static_cast<double>(number(index, sub));
}
bool DriveParameters::has(std::uint16_t index, std::uint8_t sub) const {
  return static_cast<bool>(dictionary_->find(static_cast<std::uint16_t>(index + shift_), sub));
}
/// Sub-index 1 by sub-index 2; 1 if the drive does not have the object.
double DriveParameters::ratio(std::uint16_t index) const {
  const double divisor = magnitude(index, 2);
  return divisor != 0 ? magnitude(index, 1) / divisor : 1;
}
double DriveParameters::power_of_ten(std::uint16_t index) const {
  return std::pow(10.0, magnitude(index, 1));
}

void DriveParameters::read() {
  units_ = read_units();
  windows_ = read_windows();
  velocity_max_ = read_velocity_max();
  end_velocity_ = magnitude(end_velocity_object.index, 0) * std::abs(units_.velocity);
  read_ramps();
  read_positions();
}

/// Feed and gear give the number of increments of a position; the notations give the relation of
/// the other units to that of positions. The further factors apply where these say nothing.
DriveUnits DriveParameters::read_units() const {
  const double increments = ratio(position_encoder_resolution_object.index) *
                            ratio(gear_ratio_object.index) / ratio(feed_constant_object.index) *
                            ratio(position_factor_object.index);
  const double position = power_of_ten(position_dimension_object.index);
  const double velocity = power_of_ten(velocity_dimension_object.index) / position;
  const double acceleration = power_of_ten(acceleration_dimension_object.index) / position;
  const double jerk_unit = power_of_ten(jerk_dimension_object.index) / position;
  const std::int64_t polarity = number(polarity_object.index, 0);
  const double sensor = ratio(velocity_encoder_resolution_object.index) /
                        ratio(position_encoder_resolution_object.index) *
                        ratio(velocity_encoder_factor_object.index);
  return {.position = (polarity & 0x80) != 0 ? -increments : increments,
          .velocity = ((polarity & 0x40) != 0 ? -increments : increments) * velocity *
                      ratio(velocity_factor_1_object.index) * ratio(velocity_factor_2_object.index),
          .acceleration = increments * acceleration * ratio(acceleration_factor_object.index),
          .jerk = increments * jerk_unit * ratio(jerk_factor_object.index),
          .sensor_velocity = sensor};
}

/// The lower one of the maxima of profile and motor; that of the motor in its revolutions per
/// minute.
double DriveParameters::read_velocity_max() const {
  const double profile = magnitude(velocity_limits, 1) * std::abs(units_.velocity);
  const double motor =
      magnitude(velocity_limits, 2) / 60 * ratio(position_encoder_resolution_object.index);
  return motor > 0 && (profile == 0 || motor < profile) ? motor : profile;
}

DriveWindows DriveParameters::read_windows() const {
  const double unit = std::abs(units_.velocity);
  const auto milliseconds = [this](std::uint16_t index) { return number(index, 2) * 1ms; };
  DriveWindows windows{.velocity_window = magnitude(velocity_window_object.index, 1) * unit,
                       .velocity_window_time = milliseconds(velocity_window_object.index),
                       .velocity_threshold = magnitude(velocity_threshold_object.index, 1) * unit,
                       .velocity_threshold_time = milliseconds(velocity_threshold_object.index)};
  if (has(max_slippage_object.index, 0)) {
    windows.max_slippage = magnitude(max_slippage_object.index, 0) * unit;
  }
  return windows;
}

/// From 640Ch, or without it by their number.
unsigned DriveParameters::jerks_used() const {
  const bool has_use = has(jerk_use, 0);
  return static_cast<unsigned>(has_use ? number(jerk_use, 0) : number(jerks, 0));
}
double DriveParameters::jerk(std::uint8_t sub) const {
  return magnitude(jerks, sub) * units_.jerk;
}

/// Assignment of jerks to bends: tables 1 to 4. If none is assigned to E and F, C and D apply.
void DriveParameters::read_ramps() {
  const auto lower = [](double wanted, double limit) {
    return limit > 0 && limit < wanted ? limit : wanted;
  };
  const double acceleration_max = magnitude(acceleration_limits, 1) * units_.acceleration;
  const double deceleration_max = has(acceleration_limits, 2)
                                      ? magnitude(acceleration_limits, 2) * units_.acceleration
                                      : acceleration_max;
  const double acceleration = magnitude(accelerations, 1) * units_.acceleration;
  const double deceleration =
      has(accelerations, 2) ? magnitude(accelerations, 2) * units_.acceleration : acceleration;
  ramps_.velocity =
      lower(magnitude(profile_velocity_object.index, 0) * std::abs(units_.velocity), velocity_max_);
  ramps_.acceleration = lower(acceleration, acceleration_max);
  ramps_.deceleration = lower(deceleration, deceleration_max);
  ramps_.type = static_cast<ProfileType>(number(motion_profile_type_object.index, 0));
  const unsigned used = jerks_used();
  ramps_.jerk = {};
  if (used == 1) ramps_.jerk = {jerk(1), jerk(1), jerk(1), jerk(1)};
  if (used == 2) ramps_.jerk = {jerk(1), jerk(1), jerk(2), jerk(2)};
  if (used >= 4) ramps_.jerk = {jerk(1), jerk(3), jerk(2), jerk(4)};
  final_ramp_ = ramps_;
  if (used == 6) {
    final_ramp_.jerk.start_deceleration = jerk(5);
    final_ramp_.jerk.end_deceleration = jerk(6);
  }
  // 640Dh is for profile movement (4.11.1.13): the quick stop has its deceleration at once.
  quick_stop_ = ramps_;
  quick_stop_.type = ProfileType::linear;
  quick_stop_.jerk = {};
  const double quick = magnitude(quick_deceleration, 0) * units_.acceleration;
  if (quick > 0) quick_stop_.deceleration = lower(quick, deceleration_max);
}

void DriveParameters::read_positions() {
  constexpr double none = std::numeric_limits<double>::max();
  const bool is_limited = has(software_limit, 1);
  const double first = is_limited ? magnitude(software_limit, 1) * units_.position : -none;
  const double second = is_limited ? magnitude(software_limit, 2) * units_.position : none;
  position_min_ = std::min(first, second);
  position_max_ = std::max(first, second);
}

double DriveParameters::in_range(double position) const {
  if (!has(range_limit, 1)) return position;
  const double low = magnitude(range_limit, 1);
  const double width = magnitude(range_limit, 2) - low + 1;
  return position - std::floor((position - low) / width) * width;
}

/// The defaults of CiA 402 if the drive does not have 6402h.
MotionLimits DriveParameters::stop_ramp(cia402::StopReaction reaction, double velocity) const {
  using enum cia402::StopReaction;
  const auto by = [this](double deceleration) {
    MotionLimits limits = ramps_;
    limits.deceleration = deceleration * std::abs(units_.acceleration);
    limits.jerk = {};
    limits.type = ProfileType::linear;
    return limits;
  };
  switch (reaction) {
    case quick_stop_ramp:
    case quick_stop_ramp_and_stay:
      return quick_stop_;
    case current_limit:
    case current_limit_and_stay:
      return by(motor_.current_deceleration);
    case voltage_limit:
    case voltage_limit_and_stay:
      return by(motor_.voltage_deceleration);
    case disable:
    case slow_down_ramp:
    case slow_down_ramp_and_stay:
      break;
  }
  return std::abs(velocity) <= end_velocity_ ? final_ramp_ : ramps_;
}

void DriveParameters::count_from(double home, double zero) {
  home_ = home;
  zero_ = zero;
  zero_above_home_ = (zero - home) / units_.position;
}

cia402::StopReaction DriveParameters::option(unsigned sub) const {
  constexpr std::int64_t defaults[] = {0, 0, 1, 2, 1, 2};
  const auto at = static_cast<std::uint8_t>(sub);
  const std::int64_t code = has(option_codes, at) ? number(option_codes, at) : defaults[sub];
  return static_cast<cia402::StopReaction>(code);
}

bool DriveParameters::is_command(const Entry& entry) const {
  const auto index = static_cast<std::uint16_t>(entry.index - shift_);
  return index == controlword_object.index || index == modes_of_operation_object.index ||
         index == target_position_object.index || index == target_velocity_object.index;
}

AbortCode DriveParameters::check(const Entry& entry, std::span<const std::uint8_t> value,
                                 DriveState state, bool relative) const {
  const auto index = static_cast<std::uint16_t>(entry.index - shift_);
  if (!is_command(entry) && is_powered(state)) return AbortCode::device_state;
  const std::uint64_t whole = load_unsigned(value);
  const DataType type = entry.row->type;
  const std::int64_t wanted =
      is_signed(type) ? sign_extend(whole, bit_length(type)) : static_cast<std::int64_t>(whole);
  if (index == modes_of_operation_object.index) return one_of(is_mode(wanted));
  if (index == target_position_object.index) {
    return relative ? AbortCode::none : check_target(wanted);
  }
  if (index == target_velocity_object.index) return check_velocity(wanted);
  if (index == option_codes) return check_option(entry.sub, wanted);
  if (index == range_limit || index == software_limit) return check_range(index, entry.sub, wanted);
  if (index == polarity_object.index) return one_of((wanted & 0x3F) == 0);
  if (index == sensor_selection_code_object.index) return one_of(wanted == 0 || wanted == 1);
  if (is_between(index, position_dimension_object, jerk_dimension_object)) {
    const bool is_notation = entry.sub == 1;
    return one_of(!is_notation || (wanted >= -notation_max && wanted <= notation_max));
  }
  // A factor of 0 has no meaning in numerator or denominator.
  if (is_between(index, position_encoder_resolution_object, jerk_factor_object)) {
    return refuse_outside(wanted, 1, wanted);
  }
  if (is_between(index, velocity_window_object, max_slippage_object)) {
    return refuse_outside(wanted, 0, wanted);
  }
  return check_ramp(entry, index, wanted);
}

AbortCode DriveParameters::check_option(unsigned sub, std::int64_t wanted) const {
  struct Codes {
    std::int64_t lowest;
    std::int64_t highest;
  };
  // A halt keeps operation enabled: nothing disables the drive.
  constexpr Codes codes[] = {{0, 0}, {0, 1}, {0, 1}, {0, 8}, {1, 4}, {0, 4}};
  const bool is_option = sub < std::size(codes);
  return one_of(is_option && wanted >= codes[sub].lowest && wanted <= codes[sub].highest);
}

AbortCode DriveParameters::check_range(std::uint16_t index, unsigned sub,
                                       std::int64_t wanted) const {
  const std::int64_t low = sub == 1 ? wanted : number(index, 1);
  const std::int64_t high = sub == 2 ? wanted : number(index, 2);
  return low > high ? AbortCode::maximum_below_minimum : AbortCode::none;
}

/// Velocities and accelerations: a ramp of 0 would never end. A jerk of 0 is none: for those of
/// 640Dh that 640Ch does not use, and a bend without a limit.
AbortCode DriveParameters::check_ramp(const Entry& entry, std::uint16_t index,
                                      std::int64_t wanted) const {
  const auto limit = [&](std::uint16_t object, std::uint8_t sub) {
    const std::uint8_t present = has(object, sub) ? sub : std::uint8_t{1};
    const std::int64_t highest = number(object, present);
    return highest > 0 ? highest : std::numeric_limits<std::int64_t>::max();
  };
  if (index == motion_profile_type_object.index) return one_of(wanted >= 0 && wanted <= 3);
  if (index == jerk_use) return one_of(wanted != 3 && wanted != 5);
  if (index == end_velocity_object.index)
    return refuse_outside(wanted, 0, limit(velocity_limits, 1));
  if (index == profile_velocity_object.index)
    return refuse_outside(wanted, 1, limit(velocity_limits, 1));
  if (index == quick_deceleration) return refuse_outside(wanted, 1, limit(acceleration_limits, 2));
  if (index == accelerations)
    return refuse_outside(wanted, 1, limit(acceleration_limits, entry.sub));
  if (index == velocity_limits || index == acceleration_limits)
    return refuse_outside(wanted, 1, wanted);
  return AbortCode::none;
}

/// Software limits count from the home position, targets from position 0.
AbortCode DriveParameters::check_target(std::int64_t wanted) const {
  if (!has(software_limit, 1)) return AbortCode::none;
  const std::int64_t from_home = wanted + std::llround(zero_above_home_);
  return refuse_outside(from_home, number(software_limit, 1), number(software_limit, 2));
}

AbortCode DriveParameters::check_velocity(std::int64_t wanted) const {
  const std::int64_t highest = number(velocity_limits, 1);
  return highest > 0 ? refuse_outside(wanted, -highest, highest) : AbortCode::none;
}

}  // namespace canvoy::cia417
