// Cuts the stream from a client into lines, in whatever pieces it arrives.
//
//     reader.append(bytes);
//     while (std::optional<Line> line = reader.next()) handle(*line);
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace canvoy::gateway {

/// A line from a client.
struct Line {
  std::string text;       ///< without its line end; the beginning of a line that is too long
  bool too_long = false;  ///< the rest was discarded
};

/// Reader of lines. Holds no more than what was appended since next() returned nothing, plus the
/// beginning of one line that is too long.
class LineReader {
 public:
  /// Makes a reader; `length_max` is as in set_length_max().
  explicit LineReader(std::size_t length_max) : length_max_(length_max) {}

  /// Appends bytes. Lines end with LF, with or without CR before it.
  void append(std::string_view bytes) { text_.append(bytes); }
  /// Returns the next whole line; nothing if its end has not arrived yet.
  std::optional<Line> next();

  /// True if next() has a line.
  bool has_line() const { return text_.find('\n', searched_) != std::string::npos; }

  /// Limits the length of a line, in characters without its end, from the next line on.
  void set_length_max(std::size_t length_max) { length_max_ = length_max; }
  /// Present limit, in characters.
  std::size_t length_max() const { return length_max_; }
  /// Characters held.
  std::size_t size() const { return text_.size(); }

 private:
  Line take(std::size_t length);
  void skip_too_long();

  std::size_t length_max_;
  std::string text_;
  std::size_t searched_ = 0;  ///< number of characters of text_ that contain no line end
  bool too_long_ = false;     ///< the rest of the current line is discarded
};

}  // namespace canvoy::gateway
