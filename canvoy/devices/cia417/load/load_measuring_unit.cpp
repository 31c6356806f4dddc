#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// FFFFh means none.
constexpr std::uint16_t load_max = 0xFFFE;
/// Allowed powers of ten of the unit.
constexpr int prefix_max = 3;

constexpr Error sensor_defect = {.code = emergency_code::application_error};

/// The bit of a signal in 6482h.
template <class Handle>
constexpr std::uint8_t bit_of(const Handle& /*flag*/) {
  return static_cast<std::uint8_t>(insert(0, Handle::Place::bits, 1));
}

}  // namespace

constexpr AccessHandlers LoadMeasuringUnit::hook_calls[] = {
    before_write<&LoadMeasuringUnit::check_unit, load_si_unit>,
    before_write<&LoadMeasuringUnit::check_ratio, rope_ratio_nominator>,
    after_write<&LoadMeasuringUnit::look_again, absolute_load_value, rope_ratio_nominator>};
constexpr ServiceHandlers LoadMeasuringUnit::service_calls = {
    .reset = method<&LoadMeasuringUnit::reset>, .hooks = hook_calls};

LoadMeasuringUnit::LoadMeasuringUnit(Node& node, const LoadHardware& hardware,
                                     const LoadSettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&LoadMeasuringUnit::look>(*this)) {
  node.attach(service_);
}

void LoadMeasuringUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) {
    is_defect_ = false;
    const auto begin = [](const auto& limit, std::uint16_t wanted) {
      if (!limit.is_valid()) limit.set_raw(wanted);
    };
    begin(value(zero_load_limit), settings_.zero_load);
    begin(value(norm_load_limit), settings_.norm_load);
    begin(value(full_load_limit), settings_.full_load);
    begin(value(overload_limit), settings_.overload);
    if (value(rope_ratio_denominator).raw() == 0) {
      value(rope_ratio_denominator).set_raw(static_cast<std::uint8_t>(settings_.rope_ratio));
      value(rope_ratio_nominator).set_raw(static_cast<std::uint8_t>(settings_.rope_ratio >> 8));
    }
  }
  look(node_.now());
}

/// Only kilograms, with a prefix.
AbortCode LoadMeasuringUnit::check_unit(Raw<std::uint16_t> unit) {
  const int prefix = (unit.bits >> 8 ^ 0x80) - 0x80;  // signed
  const bool is_known =
      static_cast<std::uint8_t>(unit.bits) == kilogram_code && std::abs(prefix) <= prefix_max;
  return is_known ? AbortCode::none : AbortCode::value_range;
}

/// Refuses a denominator of 0.
AbortCode LoadMeasuringUnit::check_ratio(Raw<std::uint16_t> ratio) {
  const bool is_ratio = (ratio.bits & 0xFF) != 0 && ratio.bits >> 8 != 0;
  return is_ratio ? AbortCode::none : AbortCode::value_range;
}

void LoadMeasuringUnit::look_again() {
  look(node_.now());
}

void LoadMeasuringUnit::look(Time now) {
  if (settings_.sensing_period > Duration::zero()) {
    node_.timers().arm(timer_, now + settings_.sensing_period);
  }
  const std::optional<double> kilograms = weigh();
  std::optional<std::uint16_t> load;
  if (kilograms) load = in_unit(std::max(0.0, *kilograms - settings_.tare_kg));
  report_load(load);
  signal(load);  // of the whole load: a load above the range of 6481h is still an overload
  if (kilograms.has_value() != is_defect_) return;
  is_defect_ = !is_defect_;
  if (is_defect_) {
    node_.raise(sensor_defect);
  } else {
    node_.clear(sensor_defect);
  }
}

/// Within the limits of 6481h, if these are set.
void LoadMeasuringUnit::report_load(std::optional<std::uint16_t> load) {
  const std::uint16_t low = value(load_low_limit).raw();
  const std::uint16_t high = value(load_high_limit).raw();
  const auto told = value(absolute_load_value);
  if (!load) {
    told = std::nullopt;
  } else {
    told.set_raw(high > low ? std::clamp(*load, low, high) : *load);
  }
}

/// All ropes together, with the ratio of 6485h; nothing if one of them is not known.
std::optional<double> LoadMeasuringUnit::weigh() {
  double sum = 0;
  bool is_known = true;
  for (unsigned rope = 1; rope <= settings_.ropes; ++rope) {
    const std::optional<double> kilograms = hardware_.rope_load(rope);
    const double pulls = std::max(0.0, kilograms.value_or(0));
    value(rope_load(rope)).set_raw(in_unit(pulls));
    sum += pulls;
    is_known = is_known && kilograms.has_value();
  }
  if (!is_known) return std::nullopt;
  const double nominator = std::max<unsigned>(value(rope_ratio_nominator).raw(), 1);
  const double denominator = std::max<unsigned>(value(rope_ratio_denominator).raw(), 1);
  return sum * nominator / denominator;
}

/// In multiples of the unit of 6480h:02h.
std::uint16_t LoadMeasuringUnit::in_unit(double kilograms) const {
  const auto prefix = static_cast<std::int8_t>(value(load_si_prefix).raw());
  const double count = kilograms / std::pow(10.0, prefix);
  return static_cast<std::uint16_t>(std::lround(std::clamp(count, 0.0, double{load_max})));
}

void LoadMeasuringUnit::signal(std::optional<std::uint16_t> load) {
  std::uint8_t signals = 0;
  const auto add = [&signals, load](const auto& limit, bool is_below, std::uint8_t bit) {
    if (!load.has_value() || !limit.is_valid()) return;
    const bool is_reached = is_below ? *load <= limit.raw() : *load >= limit.raw();
    if (is_reached) signals |= bit;
  };
  add(value(zero_load_limit), true, bit_of(zero_load_reached));
  add(value(norm_load_limit), false, bit_of(norm_load_reached));
  add(value(full_load_limit), false, bit_of(full_load_reached));
  add(value(overload_limit), false, bit_of(overload_reached));
  report_signals(signals);
}

void LoadMeasuringUnit::report_signals(std::uint8_t signals) {
  const auto place = in_lift(settings_.lift, zero_load_reached);
  const auto mask = in_lift(settings_.lift, zero_load_interrupt);
  Dictionary& dictionary = node_.dictionary();
  const Result<Entry> entry = dictionary.find(place.index(), place.sub());
  if (!entry || *entry->value == signals) return;
  const auto told = static_cast<unsigned>(dictionary.number(mask.index(), mask.sub()));
  if (((*entry->value ^ signals) & told) == 0) {
    dictionary.set_without_event(*entry, {&signals, 1});
  } else {
    dictionary.set_with_event(*entry, {&signals, 1});
  }
}

}  // namespace canvoy::cia417
