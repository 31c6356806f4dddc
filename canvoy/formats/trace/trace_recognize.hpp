// Which format a file has shows how it begins.
#pragma once

#include <memory>
#include <string_view>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// The format of a file that begins with `head`, and a parser for it; null where none is known.
std::unique_ptr<TraceParser> recognize_trace(std::string_view head);

/// What a file of no known format that begins with `head` may be: "a JPEG picture".
std::string_view looks_like(std::string_view head);

}  // namespace canvoy::formats
