// candump -l: `(1700000000.000125) can0 185#1E2F`, newer ones with ` R` or ` T` behind it; and what
// candump shows on the screen.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// `are_deltas`: on the screen, times count from the frame before.
std::unique_ptr<TraceParser> make_candump_parser(bool are_deltas = false);

}  // namespace canvoy::formats
