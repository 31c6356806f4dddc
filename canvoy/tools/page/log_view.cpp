#include "canvoy/tools/page/log_view.hpp"

#include <algorithm>
#include <chrono>

namespace canvoy::tools {

namespace {

using Clock = std::chrono::steady_clock;
/// Time for the search of one message: the first matches are to come at once.
constexpr auto search_time = std::chrono::milliseconds(20);
constexpr std::uint64_t looked_at_once = 2048;
static_assert(FrameStore::block_frames % looked_at_once == 0, "a part is of one block");
constexpr std::uint64_t skipped_at_once = 4096;  ///< blocks, 1 ms

}  // namespace

LogView::LogView(const FrameStore& store, const std::vector<std::string>& buses,
                 const FramePrinterOptions& options, const std::string& filter,
                 std::function<Time()> until)
    : store_(store),
      buses_(buses),
      until_(std::move(until)),
      printer_(printed_as_json(options, filter)),
      cursor_(store),
      search_(store, buses, printer_),
      is_filtered_(!filter.empty()) {
  if (is_filtered_ || store_.size() <= whole_max) return;
  since_ = learned_from;
  decode(0, learned_from);
  next_ = learned_from;
  begin_window();
}

/// Follows frames that are not reported.
void LogView::decode(std::uint64_t from, std::uint64_t to) {
  for (; from < to; ++from) {
    const StoredFrame& heard = cursor_.at(from);
    static_cast<void>(printer_.decode(buses_[heard.bus()], heard.plain()));
  }
}

/// At the start of a block, skips blocks that the filter does not need. The block before one that
/// is needed is followed: transfers and node guarding begin there. False if there is nothing to
/// look at, or more to skip.
bool LogView::skip_blocks(std::uint64_t last) {
  constexpr std::uint64_t frames = FrameStore::block_frames;
  if (!is_filtered_ || next_ % frames != 0) return true;
  const std::uint64_t limit = std::min(last, next_ + skipped_at_once * frames);
  while (next_ < limit && !search_.is_needed(next_ / frames)) next_ += frames;
  if (next_ >= limit) return false;
  if (followed_ != next_) {
    decode(next_ - frames, next_);
    ++blocks_read_;
  }
  followed_ = next_ + frames;
  ++blocks_read_;
  return true;
}

/// Frames between the last reported one and the window are skipped.
void LogView::begin_window() {
  const std::uint64_t last = end();
  since_ = std::max(next_, last - std::min(last, window));
  next_ = std::max(next_, since_ - std::min(since_, window));
}

void LogView::read(std::string& elements, std::size_t bytes_max) {
  const std::uint64_t last = end();
  const bool has_window = !is_filtered_ && store_.size() > whole_max;
  if (has_window && last > next_ + 2 * window) begin_window();
  const auto begun = Clock::now();
  while (next_ < last && elements.size() < bytes_max && !is_full() &&
         Clock::now() - begun < search_time) {
    if (!skip_blocks(last)) continue;
    const std::uint64_t part = std::min(last, (next_ / looked_at_once + 1) * looked_at_once);
    for (; next_ < part && elements.size() < bytes_max && !is_full(); ++next_) {
      const StoredFrame& heard = cursor_.at(next_);
      const Frame frame = heard.plain();
      const std::size_t before = elements.size();
      if (before != 0) elements += ',';
      const Duration time = heard.time - Time{};
      const bool is_wanted = printer_.append(elements, time, buses_[heard.bus()], frame);
      if (!is_wanted || next_ < since_) {
        elements.resize(before);
        continue;
      }
      elements.pop_back();  // the line break
      ++matches_;
    }
  }
}

double LogView::searched() const {
  const std::uint64_t last = end();
  return last == 0 || next_ >= last ? 1 : static_cast<double>(next_) / static_cast<double>(last);
}

}  // namespace canvoy::tools
