// Vector ASC: `   3.098426 1  18EBFF00x       Rx d 8 01 A0 0F A6 60 3B D1 40`, behind a header that
// says when it began, in which base its numbers are, and whether times count from the line before.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceParser> make_asc_parser();

}  // namespace canvoy::formats
