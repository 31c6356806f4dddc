// Frames as lines of candump -l and of Vector ASC.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_encoder.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceEncoder> make_candump_encoder();
std::unique_ptr<TraceEncoder> make_asc_encoder();

}  // namespace canvoy::formats
