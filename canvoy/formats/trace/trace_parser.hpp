// Interface between TraceReader and a format: a parser receives the next bytes and takes one
// record, a line or a block, from their front.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_file.hpp"

namespace canvoy::formats {

/// Size of the buffer of a reader, several times the longest record of any format.
inline constexpr std::size_t trace_buffer_size = 256 * 1024;
inline constexpr std::size_t trace_record_max = 64 * 1024;  ///< bytes of the longest block
inline constexpr std::size_t trace_line_max = 4096;         ///< characters of the longest line

/// What a record is.
enum class TraceItem : std::uint8_t {
  frame,
  fd,  ///< TraceFrame::fd has its content
  note,
  bad,
  remainder,  ///< of a record that was already told of
  more,       ///< more bytes have to be shown than these, which are less than trace_record_max
  end,        ///< of a format that is read from any place: nothing follows
};

/// The record at the front. `taken` may be more than the given bytes: what follows is skipped.
struct TraceStep {
  TraceItem item = TraceItem::more;  ///< kind of the record
  std::uint64_t taken = 0;           ///< bytes of the record
  std::string_view problem;          ///< static text, if it is bad
};

/// A record without a frame.
inline constexpr TraceStep trace_note{TraceItem::note, 0, {}};

/// A record that cannot be read; `problem` is static text.
constexpr TraceStep bad_record(std::string_view problem) {
  return {TraceItem::bad, 0, problem};
}

class TraceParser {
 public:
  virtual ~TraceParser() = default;
  /// Its row in the table of formats.
  virtual const TraceFormat& format() const = 0;
  /// True for lines of text: positions are then given by line.
  virtual bool has_lines() const = 0;
  /// Takes one record. `bytes` are not empty; `last`: the file ends with them.
  virtual TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) = 0;

  /// Whether it is a TraceFileParser.
  virtual bool seeks() const { return false; }
};

/// A format whose records stand anywhere in the file.
class TraceFileParser : public TraceParser {
 public:
  bool has_lines() const final { return false; }
  bool seeks() const final { return true; }
  TraceStep step(std::string_view, bool, TraceFrame& frame) final { return read(frame); }

  /// Before all others. What is wrong with the file as a whole; `name` is how errors call it.
  virtual host::Result<void> open(TraceFile file, const std::string& name) = 0;
  /// The next record; `taken` is not looked at.
  virtual TraceStep read(TraceFrame& frame) = 0;
  /// Where the latest was read: "row 12".
  virtual std::string where() const = 0;
  /// Bytes of the file that are done with, about.
  virtual std::uint64_t position() const = 0;
};

/// Parser of a line format: a line longer than trace_line_max is bad, and skipped in pieces.
class TraceLineParser : public TraceParser {
 public:
  bool has_lines() const override { return true; }
  TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) final;

 protected:
  enum class Behind : std::uint8_t { nothing, end_of_line };
  /// `behind`: what may be read after each line; a TraceScanner needs an end of line.
  explicit TraceLineParser(Behind behind = Behind::nothing) : behind_(behind) {}

  /// Reads a line without its end. `taken` of the result is ignored.
  virtual TraceStep read_line(std::string_view line, TraceFrame& frame) = 0;

 private:
  TraceStep read_whole_line(std::string_view line, std::uint64_t taken, TraceFrame& frame);

  Behind behind_;
  bool in_long_line_ = false;
  std::string last_line_;  ///< of a file without a final end of line
};

}  // namespace canvoy::formats
