// Text of values of TIME_OF_DAY and TIME_DIFFERENCE, written and read.
//
//     time_text(TimeOfDay{.milliseconds = 43'200'000, .days = 15'665});  // 2026-11-21 12:00:00.000
//     parse_time_difference("3 d 01:02:03");
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::text {

/// `2026-11-21 12:00:00.250`; `day 15665, 90000000 ms` if the milliseconds exceed a day.
std::string time_text(const TimeOfDay& time);
/// Text of a time difference: `3 d 01:02:03.004`.
std::string time_text(const TimeDifference& time);

/// Reads the text of time_text(); seconds, their fraction, and the days of a difference are
/// optional. Nothing if it is not such a time, or beyond the range of the type.
std::optional<TimeOfDay> parse_time_of_day(std::string_view text);
/// Like parse_time_of_day(), for a difference.
std::optional<TimeDifference> parse_time_difference(std::string_view text);

}  // namespace canvoy::text
