// A report in HTML without scripts: verdicts and statistics in sentences, curves with the faults,
// events, nodes, load and values.
//
//     page.replace(mark, report_text(report_json(source)));
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace canvoy::tools {

/// Elements of the body of the page, from report_json().
std::string report_text(const nlohmann::ordered_json& report);

/// Words for a key of a summary: `Waiting, longest` and `s` for `longest_s` below `waiting`.
struct StatisticWords {
  std::string name;
  std::string_view unit;
};
StatisticWords statistic_words(std::string_view before, std::string_view key);

/// Time of a run: `1:02:03.4`; of a bus or a log with the time of day `2023-11-14 22:13:20.1 UTC`.
std::string report_time_text(double seconds);

}  // namespace canvoy::tools
