// SYNC: its period, and whether two devices send it (CiA 301, 7.2.5).
//
//     SyncWatch syncs;
//     syncs.hear(time, frame, known.sync_period());
//     syncs.period();  // 100 ms
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/text/doctor/heartbeat_watch.hpp"
#include "canvoy/text/doctor/tally.hpp"

namespace canvoy::text {

class SyncWatch {
 public:
  /// Takes a data frame with the CAN-ID of SYNC. `expected`: 1006h of its producer, if known.
  void hear(Time at, const Frame& frame, std::optional<Duration> expected);

  /// Number and times of the SYNCs.
  const Tally& heard() const { return heard_; }
  /// CAN-ID of the last SYNC.
  std::uint16_t can_id() const { return can_id_; }
  /// Median of the last intervals; zero: too few.
  Duration period() const;
  /// Two producers in alternation, each in its own rhythm; nothing: one.
  const std::optional<TwoRhythms>& rhythms() const { return rhythm_.found(); }
  /// Counters (1019h) that do not follow the previous one, without a cause for a reset.
  const Tally& jumps() const { return jumps_; }

 private:
  void hear_counter(Time at, const Frame& frame);

  static constexpr std::size_t intervals_max = 32;

  Tally heard_;
  Tally jumps_;
  RhythmWatch rhythm_;
  std::array<Duration, intervals_max> intervals_{};
  std::size_t intervals_heard_ = 0;
  std::uint16_t can_id_ = 0;
  std::uint8_t counter_ = 0;  ///< of the last SYNC; 0: none
};

}  // namespace canvoy::text
