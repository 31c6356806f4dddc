#include "canvoy/tools/session/log_source.hpp"

#include "canvoy/formats/trace/trace_format.hpp"

namespace canvoy::tools {

namespace {

/// `tcp:HOST:PORT/can0` has a slash as well, after the kind of the bus.
bool names_a_file(std::string_view source) {
  const std::size_t slash = source.find('/');
  return slash != std::string_view::npos &&
         source.substr(0, slash).find(':') == std::string_view::npos;
}

}  // namespace

bool is_log_source(std::string_view source) {
  return source == "-" || names_a_file(source) || formats::names_trace(source);
}

}  // namespace canvoy::tools
