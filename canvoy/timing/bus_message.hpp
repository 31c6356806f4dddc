// A message on a CAN bus as the analysis of response times sees it: how long it is, how often it
// comes, and by when it has to be there.
//
//     BusMessage speed = {.id = 0x185, .bits = longest_frame_bits(8), .period = 10ms};
//     speed.deadline = speed.period;
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::timing {

/// Events that are `period` apart, of which some come up to `ahead` before their place in that row.
struct Burst {
  Duration period{};  ///< above zero
  Duration ahead{};   ///< 0 or more
};

/// What an event of a message is: a moment at which its sender has something to tell. Events are
/// `period` apart in the long run. One may be up to `ahead` before its place in that row, but comes
/// no less than `distance` after the one before. The frame is queued up to `jitter` behind its
/// event.
struct BusMessage {
  std::uint32_t id = 0;      ///< 11 or 29 bits
  bool is_extended = false;  ///< the identifier has 29 bits
  bool is_remote = false;    ///< a remote frame
  unsigned bits = 0;         ///< with stuff bits and the intermission behind it; above 0
  Duration period{};         ///< above zero
  Duration jitter{};         ///< 0 or more
  Duration ahead{};          ///< 0 or more; with the jitter not above 10^9 periods
  Duration distance{};       ///< 0: none is known
  Duration deadline{};       ///< from the event to the end of the frame, above zero
  /// More such rows, in which the events stand as well: of a burst, a row with a shorter period
  /// says how quickly it comes.
  std::vector<Burst> bursts{};
  /// From SYNC, of messages whose events follow it: those keep these places among each other, and
  /// have neither `ahead` nor `distance` nor `bursts`. 0 to below `period`.
  std::optional<Duration> offset{};
};

/// Errors on the bus: `at_once` when it matters most, then one more each `each`. An error costs 31
/// bits and another try of the longest frame that may take part. Zeros: none.
struct ErrorModel {
  std::uint32_t at_once = 0;  ///< 0 with `each`: one
  Duration each{};            ///< 0: no more follow
};

/// A bus, and all that is sent on it. No two messages have the same identifier.
struct BusModel {
  std::uint32_t bit_rate = 125'000;    ///< bit/s, 1000 or more
  ErrorModel errors{};                 ///< none, unless said
  std::vector<BusMessage> messages{};  ///< in any order
};

/// Bits of a frame with as many stuff bits as can be, and three of intermission: 8 s + g + 13 +
/// (g + 8 s - 1) / 4, with g = 34, or 54 of 29-bit frames. `bytes` is 0 to 8; 0 of a remote frame.
constexpr unsigned longest_frame_bits(unsigned bytes, bool is_extended = false) {
  const unsigned stuffed = (is_extended ? 54 : 34) + 8 * bytes;
  return stuffed + 13 + (stuffed - 1) / 4;
}

/// Of two messages, the one with the lower number is sent first.
std::uint32_t priority(const BusMessage& message);

/// The share of the bus (0 and up) that the messages take in the long run, without errors.
double utilisation(const BusModel& model);

}  // namespace canvoy::timing
