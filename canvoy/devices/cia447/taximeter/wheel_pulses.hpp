// Counts pulses of the wheels from the counter of the IVN gateway (6055h, overrun value 6056h; CiA
// 447-3, 4.2.4.6 and 4.2.4.7), each of them once.
//
// Values that are lost or sent twice have no effect: each counts from the last accepted one. An
// impossible value, for which the car would have to be too fast, is put aside. If the next values
// continue from it, the counter was set to another value, and is followed from there, without the
// difference: no distance is ever invented.
//
//     WheelPulses wheel;
//     wheel.set_fastest(2000);  // pulses a second
//     distance += wheel.count(counter, Signal::yes, now);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia447/states.hpp"

namespace canvoy::cia447 {

// Checks wheel pulses (6055h) against other data: the rpm of the wheels (6053h), accurate to 1 %
// from 3 km/h on and at most 500 ms late (CiA 447-3, 4.2.4.4), and of the engine (6050h).
//
//     WheelCheck check;
//     const bool counts = check.take({.turned = 8, .since = 100ms, .half_rpm = 0, .k = 24'000});
//     if (check.has_extra_pulses()) ...

/// A count, with the accompanying data.
struct WheelSeen {
  std::uint32_t turned = 0;               ///< pulses
  Duration since{};                       ///< time since the last count
  std::optional<unsigned> half_rpm = {};  ///< 6053h: in 0,5/min; nothing: not available
  std::optional<unsigned> engine = {};    ///< 6050h: in 1/min
  std::uint32_t k = 1;                    ///< pulses for a distance unit
};

/// Checks wheel pulses (6055h) against speed and engine.
class WheelCheck {
 public:
  /// False: the pulses are not from the wheels, which have stood for a second.
  bool take(const WheelSeen& seen);

  /// True if the wheels turn, and no pulses have come for 5 s.
  bool lacks_pulses() const { return standing_ >= standing_max; }
  /// True if 4 thousandths of a distance unit or more have come while the wheels stood; or if two
  /// consecutive windows of 10 s have a twentieth more pulses for a turn than the first.
  bool has_extra_pulses() const { return is_extra_ || extra_windows_ >= windows_max; }
  /// True if a tenth of a distance unit was driven while the engine stood, which has turned before.
  bool has_standing_engine() const { return is_without_engine_; }
  /// For other wheels, or another source of their pulses.
  void forget() { *this = {}; }

 private:
  static constexpr Duration standing_max = 5s;
  static constexpr unsigned windows_max = 2;

  void watch_rest(const WheelSeen& seen);
  void watch_ratio(const WheelSeen& seen);
  void watch_engine(const WheelSeen& seen);
  void close_window();

  Duration standing_{};      ///< wheels turn without pulses
  Duration rest_{};          ///< the wheels do not turn
  std::uint64_t extra_ = 0;  ///< pulses in that time
  bool is_extra_ = false;

  // Pulses of a turn, over windows of some seconds.
  Duration window_{};
  std::uint64_t pulses_ = 0;
  std::uint64_t turns_ = 0;         ///< in half turns a minute by milliseconds
  std::uint64_t first_pulses_ = 0;  ///< of the first window; 0: none yet
  std::uint64_t first_turns_ = 0;
  unsigned extra_windows_ = 0;

  bool has_engine_turned_ = false;
  std::uint64_t without_engine_ = 0;  ///< pulses
  bool is_without_engine_ = false;
};

class WheelPulses {
 public:
  /// Values that were not counted, by reason.
  struct Counters {
    std::uint32_t not_valid = 0;     ///< values that were marked as not valid
    std::uint32_t out_of_range = 0;  ///< values above the overrun value
    std::uint32_t implausible = 0;   ///< values that were put aside
    std::uint32_t restarts = 0;      ///< the counter restarted or jumped
    std::uint32_t gaps = 0;          ///< too long to know how often the counter overran
  };

  /// Sets the maximum number of pulses per second of any car.
  void set_fastest(std::uint32_t pulses_a_second) { fastest_ = pulses_a_second; }
  /// Sets the highest value of the counter, which is followed by 0. While it is not known (6056h is
  /// not valid), it is FFFFh, the highest value of 6055h.
  void set_overrun_value(std::uint16_t highest);

  /// Takes a value of 6055h, and returns the pulses since the last one. "Signal not available" is
  /// from a source that restarts: the next value only sets the start of counting. With "no" or
  /// "failure", the counter may continue meanwhile: it is accepted again if it matches.
  std::uint32_t count(std::uint16_t value, Signal valid, Time now);
  /// Discards the last value: for another counter.
  void forget() { has_base_ = false; }
  /// Values that were not counted, by reason.
  const Counters& counters() const { return counters_; }

 private:
  std::uint32_t modulus() const { return highest_ + 1U; }
  /// Distance of the counter from `base`.
  std::uint32_t ahead(std::uint16_t value, std::uint16_t base) const;
  /// Maximum accepted distance; beyond it, the counter has rather gone back.
  std::uint32_t believed() const { return modulus() - modulus() / 4; }
  std::uint64_t possible(Duration time) const;
  std::uint32_t doubt(std::uint16_t value, Time now);
  void set_base(std::uint16_t value, Time now);

  std::uint32_t fastest_ = 0xFFFF'FFFF;
  std::uint16_t highest_ = 0xFFFF;
  std::uint16_t base_ = 0;
  bool has_base_ = false;
  Time base_time_{};
  std::uint16_t doubted_ = 0;  ///< the last value that was put aside
  Time doubted_time_{};
  std::uint8_t doubts_ = 0;           ///< values that continue from each other
  std::uint32_t doubted_pulses_ = 0;  ///< among them
  Counters counters_;
};

}  // namespace canvoy::cia447
