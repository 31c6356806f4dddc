// PEAK TRC 1.0 to 2.1: `      1     17535.400 DT 1  00000100 Tx -  8    00 11 22 33 44 55 66 77`. A
// version is an order of columns; from 2.0 on the file names them itself, by letters.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceParser> make_trc_parser();

}  // namespace canvoy::formats
