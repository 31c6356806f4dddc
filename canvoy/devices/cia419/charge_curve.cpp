#include "canvoy/devices/cia419/charge_curve.hpp"

#include <algorithm>

namespace canvoy::cia419 {

namespace {

/// Share of the first current by which a voltage that is wrong by all of it changes the current in
/// a second. Slow against the PDO with the voltage (200 ms), fast against the cells.
constexpr double gain_per_second = 1;

}  // namespace

void ChargeCurve::begin() {
  enter(Phase::current);
}

void ChargeCurve::enter(Phase phase) {
  phase_ = phase;
  in_phase_ = with_little_ = Duration::zero();
  held_ampere_ = settings_.current_ampere;
}

double ChargeCurve::ampere() const {
  switch (phase_) {
    case Phase::current:
    case Phase::voltage:
      return held_ampere_;
    case Phase::equalising:
      return settings_.equalising_ampere;
    case Phase::finished:
      break;
  }
  return 0;
}

void ChargeCurve::advance(Duration time, const Measured& measured) {
  if (!is_used()) return;
  in_phase_ += time;
  const double limit_volt = settings_.cell_voltage_volt * measured.cells;
  if (phase_ == Phase::current && measured.cells > 0 && measured.volt >= limit_volt) {
    enter(Phase::voltage);
  }
  if (phase_ == Phase::voltage) hold_voltage(time, measured);
  if (phase_ == Phase::equalising && in_phase_ >= settings_.equalising_time) {
    enter(Phase::finished);
  }
}

void ChargeCurve::hold_voltage(Duration time, const Measured& measured) {
  const double limit_volt = settings_.cell_voltage_volt * measured.cells;
  const double seconds = std::chrono::duration<double>(time).count();
  const double wrong = limit_volt > 0 ? (limit_volt - measured.volt) / limit_volt : -1;
  held_ampere_ =
      std::clamp(held_ampere_ + gain_per_second * seconds * wrong * settings_.current_ampere, 0.0,
                 settings_.current_ampere);
  with_little_ = held_ampere_ <= settings_.tail_ampere ? with_little_ + time : Duration::zero();
  const bool is_over =
      with_little_ >= settings_.tail_time || in_phase_ >= settings_.voltage_time_max;
  if (is_over) enter(settings_.equalising_ampere > 0 ? Phase::equalising : Phase::finished);
}

}  // namespace canvoy::cia419
