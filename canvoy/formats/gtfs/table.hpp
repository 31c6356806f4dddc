// A file of a GTFS feed as a table: columns by name in any order, fields by meaning. The first
// error ends reading, and is reported with file, line and column.
//
//     constexpr std::string_view columns[] = {"stop_id", "stop_lat"};
//     host::Result<Table> table = Table::open(archive, "stops.txt", columns);
//     while (table->next()) table->number(1, -90, 90);
//     if (table->error()) return fail(table->error()->line());
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/result.hpp"
#include "canvoy/formats/gtfs/csv_reader.hpp"
#include "canvoy/formats/gtfs/feed.hpp"
#include "canvoy/formats/gtfs/feed_archive.hpp"

namespace canvoy::gtfs {

/// Reads a date, such as `20261123`.
std::optional<Date> parse_date(std::string_view text);
/// Reads a time, such as `8:05:00` or `25:35:00`, up to 239:59:59.
std::optional<TimeOfDay> parse_time(std::string_view text);
/// Reads a decimal number, with fraction and exponent if it has them; all of the text, and finite.
std::optional<double> parse_number(std::string_view text);

class Table {
 public:
  /// Opens a file. `columns` must outlive this; a column is identified by its position in it.
  /// Columns that the file does not have are empty. Errors: the file cannot be read, or has no
  /// header.
  static host::Result<Table> open(const FeedArchive& archive, std::string_view name,
                                  std::span<const std::string_view> columns);

  /// False for a file that the feed does not have: it reads as one without rows.
  bool is_there() const { return file_->is_there(); }
  /// True if the file has the column.
  bool has(std::size_t column) const { return places_[column] != nowhere; }
  /// Reads the next row. False at the end, and after an error.
  bool next();
  /// Line of the row, from 1.
  std::size_t line() const { return reader_->line(); }
  /// The first error, if any.
  const std::optional<host::Error>& error() const { return error_; }
  /// Reports an error in the row; the first one is kept.
  void fail(std::size_t column, const std::string& what);
  /// Reports an error of the file as a whole; the first one is kept.
  void fail_file(const std::string& what);

  /// Text of a field; empty if the row or the file does not have it.
  std::string_view text(std::size_t column) const;
  /// Text of a field for display: UTF-8 in one line, with runs of blanks and line ends as one
  /// blank, and without characters that control, or have no width. Text that is not UTF-8 is an
  /// error.
  std::string shown(std::size_t column);
  /// True if the field is UTF-8; else reports an error.
  bool check_utf8(std::size_t column);
  /// Text of a field that must not be empty.
  std::string_view needed(std::size_t column);
  /// The number in a field; nothing if it is empty, or wrong, which is reported.
  std::optional<double> number(std::size_t column, double least, double most);
  /// The whole number in a field, 0 to `most`; nothing if it is empty, or wrong, which is reported.
  std::optional<std::uint32_t> count(std::size_t column, std::uint32_t most);
  /// The date in a field; nothing if it is empty, or wrong, which is reported.
  std::optional<Date> date(std::size_t column);
  /// The time in a field; nothing if it is empty, or wrong, which is reported.
  std::optional<TimeOfDay> time(std::size_t column);

 private:
  static constexpr std::size_t nowhere = ~std::size_t{0};

  Table(FeedFile file, std::span<const std::string_view> columns);
  void read_header();
  std::string place() const;

  std::unique_ptr<FeedFile> file_;
  std::unique_ptr<CsvReader> reader_;
  std::span<const std::string_view> columns_;
  std::vector<std::size_t> places_;  ///< position of each column in a row
  std::size_t width_ = 0;            ///< number of columns of the header
  std::optional<host::Error> error_;
};

}  // namespace canvoy::gtfs
