// The values of frames as rows of a table: as CSV for spreadsheets, as Parquet for pandas and
// others.
//
//     append_csv(lines, {time, "can0", node, value});
//     ParquetTable table("values.parquet");
//     table.add({time, "can0", node, value});
//     table.finish();
#pragma once

#include <string>
#include <string_view>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/formats/table/parquet.hpp"

namespace canvoy::tools {

/// A value, and where it was heard.
struct ValueRow {
  Duration time;         ///< since 1970
  std::string_view bus;  ///< as a terminal can show it
  NodeId node;
  const decoder::DecodedValue& value;
};

/// The line of the names of the columns, with its end.
std::string_view csv_head();
/// A cell as RFC 4180 has it, in quotes where it needs them.
void append_csv_cell(std::string& line, std::string_view text);
/// A line of RFC 4180, with its end.
void append_csv(std::string& lines, const ValueRow& row);

/// A file that takes the place of the one before when it is whole. Its columns are those of CSV,
/// but `value` is a number, in `unit`, or nothing, and `text` what CSV has as the value. Throws
/// Failure where it cannot be written.
class ParquetTable {
 public:
  explicit ParquetTable(const std::string& path);
  void add(const ValueRow& row);
  void finish();

 private:
  void pass_on();

  host::AtomicFile draft_;
  formats::ParquetWriter table_;
  std::string bytes_;
  std::string number_;
};

}  // namespace canvoy::tools
