#include "canvoy/canopen/device/indicators.hpp"

#include <algorithm>

namespace canvoy {

namespace {

constexpr Duration step = 200ms;
constexpr Duration flicker_step = 50ms;
constexpr unsigned dark_steps = 5;  // after the last flash: a second

/// A pattern: a number of steps, alternately on and off, then darkness. Red is a step later.
struct Shape {
  Duration step;
  unsigned flashes;
  unsigned steps;
};

constexpr Shape flashes(unsigned count) {
  return {step, count, 2 * count - 1 + dark_steps};
}

Shape shape_of(Indication indication) {
  switch (indication) {
    case Indication::flickering:
      return {flicker_step, 1, 2};
    case Indication::blinking:
      return {step, 1, 2};
    case Indication::single_flash:
      return flashes(1);
    case Indication::double_flash:
      return flashes(2);
    case Indication::triple_flash:
      return flashes(3);
    default:
      return flashes(4);
  }
}

bool changes(Indication indication) {
  return indication != Indication::off && indication != Indication::on;
}

}  // namespace

bool is_lit(Indication indication, Indicator indicator, Time at) {
  if (!changes(indication)) return indication == Indication::on;
  const Shape shape = shape_of(indication);
  const Time begin = indicator == Indicator::error ? Time(shape.step) : Time{};
  const Duration cycle = shape.step * shape.steps;
  const Duration phase = ((at - begin) % cycle + cycle) % cycle;
  const auto number = static_cast<unsigned>(phase / shape.step);
  return number % 2 == 0 && number < 2 * shape.flashes;
}

Time next_change(Indication indication, Indicator indicator, Time at) {
  if (!changes(indication)) return never;
  const Duration length = shape_of(indication).step;
  const bool lit = is_lit(indication, indicator, at);
  Time next = at - (at.time_since_epoch() % length + length) % length;
  do {
    next += length;
  } while (is_lit(indication, indicator, next) == lit);
  return next;
}

void Indicators::set(Condition condition, bool holds) {
  const auto bit = static_cast<unsigned>(condition);
  conditions_ = static_cast<std::uint8_t>(holds ? conditions_ | bit : conditions_ & ~bit);
}

bool Indicators::holds(Condition condition) const {
  return (conditions_ & static_cast<unsigned>(condition)) != 0;
}

Indication Indicators::run() const {
  if (flickers()) return Indication::flickering;
  if (holds(Condition::program_download)) return Indication::triple_flash;
  switch (node_.state()) {
    case NmtState::initialisation:
      return Indication::off;
    case NmtState::stopped:
      return Indication::single_flash;
    case NmtState::operational:
      return Indication::on;
    case NmtState::pre_operational:
      return Indication::blinking;
  }
  return Indication::off;
}

Indication Indicators::error() const {
  const BusState bus = node_.bus_state();
  if (bus == BusState::bus_off) return Indication::on;
  if (flickers()) return Indication::flickering;
  if (is_present(emergency_code::rpdo_time_out)) return Indication::quadruple_flash;
  if (sync_ != nullptr && sync_->is_lost()) return Indication::triple_flash;
  const bool lost = holds(Condition::error_control) || is_present(emergency_code::heartbeat);
  if (lost) return Indication::double_flash;
  if (bus != BusState::error_active) return Indication::single_flash;
  return holds(Condition::invalid_configuration) ? Indication::blinking : Indication::off;
}

bool Indicators::is_present(std::uint16_t error_code) const {
  return emergency_ != nullptr &&
         std::ranges::any_of(emergency_->present(),
                             [=](const Error& error) { return error.code == error_code; });
}

}  // namespace canvoy
