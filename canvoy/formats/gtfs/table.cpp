#include "canvoy/formats/gtfs/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/plain_text.hpp"

namespace canvoy::gtfs {

namespace {

using host::Error;
using host::Result;

constexpr unsigned hours_max = 239;
constexpr std::size_t quoted_max = 40;

/// The whole text as digits.
std::optional<unsigned> whole(std::string_view digits) {
  unsigned value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, problem] = std::from_chars(digits.data(), end, value);
  if (digits.empty() || problem != std::errc{} || rest != end) return std::nullopt;
  return value;
}

/// A field in the form of a message.
std::string quoted(std::string_view text) {
  const bool is_long = text.size() > quoted_max;
  return "'" + formats::plain_text(text.substr(0, quoted_max)) + (is_long ? "...'" : "'");
}

std::optional<std::uint8_t> first_not_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = formats::utf8_length(text);
    if (length == 0) return static_cast<std::uint8_t>(text.front());
    text.remove_prefix(length);
  }
  return std::nullopt;
}

/// Number of bytes of a leading blank, tab or line end, including those of Unicode; 0: none.
std::size_t blank_length(std::string_view text) {
  constexpr std::string_view blanks[] = {" ",  "\t",       "\r",           "\n",          "\v",
                                         "\f", "\xC2\x85", "\xE2\x80\xA8", "\xE2\x80\xA9"};
  const auto* const found = std::ranges::find_if(
      blanks, [text](std::string_view blank) { return text.starts_with(blank); });
  return found == std::end(blanks) ? 0 : found->size();
}

/// Number of bytes of a leading character without a shape: one that controls, or that has no
/// width or only a direction; 0: none. U+200C and U+200D shape letters and pictures beside them.
std::size_t hidden_length(std::string_view text) {
  constexpr unsigned char first_visible = 0x20;
  constexpr unsigned char delete_character = 0x7F;
  const auto first_byte = static_cast<unsigned char>(text.front());
  if (first_byte < first_visible || first_byte == delete_character) return 1;
  const std::size_t length = formats::utf8_length(text);
  const auto is_between = [&text, length](std::string_view first, std::string_view last) {
    return length == first.size() && text.substr(0, length) >= first &&
           text.substr(0, length) <= last;
  };
  const bool is_hidden =
      is_between("\xC2\x80", "\xC2\x9F") || is_between("\xC2\xAD", "\xC2\xAD") ||
      is_between("\xE2\x80\x8B", "\xE2\x80\x8B") || is_between("\xE2\x80\x8E", "\xE2\x80\x8F") ||
      is_between("\xE2\x80\xAA", "\xE2\x80\xAE") || is_between("\xE2\x81\xA0", "\xE2\x81\xAF") ||
      is_between("\xEF\xBB\xBF", "\xEF\xBB\xBF");
  return is_hidden ? length : 0;
}

std::string in_one_line(std::string_view text) {
  std::string line;
  bool has_blank = false;
  while (!text.empty()) {
    const std::size_t blank = blank_length(text);
    const std::size_t hidden = blank == 0 ? hidden_length(text) : 0;
    has_blank = has_blank || blank != 0;
    if (blank == 0 && hidden == 0) {
      if (has_blank && !line.empty()) line += ' ';
      has_blank = false;
      line += text.front();
    }
    text.remove_prefix(std::max<std::size_t>(blank + hidden, 1));
  }
  return line;
}

}  // namespace

std::optional<Date> parse_date(std::string_view text) {
  if (text.size() != 8) return std::nullopt;
  const std::optional<unsigned> number = whole(text);
  if (!number) return std::nullopt;
  const Date date{std::chrono::year(static_cast<int>(*number / 10'000)),
                  std::chrono::month(*number / 100 % 100), std::chrono::day(*number % 100)};
  if (!date.ok()) return std::nullopt;
  return date;
}

std::optional<TimeOfDay> parse_time(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.size() != colon + 6 || text[colon + 3] != ':') {
    return std::nullopt;
  }
  const std::optional<unsigned> hours = whole(text.substr(0, colon));
  const std::optional<unsigned> minutes = whole(text.substr(colon + 1, 2));
  const std::optional<unsigned> seconds = whole(text.substr(colon + 4));
  if (!hours || !minutes || !seconds) return std::nullopt;
  if (*hours > hours_max || *minutes > 59 || *seconds > 59) return std::nullopt;
  return std::chrono::hours(*hours) + std::chrono::minutes(*minutes) +
         std::chrono::seconds(*seconds);
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, problem] = real_from_chars(text.data(), end, value);
  if (problem != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

Table::Table(FeedFile file, std::span<const std::string_view> columns)
    : file_(std::make_unique<FeedFile>(std::move(file))),
      reader_(std::make_unique<CsvReader>(*file_)),
      columns_(columns),
      places_(columns.size(), nowhere) {}

Result<Table> Table::open(const FeedArchive& archive, std::string_view name,
                          std::span<const std::string_view> columns) {
  Result<FeedFile> file = archive.file(name);
  if (!file) return file.error();
  Table table(*std::move(file), columns);
  if (table.is_there()) table.read_header();
  if (table.error_) return *table.error_;
  return table;
}

void Table::read_header() {
  const CsvRead read = reader_->next();
  if (read == CsvRead::bad) return fail_file(reader_->problem());
  if (read == CsvRead::end) return fail_file("empty; the names of its columns are missing");
  const auto fields = reader_->fields();
  width_ = fields.size();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto found = std::find(fields.begin(), fields.end(), columns_[i]);
    if (found == fields.end()) continue;
    places_[i] = static_cast<std::size_t>(found - fields.begin());
    if (std::find(found + 1, fields.end(), columns_[i]) != fields.end()) {
      return fail(i, "the column is there twice");
    }
  }
}

std::string Table::place() const {
  return fmt::format("{} line {}", file_->name(), reader_->line());
}

void Table::fail(std::size_t column, const std::string& what) {
  if (!error_) error_ = Error{place(), fmt::format("{}: {}", columns_[column], what), {}};
}

void Table::fail_file(const std::string& what) {
  if (!error_) error_ = Error{place(), what, {}};
}

bool Table::next() {
  if (error_ || !is_there()) return false;
  const CsvRead read = reader_->next();
  if (read == CsvRead::bad) fail_file(reader_->problem());
  if (read != CsvRead::row) return false;
  const auto fields = reader_->fields();
  // Some tools end each line with a comma.
  for (std::size_t i = width_; i < fields.size(); ++i) {
    if (fields[i].empty()) continue;
    fail_file(
        fmt::format("{} fields, and {} columns; is a text with commas without quotation "
                    "marks?",
                    fields.size(), width_));
    return false;
  }
  return true;
}

std::string_view Table::text(std::size_t column) const {
  const auto fields = reader_->fields();
  const std::size_t place = places_[column];
  return place < fields.size() ? fields[place] : std::string_view{};
}

bool Table::check_utf8(std::size_t column) {
  const std::optional<std::uint8_t> wrong = first_not_utf8(text(column));
  if (!wrong) return true;
  fail(column,
       fmt::format("{} has the byte {:02X}h, which is no UTF-8 there; save the file as UTF-8",
                   quoted(text(column)), *wrong));
  return false;
}

std::string Table::shown(std::size_t column) {
  return check_utf8(column) ? formats::plain_text(in_one_line(text(column))) : std::string();
}

std::string_view Table::needed(std::size_t column) {
  const std::string_view value = text(column);
  if (value.empty()) fail(column, has(column) ? "empty" : "the column is missing");
  return value;
}

std::optional<double> Table::number(std::size_t column, double least, double most) {
  const std::string_view value = text(column);
  if (value.empty()) return std::nullopt;
  const std::optional<double> parsed = parse_number(value);
  if (parsed && *parsed >= least && *parsed <= most) return parsed;
  fail(column, fmt::format("{} is no number from {} to {}", quoted(value), least, most));
  return std::nullopt;
}

std::optional<std::uint32_t> Table::count(std::size_t column, std::uint32_t most) {
  const std::string_view value = text(column);
  if (value.empty()) return std::nullopt;
  const std::optional<unsigned> parsed = whole(value);
  if (parsed && *parsed <= most) return parsed;
  fail(column, fmt::format("{} is no whole number from 0 to {}", quoted(value), most));
  return std::nullopt;
}

std::optional<Date> Table::date(std::size_t column) {
  const std::string_view value = text(column);
  if (value.empty()) return std::nullopt;
  const std::optional<Date> parsed = parse_date(value);
  if (!parsed) fail(column, quoted(value) + " is no date as 20261123");
  return parsed;
}

std::optional<TimeOfDay> Table::time(std::size_t column) {
  const std::string_view value = text(column);
  if (value.empty()) return std::nullopt;
  const std::optional<TimeOfDay> parsed = parse_time(value);
  if (!parsed) fail(column, quoted(value) + " is no time as 08:05:00");
  return parsed;
}

}  // namespace canvoy::gtfs
