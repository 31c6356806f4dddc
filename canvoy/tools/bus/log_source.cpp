#include "canvoy/tools/bus/log_source.hpp"

#include "canvoy/formats/trace_writer.hpp"

namespace canvoy::tools {

bool is_log_source(std::string_view source) {
  if (source.starts_with("tcp:")) return false;
  return source == "-" || source.find('/') != std::string_view::npos ||
         formats::trace_format_of(source).has_value();
}

}  // namespace canvoy::tools
