// A file of a GTFS feed as a table: its columns by their names in any order, its fields as what
// they mean. The first thing that is wrong ends it, and is told with file, line and column.
//
//     constexpr std::string_view columns[] = {"stop_id", "stop_lat"};
//     Result<Table> table = Table::open(archive, "stops.txt", columns);
//     while (table->next()) table->number(1, -90, 90);
//     if (!table->error()) ...
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

/// `20261123`.
std::optional<Date> parse_date(std::string_view text);
/// `8:05:00`, `25:35:00`, up to 239:59:59.
std::optional<TimeOfDay> parse_time(std::string_view text);
std::optional<double> parse_number(std::string_view text);

class Table {
 public:
  /// `columns` outlives this; a column is known by its position in it from now on. Those that the
  /// file does not have are empty. Errors: the file cannot be read, or has no header.
  static host::Result<Table> open(const FeedArchive& archive, std::string_view name,
                                  std::span<const std::string_view> columns);

  bool is_there() const { return file_->is_there(); }
  bool has(std::size_t column) const { return places_[column] != nowhere; }
  /// The next row; false at the end and where something is wrong.
  bool next();
  /// Of the row; from 1 on.
  std::size_t line() const { return reader_->line(); }
  /// Nothing is wrong while this is empty.
  const std::optional<host::Error>& error() const { return error_; }
  /// The row is wrong; the first one that is told counts.
  void fail(std::size_t column, const std::string& what);
  void fail_file(const std::string& what);

  /// Empty where the row or the file does not have it.
  std::string_view text(std::size_t column) const;
  /// As it can be shown: UTF-8 without control characters.
  std::string shown(std::size_t column) const;
  /// Must not be empty.
  std::string_view needed(std::size_t column);
  /// Nothing where it is empty, or wrong, which is told.
  std::optional<double> number(std::size_t column, double least, double most);
  std::optional<std::uint32_t> count(std::size_t column, std::uint32_t most);
  std::optional<Date> date(std::size_t column);
  std::optional<TimeOfDay> time(std::size_t column);

 private:
  static constexpr std::size_t nowhere = ~std::size_t{0};

  Table(FeedFile file, std::span<const std::string_view> columns);
  void read_header();
  std::string place() const;

  std::unique_ptr<FeedFile> file_;
  std::unique_ptr<CsvReader> reader_;
  std::span<const std::string_view> columns_;
  std::vector<std::size_t> places_;  ///< of each column in a row
  std::size_t width_ = 0;            ///< of the header
  std::optional<host::Error> error_;
};

}  // namespace canvoy::gtfs
