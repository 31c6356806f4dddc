// Result of `canvoy load` for a bus: the response time of each message, and the margin to the first
// late message.
//
//     const LoadResult result = result_of(bus);
//     fmt::print("{}", table_text(bus, result));
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canvoy/timing/breakdown.hpp"
#include "canvoy/timing/response_time.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"

namespace canvoy::tools {

struct LoadResult {
  std::vector<timing::Response> responses{};  ///< in the order of the messages of the bus
  double load = 0;                            ///< bus load, as heard or planned
  double worst = 0;                           ///< with the maximum number of stuff bits
  std::optional<timing::Breakdown> breakdown{};
  std::size_t late = 0;  ///< number of messages that miss their deadline, or have no bound
};

/// Indices of the messages of a bus, highest priority first.
std::vector<std::size_t> by_priority(const LoadedBus& bus);

/// Throws UsageError if the bit rate is unknown.
LoadResult result_of(const LoadedBus& bus);

/// Tables of 80 columns: messages by priority, nodes and services by load.
std::string table_text(const LoadedBus& bus, const LoadResult& result);
/// JSON Lines: an object for each message, node and service, and one for the bus.
std::string json_text(const LoadedBus& bus, const LoadResult& result);
/// An SVG image: the longest response of each message beside its deadline.
std::string picture_text(const std::vector<LoadedBus>& buses,
                         const std::vector<LoadResult>& results);

}  // namespace canvoy::tools
