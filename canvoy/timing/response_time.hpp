// The worst-case response times of all messages of a CAN bus, by the revised analysis of Davis,
// Burns, Bril and Lukkien ("Controller Area Network (CAN) schedulability analysis: Refuted,
// revisited and revised", Real-Time Systems 35, 2007): all instances in the busy period of a
// message's priority count, and each may be blocked by the longest frame of lower priority. Each
// node must send its frames in the order of priorities.
//
//     for (const Response& each : response_times(model)) show(each.time, each.meets_deadline);
//
// Beyond the paper: bursts (BusMessage::ahead, distance), and places behind SYNC. For these, each
// message behind SYNC is tried as the one that begins the busy period with its full jitter
// (Palencia and Gonzalez Harbour, "Schedulability analysis for tasks with static and dynamic
// offsets", RTSS 1998). If the common period of these messages has too many places, they are not
// used, which is safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "canvoy/timing/bus_message.hpp"

namespace canvoy::timing {

/// Unit of results: bits do not take whole microseconds.
using Nanoseconds = std::chrono::nanoseconds;

/// Result for one message.
struct Response {
  /// False if the bus has more to carry than it can, if the busy period has no end within
  /// busy_period_max, or if the search exceeds looks_max. Then `time`, `first` and `instances` are
  /// meaningless.
  bool is_bounded = false;
  bool meets_deadline = false;  ///< there is a bound, and it does not exceed the deadline
  /// Time from the event to the end of the frame's intermission, when the bus is free again.
  /// Receivers have the frame four bits before.
  Nanoseconds time{};
  Nanoseconds first{};          ///< response time of the first instance in the busy period alone
  Nanoseconds blocking{};       ///< blocking by the longest frame of lower priority
  std::uint32_t instances = 0;  ///< number in the busy period
};

/// Limit of the busy periods that are examined.
inline constexpr Nanoseconds busy_period_max = std::chrono::hours(1);
/// Limit of the iteration for each message: evaluations of the share of another message.
inline constexpr std::uint64_t looks_max = 1'000'000;
/// Limit of instances behind SYNC until all of its messages begin again.
inline constexpr std::size_t places_max = 512;

/// Response time of each message, in the order of the model. Takes some steps for each pair of
/// messages.
std::vector<Response> response_times(const BusModel& model);

/// True if all messages have a bound and none is late. Ends at the first that fails.
bool meets_all(const BusModel& model);

/// Duration of bits, rounded up to a nanosecond.
Nanoseconds wire_time(std::uint64_t bits, std::uint32_t bit_rate);

}  // namespace canvoy::timing
