// A message on a CAN bus for the analysis of response times: its length, its frequency, and its
// deadline.
//
//     BusMessage speed = {.id = 0x185, .bits = longest_frame_bits(8), .period = 10ms};
//     speed.deadline = speed.period;
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::timing {

/// Events `period` apart, some of which come up to `ahead` before their place in that row.
struct Burst {
  Duration period{};  ///< above zero
  Duration ahead{};   ///< 0 or more
};

/// A message. An event is a moment at which the sender has something to send. Events are `period`
/// apart in the long run. An event may come up to `ahead` before its place in that row, but no less
/// than `distance` after the one before. The frame is queued up to `jitter` after its event.
struct BusMessage {
  std::uint32_t id = 0;      ///< 11 or 29 bits
  bool is_extended = false;  ///< the identifier has 29 bits
  bool is_remote = false;    ///< a remote frame
  unsigned bits = 0;         ///< with stuff bits and the following intermission; above 0
  Duration period{};         ///< above zero
  Duration jitter{};         ///< 0 or more
  Duration ahead{};          ///< 0 or more; with the jitter not above 10^9 periods
  Duration distance{};       ///< 0: unknown
  Duration deadline{};       ///< from the event to the end of the frame, above zero
  /// More rows that the events also keep: for a burst, a row with a shorter period limits how
  /// quickly it comes.
  std::vector<Burst> bursts{};
  /// Offset from SYNC of a message with events that follow it: such messages keep these places
  /// among each other, and have neither `ahead` nor `distance` nor `bursts`. 0 to below `period`.
  std::optional<Duration> offset{};
};

/// Errors on the bus: `at_once` at the worst moment, then one more every `each`. An error costs 31
/// bits and another try of the longest frame that may take part. Zeros: no errors.
struct ErrorModel {
  std::uint32_t at_once = 0;  ///< 0 with `each`: one
  Duration each{};            ///< 0: no more errors follow
};

/// A bus with all messages on it. No two messages have the same identifier.
struct BusModel {
  std::uint32_t bit_rate = 125'000;    ///< bit/s, 1000 or more
  ErrorModel errors{};                 ///< none by default
  std::vector<BusMessage> messages{};  ///< in any order
};

/// Length of a frame in bits, with the greatest number of stuff bits and three bits of
/// intermission: 8 s + g + 13 + (g + 8 s - 1) / 4, with g = 34, or 54 for 29-bit frames. `bytes` is
/// 0 to 8; 0 for a remote frame.
constexpr unsigned longest_frame_bits(unsigned bytes, bool is_extended = false) {
  const unsigned stuffed = (is_extended ? 54 : 34) + 8 * bytes;
  return stuffed + 13 + (stuffed - 1) / 4;
}

/// Priority of a message: the lower number is sent first.
std::uint32_t priority(const BusMessage& message);

/// Share of the bus (0 and up) that the messages take in the long run, without errors.
double utilisation(const BusModel& model);

}  // namespace canvoy::timing
