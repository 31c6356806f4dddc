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
  /// What stands at the end of a file.
  virtual void end(std::string&) {}
  /// Bytes that replace those at the beginning when all was written, where the file can be written
  /// there; behind end().
  virtual std::string final_header() const { return {}; }

  /// Frames that are earlier than what the format can say.
  std::uint64_t early() const { return early_; }
  /// Frames that are later.
  std::uint64_t late() const { return late_; }

 protected:
  /// The time, or `first` where it is before that, or `last` where it is behind.
  Duration time_from(const TraceFrame& frame, Duration first,
                     Duration last = trace_time_max.time_since_epoch()) {
    const Duration time = frame.time.time_since_epoch();
    if (time < first) ++early_;
    if (time > last) ++late_;
    return std::clamp(time, first, std::max(first, last));
  }

 private:
  std::uint64_t early_ = 0;
  std::uint64_t late_ = 0;
};

/// Of formats that count from a beginning: the second of the first frame, or of `begin`.
class TraceStart {
 public:
  explicit TraceStart(std::optional<Time> begin) : begin_(begin) {}

  bool is_known() const { return start_.has_value(); }
  Duration value() const { return *start_; }
  /// Whole seconds since 1970.
  void set(const TraceFrame& first) {
    const Duration time = std::clamp(begin_.value_or(first.time).time_since_epoch(), Duration{},
                                     trace_time_max.time_since_epoch());
    start_ = std::chrono::floor<std::chrono::seconds>(time);
  }

 private:
  std::optional<Time> begin_;
  std::optional<Duration> start_;
};

}  // namespace canvoy::formats
