// Cuts what comes from a client into lines, however it was cut on the way.
//
//     reader.append(bytes);
//     while (std::optional<Line> line = reader.next()) handle(*line);
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace canvoy::gateway {

struct Line {
  std::string text;       ///< without its end; of a line that is too long, its beginning
  bool too_long = false;  ///< the rest was thrown away
};

/// It holds no more than was appended since next() answered nothing, and the beginning of one line
/// that is too long.
class LineReader {
 public:
  explicit LineReader(std::size_t length_max) : length_max_(length_max) {}

  /// Lines end with LF, with or without CR before it.
  void append(std::string_view bytes) { text_.append(bytes); }
  /// The next whole line; nothing where its end has not come yet.
  std::optional<Line> next();

  /// Whether next() has a line.
  bool has_line() const { return text_.find('\n', searched_) != std::string::npos; }

  /// From the next line on: characters without the end of the line.
  void set_length_max(std::size_t length_max) { length_max_ = length_max; }
  std::size_t length_max() const { return length_max_; }
  std::size_t size() const { return text_.size(); }

 private:
  Line take(std::size_t length);
  void skip_too_long();

  std::size_t length_max_;
  std::string text_;
  std::size_t searched_ = 0;  ///< so many characters of text_ are no end of a line
  bool too_long_ = false;     ///< the rest of the present line is not kept
};

}  // namespace canvoy::gateway
