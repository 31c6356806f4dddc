#include "canvoy/tools/cli/toml_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

namespace {

toml::table parsed(const std::string& path, std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw Failure(
        fmt::format("{} line {}: {}", path, error.source().begin.line, error.description()));
  }
}

bool within(double number, Range<double> range) {
  return number >= range.least && number <= range.most;
}

}  // namespace

toml::table parse_toml_file(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  return parsed(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

TomlFile::TomlFile(std::string path)
    : path_(std::move(path)), content_(parse_toml_file(path_)), table_(path_, content_) {}

TomlFile::TomlFile(std::string name, std::string_view text)
    : path_(std::move(name)), content_(parsed(path_, text)), table_(path_, content_) {}

const toml::node* TomlTable::find(std::string_view key) {
  known_.emplace_back(key);
  return table_->get(key);
}

void TomlTable::refuse(std::string_view key, std::string_view what) const {
  const toml::node* node = table_->get(key);
  const auto line = (node != nullptr ? node->source() : table_->source()).begin.line;
  throw Failure(fmt::format("{} line {}: {}: {}", *path_, line, key, what));
}

void TomlTable::refuse(std::string_view what) const {
  throw Failure(fmt::format("{} line {}: {}", *path_, table_->source().begin.line, what));
}

/// Texts of a file are shown, and must not control the terminal.
void TomlTable::refuse_control(std::string_view key, std::string_view text) const {
  if (formats::is_plain_text(text)) return;
  refuse(key, fmt::format("'{}' has control characters", formats::plain_text(text)));
}

void TomlTable::take(std::string_view key, std::string& to) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  if (text == nullptr) refuse(key, "write a text in quotes");
  refuse_control(key, text->get());
  to = text->get();
}

void TomlTable::take(std::string_view key, bool& to) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto* truth = node->as_boolean();
  if (truth == nullptr) refuse(key, "write true or false");
  to = truth->get();
}

void TomlTable::take(std::string_view key, double& to, Range<double> range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::optional<double> number = node->value<double>();
  if (!node->is_number() || !number) refuse(key, "write a number");
  if (!within(*number, range)) {
    refuse(key, fmt::format("{} is not from {} to {}", *number, range.least, range.most));
  }
  to = *number;
}

void TomlTable::take_integer(std::string_view key, std::uint64_t& to, Range<std::uint64_t> range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto* number = node->as_integer();
  if (number == nullptr) refuse(key, "write a whole number");
  const std::int64_t value = number->get();
  if (value < 0 || static_cast<std::uint64_t>(value) < range.least ||
      static_cast<std::uint64_t>(value) > range.most) {
    refuse(key, fmt::format("{} is not from {} to {}", value, range.least, range.most));
  }
  to = static_cast<std::uint64_t>(value);
}

void TomlTable::take(std::string_view key, Duration& to, Duration least) {
  std::string text;
  if (!has(key)) return static_cast<void>(find(key));
  take(key, text);
  const std::optional<Duration> duration = parse_duration(text);
  if (!duration || *duration < least) {
    refuse(key, fmt::format(R"('{}' is no time: write a number and {}, as "30s" or "8h")", text,
                            duration_units));
  }
  to = *duration;
}

void TomlTable::take(std::string_view key, CivilTime& to) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto* moment = node->as_date_time();
  if (moment == nullptr) refuse(key, "write date and time, as 2026-11-21T18:00:00");
  const toml::date_time& value = moment->get();
  using namespace std::chrono;  // NOLINT(google-build-using-namespace): units and calendar
  const year_month_day date{year{value.date.year}, month{value.date.month}, day{value.date.day}};
  if (!date.ok() || date < year{1984} / January / 1) refuse(key, "write a date from 1984 on");
  to = sys_days{date} + hours{value.time.hour} + minutes{value.time.minute} +
       seconds{value.time.second} + milliseconds{value.time.nanosecond / 1'000'000};
}

void TomlTable::take(std::string_view key, std::vector<std::string>& to) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr) refuse(key, R"(write a list of texts, as ["a", "b"])");
  to.clear();
  for (const toml::node& each : *array) {
    const auto* text = each.as_string();
    if (text == nullptr) refuse(key, R"(write a list of texts, as ["a", "b"])");
    refuse_control(key, text->get());
    to.push_back(text->get());
  }
}

void TomlTable::take(std::string_view key, std::vector<double>& to, Range<double> range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr) refuse(key, "write a list of numbers, as [0, 3.5]");
  to.clear();
  for (const toml::node& each : *array) {
    const std::optional<double> number = each.value<double>();
    if (!each.is_number() || !number) refuse(key, "write a list of numbers, as [0, 3.5]");
    if (!within(*number, range)) {
      refuse(key, fmt::format("{} is not from {} to {}", *number, range.least, range.most));
    }
    to.push_back(*number);
  }
}

TomlTable TomlTable::table(std::string_view key) {
  static const toml::table empty;
  const toml::node* node = find(key);
  if (node == nullptr) return {*path_, empty};
  const toml::table* table = node->as_table();
  if (table == nullptr) refuse(key, fmt::format("write a table, as [{}]", key));
  return {*path_, *table};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  const toml::node* node = find(key);
  std::vector<TomlTable> all;
  if (node == nullptr) return all;
  const toml::array* array = node->as_array();
  if (array == nullptr || !array->is_array_of_tables()) {
    refuse(key, fmt::format("write tables, as [[{}]]", key));
  }
  for (const toml::node& each : *array) all.emplace_back(*path_, *each.as_table());
  return all;
}

void TomlTable::finish() const {
  for (const auto& [key, value] : *table_) {
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    refuse(key.str(), fmt::format("is not known here; there are {}", fmt::join(known_, ", ")));
  }
}

}  // namespace canvoy::tools
