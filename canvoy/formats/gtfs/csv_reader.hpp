// Reads a file of comma-separated values as used by GTFS (RFC 4180), row by row, in bounded memory.
//
//     CsvReader reader(file);
//     while (reader.next() == CsvRead::row) use(reader.fields(), reader.line());
//     if (!reader.problem().empty()) ...    // what is wrong with line reader.line()
//
// Accepts a byte order mark, either kind of line ends, blanks around fields, empty lines, and a
// last line without an end. A quotation mark within a text that does not begin with one is an
// ordinary character, as real feeds have it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/gtfs/feed_archive.hpp"

namespace canvoy::gtfs {

/// Outcome of a read: a row, the end of the file, or an error.
enum class CsvRead : std::uint8_t { row, end, bad };

class CsvReader {
 public:
  /// Maximum size of a row in bytes, so that a missing quotation mark does not take in the rest of
  /// the file.
  static constexpr std::size_t row_bytes_max = 65'536;

  /// Reads from the present position of `file`, which must outlive this.
  explicit CsvReader(FeedFile& file) : file_(&file) {}

  /// Reads the next row. Nothing follows after `end` and `bad`.
  CsvRead next();
  /// Fields of the row, without quotation marks; valid until the next call.
  std::span<const std::string_view> fields() const { return fields_; }
  /// Line on which the row or the error begins, from 1.
  std::size_t line() const { return line_; }
  /// What is wrong with the row; empty while all is well.
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
  std::size_t begin_ = 0;  ///< start of what is not yet read
  std::string_view row_;
  std::string unquoted_;  ///< fields of the row that were quoted
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
  std::size_t next_line_ = 1;
  std::string problem_;
  bool is_begun_ = false;
  bool is_all_here_ = false;  ///< the buffer contains the end of the file
  bool has_quotes_ = false;   ///< the row has quotation marks
  bool is_over_ = false;
};

}  // namespace canvoy::gtfs
