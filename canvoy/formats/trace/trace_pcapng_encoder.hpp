// Writes frames as packets of pcapng, little-endian, in microseconds; a channel is an interface,
// described before its first frame.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_encoder.hpp"

namespace canvoy::formats {

/// Makes an encoder.
std::unique_ptr<TraceEncoder> make_pcapng_encoder();

}  // namespace canvoy::formats
