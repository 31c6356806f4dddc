// Faults of a building with lifts as they are written: `dead-encoder@10min`,
// `lost-node:lift=2:node=6@10min+30s`, `cable-cut:group:node=2@5min`,
// `stuck-button:floor=5@1h+2min`.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/sim/lift/fault.hpp"

namespace canvoy::tools {

/// Throws UsageError, which says what would be right.
lift::ScheduledFault parse_lift_fault(std::string_view text);
std::string lift_fault_text(const lift::ScheduledFault& fault);
/// For the help of an option.
std::string lift_fault_help();

}  // namespace canvoy::tools
