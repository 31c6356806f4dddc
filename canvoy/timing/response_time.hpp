// The worst-case response times of all messages of a CAN bus, by the revised analysis of Davis,
// Burns, Bril and Lukkien ("Controller Area Network (CAN) schedulability analysis: Refuted,
// revisited and revised", Real-Time Systems 35, 2007): all instances in the busy period of a
// message's priority count, and each may be blocked by the longest frame of lower priority. Each
// node has to send what it has in the order of priorities.
//
//     for (const Response& each : response_times(model)) show(each.time, each.meets_deadline);
//
// Beyond the paper: bursts (BusMessage::ahead, distance), and places behind SYNC, for which each
// message behind SYNC is tried as the one that begins the busy period with its jitter at its full
// length (Palencia and Gonzalez Harbour, "Schedulability analysis for tasks with static and dynamic
// offsets", RTSS 1998). Where their common period has too many of them, places are not used, which
// is safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

/// Of results: bits do not take whole microseconds.
using Nanoseconds = std::chrono::nanoseconds;

/// Of one message.
struct Response {
  /// False: the bus has more to carry than it can, or the busy period has no end within
  /// busy_period_max, or looks_max looks. Then `time`, `first` and `instances` say nothing.
  bool is_bounded = false;
  bool meets_deadline = false;  ///< there is a bound, and it is not above the deadline
  /// From the event to the end of the frame's intermission, when the bus is free again. Receivers
  /// have the frame four bits before.
  Nanoseconds time{};
  Nanoseconds first{};          ///< of the first instance in the busy period alone
  Nanoseconds blocking{};       ///< by the longest frame of lower priority
  std::uint32_t instances = 0;  ///< in the busy period
};

/// As far as busy periods are followed.
inline constexpr Nanoseconds busy_period_max = std::chrono::hours(1);
/// Of the iteration, for each message: how often another one's share is looked at.
inline constexpr std::uint64_t looks_max = 1'000'000;
/// Instances behind SYNC until all of its messages begin anew.
inline constexpr std::size_t places_max = 512;

/// Of each message, in the order of the model. Takes some steps for each pair of messages.
std::vector<Response> response_times(const BusModel& model);

/// Whether all messages have a bound, and none is late. Ends at the first that does not.
bool meets_all(const BusModel& model);

/// What bits take, rounded up to a nanosecond.
Nanoseconds wire_time(std::uint64_t bits, std::uint32_t bit_rate);

}  // namespace canvoy::timing
