#include "canvoy/tools/page/log_view.hpp"

#include <algorithm>
#include <chrono>

namespace canvoy::tools {

namespace {

/// True for CAN-IDs that only SDO parameters or a car make an SDO channel: may_teach() does not
/// consider these.
bool is_further_sdo(const decoder::Network& network, std::uint32_t can_id) {
  const std::uint32_t function = can_id & ~std::uint32_t{node_id_max};
  const bool is_default = function == can_id::sdo_request || function == can_id::sdo_response;
  return !is_default && network.sdo(can_id).has_value();
}

}  // namespace

void LogSearch::learn() {
  const Keys& all = store_.index().all_keys();
  has_channels_ = false;
  for (std::size_t key = 0; key < buses_.size() * FrameIndex::can_ids; ++key) {
    if (!all[key]) continue;
    const std::string& bus = buses_[FrameIndex::bus(static_cast<FrameIndex::Key>(key))];
    const std::uint32_t id = FrameIndex::can_id(static_cast<FrameIndex::Key>(key));
    const bool teaches = is_further_sdo(printer_.network(bus), id);
    has_channels_ = has_channels_ || teaches;
    wanted_[key] = teaches || printer_.may_pass(bus, Frame::data_frame(id, {}));
  }
  may_know_more_ = false;
}

bool LogSearch::may_pass(std::uint32_t buses, FrameFlags kind) {
  Frame frame;
  frame.flags = kind;
  for (std::size_t bus = 0; bus < buses_.size(); ++bus) {
    if ((buses >> bus & 1U) != 0 && printer_.may_pass(buses_[bus], frame)) return true;
  }
  return false;
}

bool LogSearch::is_needed(std::size_t block) {
  const FrameIndex& index = store_.index();
  if (block == 0 || index.teaches(block)) {
    may_know_more_ = true;
    return true;
  }
  if (may_know_more_) learn();
  const bool has_wanted =
      !index.is_kept(block) ||
      std::ranges::any_of(index.keys(block), [this](FrameIndex::Key key) { return wanted_[key]; });
  const auto [from, to] = store_.times(block);
  const bool is_in_time = printer_.may_pass(from - Time{}, to - Time{});
  may_know_more_ = has_wanted && has_channels_;
  if (may_know_more_) return true;
  return is_in_time && (has_wanted || may_pass(index.extended(block), FrameFlags::extended) ||
                        may_pass(index.errors(block), FrameFlags::error));
}

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
  if (is_filtered_ || store_.size() <= whole_max || end() <= window) return;
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

void LogView::begin_at(std::uint64_t number) {
  since_ = number;
  next_ = number - std::min(number, learned_before);
  if (store_.size() <= whole_max) decode(0, std::min(next_, learned_from));  // else it was
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
