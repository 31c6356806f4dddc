// Reads a file of comma-separated values as GTFS has them (RFC 4180), row by row, in bounded
// memory.
//
//     CsvReader reader(file);
//     while (reader.next() == CsvRead::row) use(reader.fields(), reader.line());
//     if (!reader.problem().empty()) ...    // what is wrong with line reader.line()
//
// A byte order mark, either kind of line ends, blanks around fields, empty lines and a last line
// without an end do not matter. A quotation mark within a text that does not begin with one is a
// character like any other, as feeds in life have it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/gtfs/feed_archive.hpp"

namespace canvoy::gtfs {

enum class CsvRead : std::uint8_t { row, end, bad };

class CsvReader {
 public:
  /// What a row may have, in bytes: a quotation mark that is missing must not take in the file.
  static constexpr std::size_t row_bytes_max = 65'536;

  explicit CsvReader(FeedFile& file) : file_(&file) {}

  /// After `end` and `bad` nothing follows.
  CsvRead next();
  /// Of the row, without quotation marks; valid until the next call.
  std::span<const std::string_view> fields() const { return fields_; }
  /// On which the row begins, or what is bad; from 1 on.
  std::size_t line() const { return line_; }
  const std::string& problem() const { return problem_; }

 private:
  bool refill();
  bool begin_file();
  bool find_row();
  std::size_t quoted_row_end(std::size_t from);
  bool split_plain(std::string_view row);
  bool split_quoted(std::string_view row);
  bool take_quoted(std::string_view& rest);
  CsvRead bad(std::string what);

  FeedFile* file_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what has not been read
  std::string_view row_;
  std::string unquoted_;  ///< fields of the row that had quotation marks
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
  std::size_t next_line_ = 1;
  std::string problem_;
  bool is_begun_ = false;
  bool is_all_here_ = false;  ///< the buffer has the end of the file
  bool has_quotes_ = false;   ///< the row
  bool is_over_ = false;
};

}  // namespace canvoy::gtfs
