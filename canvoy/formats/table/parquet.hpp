// Tables as Apache Parquet files, which pandas, Polars, DuckDB and Spark read: columns one behind
// another, in groups of rows, compressed by gzip. Written from front to back; of what was written
// only where it stands is kept.
//
//     ParquetWriter table({{"time", ParquetType::time}, {"name", ParquetType::text}});
//     table.column(0).add(since_1970);
//     table.column(1).add(std::string_view("temperature"));
//     table.end_row(bytes);      // appends what is full
//     table.finish(bytes);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::formats {

/// Of the values of a column.
enum class ParquetType : std::uint8_t {
  time,   ///< microseconds since 1970, in UTC
  whole,  ///< of 32 bits
  real,   ///< of 64 bits, or nothing
  text,   ///< in UTF-8
  nullable_text,
};

/// What is kept of a column until its rows are written.
class ParquetColumn {
 public:
  /// `name` as readers call it.
  ParquetColumn(std::string_view name, ParquetType type) : name_(name), type_(type) {}

  /// As it was given.
  const std::string& name() const { return name_; }
  /// As it was given.
  ParquetType type() const { return type_; }
  /// Whether rows may have nothing.
  bool is_nullable() const {
    return type_ == ParquetType::real || type_ == ParquetType::nullable_text;
  }

  /// One of these for each row, as the type asks for.
  void add(Duration since_1970) { append(static_cast<std::uint64_t>(since_1970.count()), 8); }
  /// Of a column of whole numbers.
  void add(std::int32_t number) { append(static_cast<std::uint32_t>(number), 4); }
  /// Of a column of real numbers: nothing, where there is none.
  void add(std::optional<double> number);
  /// Of a column of texts.
  void add(std::string_view text);
  /// Of a nullable text.
  void add_nothing() { is_there_.push_back(false); }

  /// The rows so far as a page; nothing is kept of them.
  std::string take_page();

 private:
  void append(std::uint64_t value, unsigned size);

  std::string name_;
  ParquetType type_;
  std::string values_;
  std::vector<bool> is_there_;  ///< of a type that is nullable
};

/// Needs the memory of one group, and some 70 bytes a column for each that was written.
class ParquetWriter {
 public:
  static constexpr std::uint32_t rows_max = 64 * 1024;  ///< of a group

  /// At least one column.
  explicit ParquetWriter(std::vector<ParquetColumn> columns) : columns_(std::move(columns)) {}

  /// From 0 on; beyond the last it throws.
  ParquetColumn& column(std::size_t number) { return columns_.at(number); }
  /// Behind the last column of each row. Bytes of the file are appended to `file`.
  void end_row(std::string& file);
  /// The end of the file; nothing is written behind it.
  void finish(std::string& file);
  /// Ended so far.
  std::uint64_t rows() const { return rows_ + rows_here_; }

 private:
  void begin(std::string& file);
  void write_group(std::string& file);

  std::vector<ParquetColumn> columns_;
  std::uint64_t at_ = 0;  ///< bytes of the file so far
  std::uint64_t rows_ = 0;
  std::uint32_t rows_here_ = 0;  ///< of the group
  std::uint64_t groups_ = 0;
  std::string group_list_;  ///< what the end of the file says of them
};

}  // namespace canvoy::formats
