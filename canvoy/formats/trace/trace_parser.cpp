#include "canvoy/formats/trace/trace_parser.hpp"

#include <algorithm>

#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

TraceStep TraceLineParser::step(std::string_view bytes, bool last, TraceFrame& frame) {
  const std::size_t end = bytes.find('\n');
  const bool whole = end != std::string_view::npos || last;
  if (!whole && bytes.size() < trace_record_max && !in_long_line_) return {};
  std::string_view line = bytes.substr(0, end);
  const std::size_t taken = std::min(line.size() + 1, bytes.size());
  if (in_long_line_) {
    in_long_line_ = !whole;
    return {TraceItem::remainder, taken, {}};
  }
  in_long_line_ = !whole;
  if (line.size() > trace_line_max)
    return {TraceItem::bad, taken, "it is longer than 4096 characters"};
  if (end == std::string_view::npos && behind_ == Behind::end_of_line) {
    last_line_.assign(line).append(1, '\n');
    line = std::string_view(last_line_).substr(0, line.size());
  }
  if (line.ends_with('\r')) line.remove_suffix(1);
  return read_whole_line(line, taken, frame);
}

// A separate function, so that the result of read_line() is constructed in place: a copy would wait
// for it.
TraceStep TraceLineParser::read_whole_line(std::string_view line, std::uint64_t taken,
                                           TraceFrame& frame) {
  TraceStep step = read_line(line, frame);
  step.taken = taken;
  return step;
}

}  // namespace canvoy::formats
