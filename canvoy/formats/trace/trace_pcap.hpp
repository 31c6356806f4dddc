// Classic pcap: a header of 24 bytes, then packets behind 16 bytes each of time and lengths.
#pragma once

#include <memory>

#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

std::unique_ptr<TraceParser> make_pcap_parser(bool big_endian, bool nanoseconds);

}  // namespace canvoy::formats
