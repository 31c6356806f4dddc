// TOML files, read strictly: values of the wrong type, out of range or unknown are reported with
// their line.
//
//     TomlFile file("network.toml");
//     TomlTable& table = file.table();
//     table.take("seed", options.seed);
//     for (TomlTable& node : table.tables("node")) node.take("id", id, {1, 127}), node.finish();
//     table.finish();
#pragma once

#include <toml++/toml.h>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line.
toml::table parse_toml_file(const std::string& path);

/// A range, inclusive.
template <class Number>
struct Range {
  Number least = std::numeric_limits<Number>::lowest();
  Number most = std::numeric_limits<Number>::max();
};

/// A table of a file. A missing key leaves the target unchanged. All functions throw Failure with
/// file and line.
class TomlTable {
 public:
  TomlTable(const std::string& path, const toml::table& table) : path_(&path), table_(&table) {}

  bool has(std::string_view key) const { return table_->contains(key); }

  void take(std::string_view key, std::string& to);
  void take(std::string_view key, bool& to);
  void take(std::string_view key, double& to, Range<double> range = {});
  /// Reads a duration such as `30s`, from `least` on.
  void take(std::string_view key, Duration& to, Duration least = Duration{1});
  /// Reads a local date and time of TOML, from 1984 on.
  void take(std::string_view key, CivilTime& to);
  void take(std::string_view key, std::vector<std::string>& to);
  void take(std::string_view key, std::vector<double>& to, Range<double> range = {});
  template <std::unsigned_integral Number>
    requires(!std::same_as<Number, bool>)
  void take(std::string_view key, Number& to, Range<Number> range = {}) {
    std::uint64_t number = to;
    take_integer(key, number, {range.least, range.most});
    to = static_cast<Number>(number);
  }

  /// `[key]`, or an empty table if it is missing.
  TomlTable table(std::string_view key);
  /// All of `[[key]]`.
  std::vector<TomlTable> tables(std::string_view key);

  /// Refuses keys that were not read.
  void finish() const;
  /// Throws: `FILE line N: KEY: what`.
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const;
  /// Throws for the table as a whole.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  const toml::node* find(std::string_view key);
  void refuse_control(std::string_view key, std::string_view text) const;
  void take_integer(std::string_view key, std::uint64_t& to, Range<std::uint64_t> range);

  const std::string* path_;
  const toml::table* table_;
  std::vector<std::string> known_;
};

class TomlFile {
 public:
  explicit TomlFile(std::string path);
  /// Parses a text that is not in a file; `name` is used in errors.
  TomlFile(std::string name, std::string_view text);
  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;

  TomlTable& table() { return table_; }

 private:
  std::string path_;
  toml::table content_;
  TomlTable table_;
};

}  // namespace canvoy::tools
