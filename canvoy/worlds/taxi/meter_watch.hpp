// Reads a taximeter's display as people do: the total of the last trip at its end, and whether a
// loss of power left the trip in a defined state: after a short one it continues with its values,
// after a longer one it has ended with them (Directive 2014/32/EU, annex IX, reduction of the
// supply; the manufacturer declares what is short).
//
//     MeterWatch watch(settings.longest_power_cut);
//     watch.power_changes(now, false);
//     if (const auto total = watch.look(now, display)) trips.meter_ended(*total);    // each step
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::taxi {

class MeterWatch {
 public:
  /// A trip continues after a loss of power that was not longer.
  explicit MeterWatch(Duration longest_power_cut) : longest_cut_(longest_power_cut) {}

  /// Call it before the meter loses or gets its power.
  void power_changes(Time now, bool is_on);
  /// Total of a trip that has ended since the last look, in 0.001 of the currency unit.
  std::optional<double> look(Time now, const cia447::TaximeterDisplay& display);

  std::uint64_t cuts() const {
    return cuts_;
  }  ///< losses of power during a trip that
     ///< were judged
  std::uint64_t wrong_ends() const {
    return wrong_ends_;
  }  ///< those among them with a wrong
     ///< result
  /// True if a loss of power of this length ends a trip, or may: the meter's clock has whole
  /// seconds.
  bool may_end_trip(Duration cut) const { return cut > longest_cut_ - clock_step; }

 private:
  static constexpr Duration clock_step = 2s;

  void judge_return(Time now, const cia447::TaximeterDisplay& display);
  bool is_defined(const cia447::TaximeterDisplay& display) const;

  Duration longest_cut_;
  cia447::TaximeterDisplay last_;    ///< last display
  cia447::TaximeterDisplay before_;  ///< display before the loss of power
  Time lost_at_{};
  Time back_at_{};
  bool is_dark_ = false;
  bool is_awaited_ = false;  ///< the display after a loss
  bool has_trip_ = false;
  std::uint64_t cuts_ = 0;
  std::uint64_t wrong_ends_ = 0;
};

}  // namespace canvoy::taxi
