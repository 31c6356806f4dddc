// How TraceWriter sees a format: an encoder appends the bytes of a frame.
#pragma once

#include <algorithm>
#include <cstdint>
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

  /// Frames that are earlier than what the format can say.
  std::uint64_t early() const { return early_; }

 protected:
  /// The time, or `first` where it is before that.
  Duration time_from(const TraceFrame& frame, Duration first) {
    const Duration time = frame.time.time_since_epoch();
    if (time < first) ++early_;
    return std::max(time, first);
  }

 private:
  std::uint64_t early_ = 0;
};

}  // namespace canvoy::formats
