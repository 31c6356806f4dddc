// pcapng: blocks of sections, interfaces and packets. Packets are read from enhanced packet blocks
// (type 6), which all programs write today; simple ones have no time, and are passed over.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceParser> make_pcapng_parser();

}  // namespace canvoy::formats
