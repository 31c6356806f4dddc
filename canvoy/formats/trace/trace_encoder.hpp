// How TraceWriter sees a format: an encoder appends the bytes of a frame.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats {

class TraceEncoder {
 public:
  virtual ~TraceEncoder() = default;
  /// What stands at the beginning of a file, also of one without frames.
  virtual void begin(std::string&) {}
  virtual void append(std::string& bytes, const TraceFrame& frame, std::string_view comment) = 0;
};

}  // namespace canvoy::formats
