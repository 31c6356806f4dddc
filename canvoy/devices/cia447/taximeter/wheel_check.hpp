// Checks wheel pulses (6055h) against other data: the rpm of the wheels (6053h), accurate to 1 %
// from 3 km/h on and at most 500 ms late (CiA 447-3, 4.2.4.4), and of the engine (6050h).
//
//     WheelCheck check;
//     const bool counts = check.take({.turned = 8, .since = 100ms, .half_rpm = 0, .k = 24'000});
//     if (check.has_extra_pulses()) ...
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"

namespace canvoy::cia447 {

/// A count, with the accompanying data.
struct WheelSeen {
  std::uint32_t turned = 0;               ///< pulses
  Duration since{};                       ///< time since the last count
  std::optional<unsigned> half_rpm = {};  ///< 6053h: in 0,5/min; nothing: not available
  std::optional<unsigned> engine = {};    ///< 6050h: in 1/min
  std::uint32_t k = 1;                    ///< pulses for a distance unit
};

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

}  // namespace canvoy::cia447
