// Writes frames as objects of Vector BLF, in containers compressed by zlib.
#pragma once

#include <memory>
#include <optional>

#include "canvoy/formats/trace/trace_encoder.hpp"

namespace canvoy::formats {

/// Makes an encoder; `begin` is the start of measurement, otherwise that of the first frame.
std::unique_ptr<TraceEncoder> make_blf_encoder(std::optional<Time> begin);

}  // namespace canvoy::formats
