// Frames as records of an MDF 4 file, as ASAM's bus logging names them.
#pragma once

#include <memory>
#include <optional>

#include "canvoy/formats/trace/trace_encoder.hpp"

namespace canvoy::formats {

/// `begin`: the time of the earliest frame, where it is not the first.
std::unique_ptr<TraceEncoder> make_mf4_encoder(std::optional<Time> begin);

}  // namespace canvoy::formats
