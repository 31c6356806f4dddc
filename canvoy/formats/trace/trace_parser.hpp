// How TraceReader sees a format: a parser is shown the bytes that come next and takes one record,
// a line or a block, from their front.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats {

/// A reader's buffer holds the longest record of any format several times.
inline constexpr std::size_t trace_buffer_size = 256 * 1024;
inline constexpr std::size_t trace_record_max = 64 * 1024;
inline constexpr std::size_t trace_line_max = 4096;

enum class TraceItem : std::uint8_t {
  frame,
  fd,  ///< TraceFrame::fd has what is told of it
  note,
  bad,
  remainder,  ///< of a record that was already told of
  more,       ///< more bytes have to be shown than these, which are less than trace_record_max
};

/// What stood at the front. `taken` may be more than was shown: what follows is passed over.
struct TraceStep {
  TraceItem item = TraceItem::more;
  std::uint64_t taken = 0;
  std::string_view problem;
};

/// It says nothing of frames.
inline constexpr TraceStep trace_note{TraceItem::note, 0, {}};

constexpr TraceStep bad_record(std::string_view problem) {
  return {TraceItem::bad, 0, problem};
}

class TraceParser {
 public:
  virtual ~TraceParser() = default;
  virtual const TraceFormat& format() const = 0;
  virtual bool has_lines() const = 0;
  /// `bytes` are not empty; `last` says that the file ends with them.
  virtual TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) = 0;
};

/// A format of lines: a line longer than trace_line_max is bad, and passed over in pieces.
class TraceLineParser : public TraceParser {
 public:
  bool has_lines() const override { return true; }
  TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) final;

 protected:
  enum class Behind : std::uint8_t { nothing, end_of_line };
  /// What may be read behind each line: a TraceScanner needs an end of line there.
  explicit TraceLineParser(Behind behind = Behind::nothing) : behind_(behind) {}

  /// `line` has no end of line. `taken` of what is returned is not looked at.
  virtual TraceStep read_line(std::string_view line, TraceFrame& frame) = 0;

 private:
  TraceStep read_whole_line(std::string_view line, std::uint64_t taken, TraceFrame& frame);

  Behind behind_;
  bool in_long_line_ = false;
  std::string last_line_;  ///< of a file that ends without an end of line
};

}  // namespace canvoy::formats
