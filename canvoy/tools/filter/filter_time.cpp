#include "canvoy/tools/filter/filter_time.hpp"

#include <chrono>
#include <string>

#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/time_text.hpp"

namespace canvoy::tools {

std::optional<FilterTime> parse_filter_time(std::string_view text) {
  if (const auto span = parse_duration(text)) return FilterTime{*span, true};
  // As in a line, but with a unit added.
  if (const auto seconds = parse_duration(std::string(text) + "s")) {
    return FilterTime{*seconds, false};
  }
  const auto day = text::parse_time_of_day(text);
  if (!day) return std::nullopt;
  const auto since_1970 = std::chrono::sys_days(time_of_day_epoch).time_since_epoch();
  return FilterTime{Duration(since_1970) + std::chrono::days(day->days) +
                        std::chrono::milliseconds(day->milliseconds),
                    false};
}

}  // namespace canvoy::tools
