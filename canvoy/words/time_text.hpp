// Values of TIME_OF_DAY and TIME_DIFFERENCE as people write and read them.
//
//     time_text(TimeOfDay{.milliseconds = 43'200'000, .days = 15'665});  // 2026-11-21 12:00:00.000
//     parse_time_difference("3 d 01:02:03");
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::words {

/// `2026-11-21 12:00:00.250`; `day 15665, 90000000 ms` where the milliseconds are those of no day.
std::string time_text(const TimeOfDay& time);
/// `3 d 01:02:03.004`
std::string time_text(const TimeDifference& time);

/// The same the other way round; seconds and their fraction may be left out, and the days of a
/// difference. Nothing where it is no such time, or beyond what the type can hold.
std::optional<TimeOfDay> parse_time_of_day(std::string_view text);
std::optional<TimeDifference> parse_time_difference(std::string_view text);

}  // namespace canvoy::words
