#include "canvoy/tools/watch/live_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/terminal/screen.hpp"

namespace canvoy::tools {

namespace {

constexpr double microseconds_per_second = 1e6;

std::string live_value(const EntryInfo* entry, std::span<const std::uint8_t> bytes) {
  std::string text;
  text::append_value_text(text, entry, bytes);
  return text;
}

double live_seconds(Duration duration) {
  return static_cast<double>(duration.count()) / microseconds_per_second;
}

/// In five columns: `120ms`, `12.3s`, `4.5min`, `12h`.
std::string age_text(Duration age) {
  const double seconds = live_seconds(age);
  if (seconds < 1) return fmt::format("{:.0f}ms", seconds * 1000);
  if (seconds < 100) return fmt::format("{:.1f}s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f}min", seconds / 60);
  return fmt::format("{:.0f}h", seconds / 3600);
}

std::string rate_text(double rate) {
  if (rate <= 0) return "";
  constexpr double with_places_max = 9.995;  // what would be rounded to 10.00
  return rate < with_places_max ? fmt::format("{:.2f}/s", rate) : fmt::format("{:.0f}/s", rate);
}

/// Separates identifiers of 11 and of 29 bits and error frames, but not data and remote frames.
std::uint32_t place_of(const Frame& frame) {
  constexpr unsigned extended_bit = 29;
  constexpr unsigned error_bit = 30;
  return frame.id | std::uint32_t{frame.is_extended()} << extended_bit |
         std::uint32_t{frame.is_error()} << error_bit;
}

/// `18A`, `0000018A`, `20000040`: the part before the sign of candump.
std::string can_id_text(const Frame& frame) {
  const FrameText text(frame);
  return std::string(text.view().substr(0, text.view().find('#')));
}

std::string lower(std::string_view text) {
  std::string made(text);
  std::ranges::transform(made, made.begin(), [](char each) {
    return each >= 'A' && each <= 'Z' ? static_cast<char>(each + 32) : each;
  });
  return made;
}

/// Columns of the table beside name and value.
constexpr std::size_t place_columns = 13;
constexpr std::size_t age_columns = 7;
constexpr std::size_t rate_columns = 8;
constexpr std::size_t bus_columns = 7;
constexpr std::string_view title_of_values = "value";

}  // namespace

std::string_view LiveTable::name_of(Sort sort) {
  constexpr std::array<std::string_view, sort_count> names = {"place", "name", "age", "rate",
                                                              "change"};
  return names.at(static_cast<std::size_t>(sort));
}

LiveTable::Row* LiveTable::row_at(const Key& key) {
  const auto found = rows_.find(key);
  if (found != rows_.end()) return &found->second;
  is_full_ = is_full_ || rows_.size() >= rows_max;
  return rows_.size() >= rows_max ? nullptr : &rows_[key];
}

void LiveTable::count(Row& row, Duration time, bool has_changed) {
  if (row.count > 0) row.recurrence.take(live_seconds(time - row.time));
  if (has_changed || row.count == 0) row.changed = time;
  row.time = time;
  ++row.count;
}

void LiveTable::take(Duration time, std::string_view bus, const Frame& frame,
                     const text::FrameWords& words) {
  if (first_bus_.empty()) first_bus_ = bus;
  has_buses_ = has_buses_ || bus != first_bus_;
  if (by_ == By::object && !words.values.empty()) {
    for (const decoder::DecodedValue& value : words.values)
      take_value(time, bus, frame, words, value);
    return;
  }
  wanted_.bus.assign(bus);
  wanted_.object = 0;
  wanted_.place = by_ == By::frame ? place_of(frame) : words.node;
  wanted_.service.assign(by_ == By::object ? words.service : std::string_view());
  take_text(time, wanted_, frame, words);
}

void LiveTable::take_value(Duration time, std::string_view bus, const Frame& frame,
                           const text::FrameWords& words, const decoder::DecodedValue& value) {
  wanted_.bus.assign(bus);
  wanted_.place = words.node;
  wanted_.object = std::uint32_t{value.index} << 8 | value.sub;
  wanted_.service.clear();
  Row* row = row_at(wanted_);
  if (row == nullptr) return;
  const std::span<const std::uint8_t> bytes = value.bytes();
  bool has_changed = false;
  if (bytes.size() > value.mapped.size()) {
    const std::string text = live_value(value.entry, bytes);
    has_changed = text != row->text;
    row->text = text;
    row->value.reset();
  } else {
    has_changed = !row->value || !std::ranges::equal(row->value->bytes(), bytes);
    if (has_changed || row->value->entry != value.entry) {
      row->value = value;
      std::ranges::copy(bytes, row->value->mapped.begin());
      row->value->size = static_cast<std::uint8_t>(bytes.size());
      row->value->transferred = {};
    }
  }
  row->node = words.node;
  if (row->id.empty()) row->id = can_id_text(frame);
  if (row->text.empty() && !row->value) row->text = live_value(value.entry, bytes);
  if (row->service.empty()) row->service = text::object_name_text(value);
  count(*row, time, has_changed);
}

void LiveTable::take_text(Duration time, Key key, const Frame& frame,
                          const text::FrameWords& words) {
  Row* row = row_at(key);
  if (row == nullptr) return;
  bool has_changed = false;
  if (!words.text.empty() || words.service.empty()) {
    has_changed = row->text != words.text;
    if (has_changed) row->text = words.text;
  } else {
    const FrameText text(frame);
    has_changed = row->text != text.view();
    if (has_changed) row->text = text.view();
  }
  row->node = words.node;
  if (row->id.empty()) row->id = can_id_text(frame);
  if (row->service != words.service) row->service = words.service;
  count(*row, time, has_changed);
}

/// The mean of the last seconds and of several intervals, so that bursts have no higher rate at
/// their ends.
void LiveTable::Recurrence::take(double interval_s) {
  constexpr double span_max_s = 2;
  constexpr double intervals_max = 16;
  intervals_ += 1;
  span_s_ += interval_s;
  pause_s_ = std::max(pause_s_, interval_s);
  if (span_s_ < span_max_s || intervals_ < intervals_max) return;
  intervals_ /= 2;
  span_s_ /= 2;
  pause_s_ /= 2;
}

/// If nothing has come for half a second, the time since the last one counts as well: two adjacent
/// frames are not thousands per second.
double LiveTable::Recurrence::rate(double age_s) const {
  constexpr double patience_s = 0.5;
  if (intervals_ == 0) return 0;
  if (span_s_ < patience_s) return intervals_ / std::max(span_s_ + age_s, 1e-6);
  const double mean = intervals_ / span_s_;
  return age_s > std::max(patience_s, pause_s_) ? std::min(mean, 1 / age_s) : mean;
}

bool LiveTable::Recurrence::is_overdue(double age_s) const {
  constexpr double pauses = 3;
  constexpr double least_s = 2;
  constexpr double once_s = 10;
  return age_s > (pause_s_ == 0 ? once_s : std::max(least_s, pauses * pause_s_));
}

double LiveTable::rate(const Row& row, Duration now) {
  return row.recurrence.rate(live_seconds(now - row.time));
}

std::vector<LiveTable::Shown> LiveTable::chosen(const View& view) const {
  std::vector<Shown> shown;
  const std::string wanted = lower(view.search);
  for (const auto& [key, row] : rows_) {
    Shown each = {&key, &row, row.service, {}};
    each.value = row.value ? live_value(row.value->entry, row.value->bytes()) : row.text;
    const bool is_wanted = wanted.empty() || lower(each.name).find(wanted) != std::string::npos ||
                           lower(each.value).find(wanted) != std::string::npos ||
                           lower(place_text(each)).find(wanted) != std::string::npos;
    if (is_wanted) shown.push_back(std::move(each));
  }
  sort(shown, view);
  return shown;
}

void LiveTable::sort(std::vector<Shown>& shown, const View& view) {
  const auto by = [&](const auto& key) { std::ranges::stable_sort(shown, {}, key); };
  switch (view.sort) {
    case Sort::place:
      break;
    case Sort::name:
      by([](const Shown& each) { return each.name; });
      break;
    case Sort::age:
      by([](const Shown& each) { return -each.row->time; });
      break;
    case Sort::rate:
      by([&](const Shown& each) { return -rate(*each.row, view.now); });
      break;
    case Sort::change:
      by([](const Shown& each) { return -each.row->changed; });
      break;
  }
  if (view.is_reversed) std::ranges::reverse(shown);
}

std::string LiveTable::place_text(const Shown& shown) const {
  const Row& row = *shown.row;
  const std::string node = row.node == 0 ? "-" : fmt::format("{}", row.node);
  if (by_ == By::frame) return fmt::format("{:<8}{:>4}", row.id, node);
  if (by_ == By::node || shown.key->object == 0) return fmt::format("{:>3}", node);
  return fmt::format("{:>3} {:04X}:{:02X}", node, shown.key->object >> 8,
                     shown.key->object & 0xFFU);
}

/// Names have as many columns as the longest one needs, up to two fifths of the rest on a terminal.
LiveTable::Widths LiveTable::widths(const std::vector<Shown>& rows, const View& view) const {
  const std::size_t fixed =
      place_columns + age_columns + rate_columns + (has_buses_ ? bus_columns : 0);
  Widths needed = {.name = title_of_names().size() + 1, .value = title_of_values.size() + 1};
  for (const Shown& each : rows) {
    needed.name = std::max(needed.name, columns_of(each.name) + 1);
    needed.value = std::max(needed.value, columns_of(each.value));
  }
  if (view.columns == View::as_needed) return needed;
  const std::size_t rest = view.columns > fixed ? view.columns - fixed : 0;
  const std::size_t name = std::min(needed.name, rest * 2 / 5);
  return {.name = name, .value = rest - name};
}

std::string_view LiveTable::title_of_names() const {
  return by_ == By::object ? "name" : "service";
}

std::string LiveTable::head(const Widths& widths) const {
  constexpr std::array<std::string_view, 3> places = {"node object", "id      node", "node"};
  std::string line = has_buses_ ? in_columns("bus", bus_columns) : std::string();
  line += in_columns(places.at(static_cast<std::size_t>(by_)), place_columns);
  line += in_columns(title_of_names(), widths.name) + in_columns(title_of_values, widths.value);
  return line + in_columns("    age", age_columns) + in_columns("    rate", rate_columns);
}

void LiveTable::append_row(std::vector<std::string>& lines, const Shown& shown,
                           const Widths& widths, const View& view) const {
  const Row& row = *shown.row;
  const std::size_t name_room = widths.name > 1 ? widths.name - 1 : 0;
  const std::vector<std::string> names = in_lines(shown.name, name_room);
  const std::vector<std::string> values = in_lines(shown.value, widths.value);
  const bool is_marked = view.has_marks && row.count > 1 && view.now - row.changed < change_span;
  const bool is_faint =
      view.has_marks && row.recurrence.is_overdue(live_seconds(view.now - row.time));
  std::string place = has_buses_
                          ? in_columns(formats::plain_text(shown.key->bus), bus_columns - 1) + ' '
                          : std::string();
  place += in_columns(place_text(shown), place_columns - 1) + ' ';
  std::string numbers =
      fmt::format("{:>7}{:>8}", age_text(view.now - row.time), rate_text(rate(row, view.now)));
  // Without room for names or values there is one line.
  const std::size_t count =
      std::max(name_room > 0 ? names.size() : 1, widths.value > 0 ? values.size() : 1);
  for (std::size_t i = 0; i < count && lines.size() < view.rows; ++i) {
    std::string line = place;
    if (name_room > 0) line += in_columns(i < names.size() ? names[i] : "", name_room) + ' ';
    const std::string value = in_columns(i < values.size() ? values[i] : "", widths.value);
    line += is_marked && i < values.size() ? "\x1b[7m" + value + "\x1b[27m" : value;
    line += numbers;
    lines.push_back(is_faint ? "\x1b[2m" + line + "\x1b[22m" : line);
    place.assign(columns_of(place), ' ');
    numbers.assign(numbers.size(), ' ');
  }
}

std::vector<std::string> LiveTable::lines(const View& view) const {
  const std::vector<Shown> rows = chosen(view);
  const Widths widths = this->widths(rows, view);
  std::vector<std::string> lines = {head(widths)};
  if (view.columns != View::as_needed) lines.front() = in_columns(lines.front(), view.columns);
  for (std::size_t i = view.first; i < rows.size() && lines.size() < view.rows; ++i) {
    append_row(lines, rows[i], widths, view);
  }
  return lines;
}

std::size_t LiveTable::page(const View& view) const {
  const std::vector<Shown> rows = chosen(view);
  const Widths widths = this->widths(rows, view);
  View rest = view;
  std::size_t count = 0;
  for (std::size_t i = view.first; i < rows.size(); ++i, ++count) {
    std::vector<std::string> lines;
    append_row(lines, rows[i], widths, rest);
    if (lines.size() + 1 >= rest.rows) break;
    rest.rows -= lines.size();
  }
  return count;
}

std::string LiveTable::json(Duration now) const {
  std::string text;
  for (const auto& [key, row] : rows_) {
    text::JsonLine json(text);
    json.begin_object();
    json.key("bus").text(formats::plain_text(key.bus));
    if (row.node != 0) json.key("node").number(std::int64_t{row.node});
    if (by_ == By::frame) json.key("can_id").text(row.id);
    if (key.object != 0) {
      append_index(json, static_cast<std::uint16_t>(key.object >> 8),
                   static_cast<std::uint8_t>(key.object));
    }
    json.key(key.object != 0 ? "name" : "service").text(row.service);
    if (row.value) {
      json.key("value");
      text::append_value_json(text, row.value->entry, row.value->bytes());
      const bool has_unit =
          row.value->entry != nullptr && row.value->entry->value.unit != Unit::none;
      if (has_unit) json.key("unit").text(symbol(row.value->entry->value.unit));
    } else {
      json.key("text").text(formats::plain_text(row.text));
    }
    json.key("age_s").number(live_seconds(now - row.time));
    json.key("rate_hz").number(rate(row, now));
    json.key("count").number(static_cast<std::int64_t>(row.count));
    json.end_object();
    text += '\n';
  }
  return text;
}

}  // namespace canvoy::tools
