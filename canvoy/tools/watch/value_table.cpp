#include "canvoy/tools/watch/value_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr auto string_column = formats::ParquetType::text;

/// Empty where there is none.
std::string_view unit_of(const decoder::DecodedValue& value) {
  if (value.entry == nullptr || value.entry->value.unit == Unit::none) return {};
  return symbol(value.entry->value.unit);
}

/// A number without its unit, which has a column of its own; else the text.
std::string cell_value(const decoder::DecodedValue& value) {
  std::string text = text::value_text(value.entry, value.bytes());
  const std::string_view unit = unit_of(value);
  if (unit.empty()) return text;
  const std::string behind = " " + std::string(unit);
  if (text.ends_with(behind)) text.resize(text.size() - behind.size());
  return text;
}

/// What JSON has as a number, by way of `room`.
std::optional<double> number_of(const decoder::DecodedValue& value, std::string& room) {
  room.clear();
  text::append_value_json(room, value.entry, value.bytes());
  double number = 0;
  const char* const last = room.data() + room.size();
  const auto [end, error] = real_from_chars(room.data(), last, number);
  if (error != std::errc{} || end != last || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

void append_csv_cell(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

std::string_view csv_head() {
  return "time,bus,node,index,sub,name,value,unit\n";
}

void append_csv(std::string& lines, const ValueRow& row) {
  const auto& [time, bus, node, value] = row;
  const auto into = std::back_inserter(lines);
  fmt::format_to(into, "{}.{:06},", time.count() / 1'000'000, time.count() % 1'000'000);
  append_csv_cell(lines, bus);
  fmt::format_to(into, ",{},{:04X},{:02X},", node, value.index, value.sub);
  append_csv_cell(lines, text::object_name_text(value));
  lines += ',';
  append_csv_cell(lines, cell_value(value));
  lines += ',';
  append_csv_cell(lines, unit_of(value));
  lines += '\n';
}

ParquetTable::ParquetTable(const std::string& path)
    : draft_(value_or_throw(host::AtomicFile::begin(path))),
      table_({{"time", formats::ParquetType::time},
              {"bus", string_column},
              {"node", formats::ParquetType::whole},
              {"index", string_column},
              {"sub", string_column},
              {"name", string_column},
              {"value", formats::ParquetType::real},
              {"text", string_column},
              {"unit", formats::ParquetType::nullable_text}}) {}

void ParquetTable::add(const ValueRow& row) {
  const auto& [time, bus, node, value] = row;
  std::size_t at = 0;
  const auto next = [this, &at]() -> formats::ParquetColumn& { return table_.column(at++); };
  next().add(time);
  next().add(bus);
  next().add(std::int32_t{node});
  next().add(std::string_view(formats::hex(value.index, 4)));
  next().add(std::string_view(formats::hex(value.sub, 2)));
  next().add(std::string_view(text::object_name_text(value)));
  next().add(number_of(value, number_));
  next().add(std::string_view(cell_value(value)));
  const std::string_view unit = unit_of(value);
  if (unit.empty()) {
    next().add_nothing();
  } else {
    next().add(unit);
  }
  table_.end_row(bytes_);
  pass_on();
}

void ParquetTable::pass_on() {
  if (bytes_.empty()) return;
  ok_or_throw(draft_.write({reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size()}));
  bytes_.clear();
}

void ParquetTable::finish() {
  table_.finish(bytes_);
  pass_on();
  ok_or_throw(draft_.finish());
}

}  // namespace canvoy::tools
