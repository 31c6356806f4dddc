#include "canvoy/tools/bus/monitor_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/frame_bits.hpp"

namespace canvoy::tools {

namespace {

constexpr std::int64_t ns_per_us = 1000;
constexpr std::int64_t ns_per_s = 1'000'000'000;

}  // namespace

// The head

/// Frames that arrive together were on the wire one after the other.
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
  const auto character = static_cast<char32_t>(key);
  if (key == Key::enter || key == Key::escape) {
    is_searching_ = false;
    if (key == Key::escape) typed_.clear();
  } else if (key == Key::backspace) {
    if (!typed_.empty()) typed_.pop_back();
  } else if (character >= ' ' && character < 0x100) {
    typed_ += static_cast<char>(character);
  }
  view_.search = typed_;
  view_.first = 0;
}

void TableScreen::scroll(long rows) {
  const auto count = static_cast<long>((frozen_ ? *frozen_ : table_).count(view_));
  const auto wanted = static_cast<long>(view_.first) + rows;
  view_.first = static_cast<std::size_t>(std::clamp(wanted, 0L, std::max(0L, count - 1)));
}

bool TableScreen::take(Key key) {
  const auto page = static_cast<long>(std::max<std::size_t>(view_.rows, 2)) - 1;
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
    case static_cast<char32_t>(Key::up):
      scroll(-1);
      break;
    case static_cast<char32_t>(Key::down):
      scroll(1);
      break;
    case static_cast<char32_t>(Key::page_up):
      scroll(-page);
      break;
    case static_cast<char32_t>(Key::page_down):
      scroll(page);
      break;
    case static_cast<char32_t>(Key::home):
      view_.first = 0;
      break;
    case static_cast<char32_t>(Key::end):
      scroll(static_cast<long>(table_.size()));
      break;
    default:
      break;
  }
  return true;
}

void TableScreen::draw(Duration now, const std::string& traffic, const std::string& note) {
  now_ = now;
  const Screen::Size size = Screen::size();
  const LiveTable& table = frozen_ ? *frozen_ : table_;
  view_.now = frozen_ ? frozen_at_ : now;
  view_.columns = size.columns;
  view_.has_marks = true;
  std::vector<std::string> lines = {
      fmt::format("{}  {}{}", source_, traffic, frozen_ ? "   PAUSED" : "")};
  if (!note.empty()) lines.push_back(note);
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
