// The curve of a charger for a battery that requests no current (CiA 419, 6.2.5: one without TPDO
// 3): IUoU. Constant current until the voltage is reached, constant voltage until little flows,
// then a small current for a time, which equalises the cells of a flooded battery.
//
//     ChargeCurve curve({.current_ampere = 60, .cell_voltage_volt = 2.4, .tail_ampere = 12});
//     curve.begin();                               // with each battery
//     curve.advance(100ms, {.volt = 51.2, .cells = 24});
//     stage.deliver(curve.ampere());
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::cia419 {

/// The values are those of the battery's maker: CiA 419 names none.
struct ChargeCurveSettings {
  double current_ampere = 0;       ///< of the first phase; 0: the charger has no curve of its own
  double cell_voltage_volt = 2.4;  ///< held in the second phase, multiplied by the number of cells
  double tail_ampere = 12;         ///< ends the second phase, when no more flows for `tail_time`
  Duration tail_time = 1min;       ///< for which the current stays at or below `tail_ampere`
  Duration voltage_time_max = 8h;  ///< ends the second phase of a battery that never takes less
  double equalising_ampere = 0;    ///< 0: the charge ends with the second phase
  Duration equalising_time = 1h;   ///< length of the last phase
};

/// Current of a charger whose battery requests none: constant current, constant voltage, and
/// equalising (IUoU).
class ChargeCurve {
 public:
  /// In this order; without equalising, `finished` follows `voltage`.
  enum class Phase : std::uint8_t { current, voltage, equalising, finished };
  /// Measured values at the battery.
  struct Measured {
    double volt = 0;   ///< at the terminals
    double cells = 0;  ///< in series; 0: unknown, so that the first phase never ends
  };

  /// Starts in the first phase.
  explicit ChargeCurve(const ChargeCurveSettings& settings) : settings_(settings) {}

  /// False if the charger follows the battery's requests alone.
  bool is_used() const { return settings_.current_ampere > 0; }
  /// Present phase.
  Phase phase() const { return phase_; }
  /// Another battery.
  void begin();
  /// Call it after each `time` in which current flowed by the curve.
  void advance(Duration time, const Measured& measured);
  /// To be delivered next, in A.
  double ampere() const;

 private:
  void hold_voltage(Duration time, const Measured& measured);
  void enter(Phase phase);

  ChargeCurveSettings settings_;
  Phase phase_ = Phase::current;
  Duration in_phase_{};
  Duration with_little_{};
  double held_ampere_ = 0;  ///< in the second phase
};

}  // namespace canvoy::cia419
