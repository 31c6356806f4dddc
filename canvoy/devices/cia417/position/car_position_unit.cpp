#include "canvoy/devices/cia417/position/car_position_unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "canvoy/profiles/cia417/encoder.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// Below this speed the car stands: its position may be preset, and is sampled rarely.
constexpr double standing_speed = 1;

/// A bit of 63C7h.
constexpr unsigned commissioning_alarm = 0x0002;
/// Bits of 6380h.
constexpr std::uint16_t code_sequence_bit = 0x0001;
constexpr std::uint16_t diagnostic_bit = 0x0002;
constexpr std::uint16_t scaling_bit = 0x0004;
constexpr std::uint16_t direction_bit = 0x0008;
constexpr std::uint16_t reserved_bits_mask = 0x0FF0;

template <class Number>
Number saturate(double value) {
  constexpr auto low = static_cast<double>(std::numeric_limits<Number>::min());
  constexpr auto high = static_cast<double>(std::numeric_limits<Number>::max());
  return static_cast<Number>(std::llround(std::clamp(value, low, high)));
}

}  // namespace

constexpr AccessHandlers CarPositionUnit::hook_calls[] = {
    before_write<&CarPositionUnit::check_parameter, operating_parameter_object>,
    before_write<&CarPositionUnit::check_step, measuring_step_settings_object>,
    before_write<&CarPositionUnit::check_preset, preset_value>,
    after_write<&CarPositionUnit::preset_written, preset_value>,
    after_write<&CarPositionUnit::parameter_written, operating_parameter_object,
                acceleration_value_car_object>,
    after_write<&CarPositionUnit::cam_setting_written, cam_enable_object, cam_polarity_object>};
constexpr ServiceHandlers CarPositionUnit::service_calls = {
    .reset = method<&CarPositionUnit::reset>, .hooks = hook_calls};

CarPositionUnit::CarPositionUnit(Node& node, const CarPositionServices& services,
                                 const CarPositionHardware& hardware,
                                 const CarPositionSettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      cams_(node.dictionary(), settings.lift, settings.cams),
      timer_(callback<&CarPositionUnit::tick>(*this)) {
  node.attach(service_);
  if (services.tpdos != nullptr) {
    services.tpdos->before_transmit = callback<&CarPositionUnit::before_transmit>(*this);
  }
  for (unsigned unit = 1; unit <= position_unit_count; ++unit) {
    units_[unit - 1].exists = value(position_value[unit]).exists();
  }
}

void CarPositionUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) {
    is_too_fast_ = false;
    for (unsigned unit = 1; unit <= position_unit_count; ++unit) {
      units_[unit - 1].has_alarm = false;
      if (units_[unit - 1].exists) describe(unit);
    }
    cams_.refresh();
  }
  tick(node_.now());
}

/// Constant properties.
void CarPositionUnit::describe(unsigned unit) {
  const EncoderProperties& encoder = settings_.encoders[unit - 1];
  value(single_turn_resolution[unit]) = encoder.single_turn_resolution;
  value(distinguishable_revolutions[unit]) = encoder.revolutions;
  value(supported_alarms[unit]) = encoder.supported_alarms;
  value(supported_warnings[unit]) = encoder.supported_warnings;
  value(manufacturer_offset(unit)).set_raw(static_cast<std::uint32_t>(encoder.manufacturer_offset));
  value(manufacturer_minimum(unit)) = encoder.position_min;
  value(manufacturer_maximum(unit)) = encoder.position_max;
  configure(unit);
}

void CarPositionUnit::configure(unsigned unit) {
  Unit& of = units_[unit - 1];
  const std::uint16_t parameter = value(operating_parameter[unit]).raw();
  value(operating_status[unit]) = parameter;
  const bool is_reversed =
      ((parameter & code_sequence_bit) != 0) != ((parameter & direction_bit) != 0);
  of.sign = is_reversed ? -1 : 1;
  const unsigned offset = unit - 1;
  const double steps = value(measuring_step.shifted(offset)).raw();
  const double in_tenths = value(speed_measuring_step.shifted(offset)).raw();
  of.acceleration_step =
      std::max<std::uint32_t>(value(acceleration_measuring_step.shifted(offset)).raw(), 1);
  of.step = std::max(steps, 1.0) / 100;
  of.speed_step = std::max(in_tenths, 1.0) / 10;
  const double revolution = settings_.encoders[offset].revolution_micrometre;
  const double counts = value(units_per_revolution[unit]).raw();
  const bool is_scaled = (parameter & scaling_bit) != 0 && revolution > 0 && counts > 0;
  if (is_scaled) of.step = revolution / 1000 / counts;
}

AbortCode CarPositionUnit::check_parameter(Raw<std::uint16_t> wanted) {
  return (wanted.bits & reserved_bits_mask) == 0 ? AbortCode::none : AbortCode::value_range;
}

AbortCode CarPositionUnit::check_step(Raw<std::uint32_t> wanted) {
  return wanted.bits != 0 ? AbortCode::none : AbortCode::value_too_low;
}

/// The position of a moving car is not known to the count.
AbortCode CarPositionUnit::check_preset(const Entry& entry, std::span<const std::uint8_t>) {
  const Unit& unit = units_[entry.sub - 1U];
  const bool moves = std::abs(unit.readings.velocity_millimetre_per_second) > standing_speed;
  return moves ? AbortCode::device_state : AbortCode::none;
}

void CarPositionUnit::preset_written(const Entry& entry) {
  preset(entry.sub);
}

void CarPositionUnit::parameter_written() {
  for (unsigned unit = 1; unit <= position_unit_count; ++unit) {
    if (units_[unit - 1].exists) configure(unit);
  }
  sample();
}

std::int64_t CarPositionUnit::measured(const Unit& unit) const {
  return std::llround(unit.sign * unit.readings.position_millimetre / unit.step);
}

/// Gives the present position this value.
void CarPositionUnit::preset(unsigned unit) {
  Unit& of = units_[unit - 1];
  of.readings = hardware_.sense(unit);
  const auto wanted = static_cast<std::int32_t>(value(preset_value[unit]).raw());
  of.offset = wanted - measured(of);
}

std::int32_t CarPositionUnit::position(unsigned unit) const {
  return static_cast<std::int32_t>(value(position_value[unit]).raw());
}

void CarPositionUnit::before_transmit(std::uint16_t) {
  sample();
}

void CarPositionUnit::tick(Time now) {
  sample();
  const bool moves = std::ranges::any_of(units_, [](const Unit& unit) {
    return unit.exists && std::abs(unit.readings.velocity_millimetre_per_second) > standing_speed;
  });
  node_.timers().arm(timer_, now + (moves ? settings_.moving_period : settings_.standing_period));
}

void CarPositionUnit::sample() {
  double fastest = 0;
  for (unsigned unit = 1; unit <= position_unit_count; ++unit) {
    if (!units_[unit - 1].exists) continue;
    sample(unit);
    fastest = std::max(fastest, std::abs(units_[unit - 1].readings.velocity_millimetre_per_second));
  }
  watch_speed(fastest);
}

void CarPositionUnit::sample(unsigned unit) {
  Unit& of = units_[unit - 1];
  of.readings = hardware_.sense(unit);
  const PositionReadings& now = of.readings;
  const auto position = static_cast<std::int32_t>(measured(of) + of.offset);
  value(position_value[unit]).set_raw(static_cast<std::uint32_t>(position));
  value(speed_value[unit]) =
      saturate<std::int16_t>(of.sign * now.velocity_millimetre_per_second / of.speed_step);
  value(acceleration_value[unit]) = saturate<std::int16_t>(
      of.sign * now.acceleration_millimetre_per_second_squared / of.acceleration_step);
  value(offset_value[unit]) = saturate<std::int16_t>(static_cast<double>(of.offset));
  const auto tenths = static_cast<std::uint32_t>(node_.now().time_since_epoch() / 6min);
  value(operating_time[unit]).set_raw(settings_.encoders[unit - 1].operating_time + tenths);
  report_areas(unit, position);
  report_errors(unit);
  cams_.update(unit, position * of.step);
}

/// An area with no width between its limits is none.
void CarPositionUnit::report_areas(unsigned unit, std::int32_t position) {
  const unsigned offset = unit - 1;
  const std::uint16_t index = in_lift(settings_.lift, out_of_range).shifted(offset).index();
  const auto channels = static_cast<unsigned>(node_.dictionary().number(index, 0));
  for (unsigned channel = 1; channel <= channels; ++channel) {
    const std::int32_t low = value(work_area_low_limit(unit, channel)).raw();
    const std::int32_t high = value(work_area_high_limit(unit, channel)).raw();
    const bool is_over = low < high && position > high;
    const bool is_under = low < high && position < low;
    const unsigned state =
        (is_over || is_under ? 1U : 0U) | (is_over ? 2U : 0U) | (is_under ? 4U : 0U);
    node_.dictionary().set_number(index, static_cast<std::uint8_t>(channel), state);
  }
}

void CarPositionUnit::report_errors(unsigned unit) {
  Unit& of = units_[unit - 1];
  const EncoderProperties& encoder = settings_.encoders[unit - 1];
  const bool is_diagnosed = (value(operating_parameter[unit]).raw() & diagnostic_bit) != 0;
  const unsigned silent = is_diagnosed ? 0 : commissioning_alarm;
  const auto alarm_bits =
      static_cast<std::uint16_t>(of.readings.alarms & encoder.supported_alarms & ~silent);
  value(alarms[unit]) = alarm_bits;
  value(warnings[unit]) =
      static_cast<std::uint16_t>(of.readings.warnings & encoder.supported_warnings);
  if ((alarm_bits != 0) == of.has_alarm) return;
  of.has_alarm = alarm_bits != 0;
  const Error error = {.code = settings_.alarm_code, .instance = static_cast<std::uint16_t>(unit)};
  if (of.has_alarm) {
    node_.raise(error);
  } else {
    node_.clear(error);
  }
}

/// The error ends when the car stands: a governor does not release before.
void CarPositionUnit::watch_speed(double speed) {
  const double limit = settings_.overspeed_millimetre_per_second;
  const Error error = {.code = emergency_code::overspeed};
  if (limit > 0 && speed > limit && !is_too_fast_) {
    is_too_fast_ = true;
    node_.raise(error);
  } else if (is_too_fast_ && speed <= standing_speed) {
    is_too_fast_ = false;
    node_.clear(error);
  }
}

}  // namespace canvoy::cia417
