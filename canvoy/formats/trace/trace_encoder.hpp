// Interface between TraceWriter and a format: an encoder appends the bytes of a frame.
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
  /// Appends the start of a file, also of a file without frames.
  virtual void begin(std::string&) {}
  /// Appends a frame. Formats without comments ignore `comment`.
  virtual void append(std::string& bytes, const TraceFrame& frame, std::string_view comment) = 0;
  /// Appends the end of a file.
  virtual void end(std::string&) {}
  /// Bytes that replace those at the start when all is written, if the file is seekable; called
  /// after end().
  virtual std::string final_header() const { return {}; }
  /// Whether it is a TraceFileEncoder.
  virtual bool seeks() const { return false; }

  /// Number of frames earlier than the format can represent.
  std::uint64_t early() const { return early_; }
  /// Number of frames later than the format can represent.
  std::uint64_t late() const { return late_; }

 protected:
  /// The time of the frame, limited to `first` and `last`.
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

/// A format that is written at any place of the file, by itself.
class TraceFileEncoder : public TraceEncoder {
 public:
  bool seeks() const final { return true; }
  /// A frame goes to write(): no bytes are appended.
  void append(std::string&, const TraceFrame& frame, std::string_view) final { write(frame); }
  void end(std::string&) final { finish(); }

  /// Before all others: an empty file. `name` is how errors call it.
  virtual host::Result<void> open(const std::string& path, const std::string& name) = 0;
  /// A frame; what goes wrong, problem() says.
  virtual void write(const TraceFrame& frame) = 0;
  /// What was written so far reaches the file.
  virtual void flush() = 0;
  /// Nothing is written behind it.
  virtual void finish() = 0;
  /// Bytes in the file.
  virtual std::uint64_t size() const = 0;
  /// What has failed first; empty where nothing has.
  virtual std::string_view problem() const = 0;
};

/// Of formats that count from a beginning: the second of the first frame, or of `begin`.
class TraceStart {
 public:
  /// `begin`: the earliest time, where it is known before.
  explicit TraceStart(std::optional<Time> begin) : begin_(begin) {}

  /// Whether set() was called.
  bool is_known() const { return start_.has_value(); }
  /// Since 1970, in whole seconds; only where it is known.
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
