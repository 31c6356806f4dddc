#include "canvoy/tools/watch/monitor_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/tools/terminal/typing.hpp"

namespace canvoy::tools {

namespace {

constexpr std::int64_t ns_per_us = 1000;
constexpr std::int64_t ns_per_s = 1'000'000'000;

}  // namespace

// The head

/// Frames that arrive together were sent one after the other.
void BusTraffic::add(Duration time, const Frame& frame) {
  if (!first_) first_ = time;
  const std::int64_t now_ns = (time - *first_).count() * ns_per_us;
  if (frame.is_error()) {
    ++errors_;
    return;
  }
  counted_until_ns_ = std::max(now_ns, counted_until_ns_);
  frames_.add(counted_until_ns_, counted_until_ns_ + ns_per_us);
  counted_until_ns_ += ns_per_us;
  if (bit_rate_ == 0) return;
  const std::int64_t length_ns = (frame_bits(frame) + intermission_bits) * ns_per_s / bit_rate_;
  busy_until_ns_ = std::max(now_ns, busy_until_ns_);
  load_.add(busy_until_ns_, busy_until_ns_ + length_ns);
  busy_until_ns_ += length_ns;
}

std::string BusTraffic::text(Duration now) const {
  if (!first_) return "nothing is heard yet";
  const std::int64_t now_ns = (now - *first_).count() * ns_per_us;
  const double frames = frames_.recent(std::max(now_ns, counted_until_ns_)) * 1e6;
  std::string text = fmt::format("{:.0f} frames/s", frames);
  if (bit_rate_ != 0) {
    text += fmt::format(", bus load {:.1f} % of {} kbit/s",
                        load_.recent(std::max(now_ns, busy_until_ns_)) * 100, bit_rate_ / 1000);
  }
  if (errors_ != 0) text += fmt::format(", {} error frame{}", errors_, errors_ == 1 ? "" : "s");
  return text;
}

// The screen

bool TableScreen::take_keys() {
  while (true) {
    const std::optional<Key> key = screen_.key();
    if (!key) return true;
    if (is_searching_) {
      take_search(*key);
    } else if (!take(*key)) {
      return false;
    }
  }
}

void TableScreen::take_search(Key key) {
  if (key == Key::enter || key == Key::escape) {
    is_searching_ = false;
    if (key == Key::escape) typed_.clear();
  } else {
    type_key(typed_, key);
  }
  view_.search = typed_;
  view_.first = 0;
}

bool TableScreen::take(Key key) {
  const LiveTable& table = frozen_ ? *frozen_ : table_;
  const std::size_t count = table.count(view_);
  if (const auto rows = rows_moved(key, table.page(view_), count)) {
    view_.first = moved_row(view_.first, *rows, count);
    return true;
  }
  switch (static_cast<char32_t>(key)) {
    case 'q':
      return false;
    case ' ':
      if (frozen_) {
        frozen_.reset();
      } else {
        frozen_ = table_;
        frozen_at_ = now_;
      }
      break;
    case 's':
      view_.sort = static_cast<LiveTable::Sort>((static_cast<unsigned>(view_.sort) + 1) %
                                                LiveTable::sort_count);
      break;
    case 'r':
      view_.is_reversed = !view_.is_reversed;
      break;
    case '/':
      is_searching_ = true;
      typed_.clear();
      view_.search.clear();
      break;
    default:
      break;
  }
  return true;
}

void TableScreen::draw(Duration now, const std::string& traffic, const std::string& alarm,
                       const std::string& note) {
  now_ = now;
  const Screen::Size size = Screen::size();
  const LiveTable& table = frozen_ ? *frozen_ : table_;
  view_.now = frozen_ ? frozen_at_ : now;
  view_.columns = size.columns;
  view_.has_marks = true;
  std::vector<std::string> lines = {
      fmt::format("{}  {}{}", source_, traffic, frozen_ ? "   PAUSED" : "")};
  if (!alarm.empty()) lines.push_back("\x1b[1m" + alarm + "\x1b[22m");
  if (!note.empty()) {
    for (std::string& line : in_lines(note, size.columns)) lines.push_back(std::move(line));
  }
  const std::size_t around = lines.size() + 1;
  view_.rows = size.rows > around ? size.rows - around : 1;
  for (std::string& line : table.lines(view_)) lines.push_back(std::move(line));
  lines.resize(std::max<std::size_t>(size.rows, 1) - 1);
  lines.push_back(
      is_searching_ ? "search: " + typed_ + "_  (Enter keeps it, Esc ends it)"
                    : fmt::format("q quit  space pause  s sort: {}  r reverse  / search{}  arrows",
                                  LiveTable::name_of(view_.sort),
                                  view_.search.empty() ? "" : ": " + view_.search));
  screen_.draw(lines);
}

}  // namespace canvoy::tools
