// Frames as lines of candump -l and of Vector ASC.
#pragma once

#include <memory>
#include <optional>

#include "canvoy/formats/trace/trace_encoder.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceEncoder> make_candump_encoder();
/// It begins in the second of its first frame, or of `begin`.
std::unique_ptr<TraceEncoder> make_asc_encoder(std::optional<Time> begin);

}  // namespace canvoy::formats
