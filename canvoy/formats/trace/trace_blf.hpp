// Vector BLF: a header that says when it began, then objects behind `LOBJ`, most of them within
// containers that zlib has compressed. An object may begin in one container and end in the next.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceParser> make_blf_parser();

}  // namespace canvoy::formats
