// What `canvoy load` says of a bus: the response of each message, and how far the bus is from its
// first message that is late.
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
  std::vector<timing::Response> responses{};  ///< of the bus's messages, in their order
  double load = 0;                            ///< share of the bus, as heard or planned
  double worst = 0;                           ///< with as many stuff bits as can be
  std::optional<timing::Breakdown> breakdown{};
  std::size_t late = 0;  ///< messages that miss their deadline, or have no bound
};

/// The places of a bus's messages, the highest priority first.
std::vector<std::size_t> by_priority(const LoadedBus& bus);

/// Throws UsageError where the bit rate is not known.
LoadResult result_of(const LoadedBus& bus);

/// Tables for people, of 80 columns: messages by their priority, nodes and services by their load.
std::string table_text(const LoadedBus& bus, const LoadResult& result);
/// An object for each message, node and service, and one for the bus; a line each.
std::string json_text(const LoadedBus& bus, const LoadResult& result);
/// A picture as SVG: of each message its longest response beside its deadline.
std::string picture_text(const std::vector<LoadedBus>& buses,
                         const std::vector<LoadResult>& results);

}  // namespace canvoy::tools
