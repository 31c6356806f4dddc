// CSV with a frame a line, of python-can (`timestamp,arbitration_id,...,data` with the data as
// base64) and of SavvyCAN (`Time Stamp,ID,...,D1,...,D8`, in microseconds and hexadecimal digits).
#pragma once

#include <memory>
#include <string_view>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

/// By the names of its columns; null where they are of no CSV that is known.
std::unique_ptr<TraceParser> make_csv_parser(std::string_view header);

}  // namespace canvoy::formats
