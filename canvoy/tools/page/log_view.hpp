// Frames of a log for one viewer: with a filter, those from the first frame to a time, without
// looking at blocks of the log that the filter excludes; without, those just before the time.
//
//     LogView view(store, buses, options, "node=10", [&] { return playback.aim(); });
//     view.read(lines, 256 * 1024);
#pragma once

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "canvoy/tools/page/frame_feed.hpp"
#include "canvoy/tools/page/frame_store.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy::tools {

// Tells which blocks of a log a filter need not look at: those whose times, buses, CAN-IDs,
// services and nodes it excludes, and that teach nothing about what others mean.
//
//     LogSearch search(store, buses, printer);
//     if (search.is_needed(block)) look_at(block);

class LogSearch {
 public:
  /// All arguments must outlive this. `printer` has the filter, and has looked at the first frame
  /// before is_needed() is asked about times.
  LogSearch(const FrameStore& store, const std::vector<std::string>& buses, FramePrinter& printer)
      : store_(store), buses_(buses), printer_(printer) {}

  /// True if a frame of the block may pass the filter, or teaches something, by what `printer` has
  /// learned so far; it has to look at the block then. The first block is always needed. Costs one
  /// look at each bus and CAN-ID of the block; behind a block that teaches, at each of the log.
  bool is_needed(std::size_t block);

 private:
  using Keys = std::bitset<FrameIndex::keys_max>;

  void learn();
  /// A set of buses, bit by bit, with such frames that may pass.
  bool may_pass(std::uint32_t buses, FrameFlags kind);

  const FrameStore& store_;
  const std::vector<std::string>& buses_;
  FramePrinter& printer_;
  Keys wanted_;                ///< those that may pass, or teach
  bool has_channels_ = false;  ///< some of them teach by other SDO channels than the default ones
  bool may_know_more_ = true;  ///< than when `wanted_` was made
};

class LogView : public FrameWalk {
 public:
  /// Number of frames before the time without a filter; a log of at most whole_max frames is shown
  /// whole.
  static constexpr std::uint64_t window = 20'000;
  static constexpr std::uint64_t whole_max = 200'000;
  /// Number of frames at the start of the log that are decoded to learn about its nodes.
  static constexpr std::uint64_t learned_from = 20'000;
  /// Maximum number of frames shown by a page.
  static constexpr std::uint64_t matches_max = 200'000;

  /// `until`: end of the frames. All arguments must outlive this. Throws UsageError for an invalid
  /// filter.
  LogView(const FrameStore& store, const std::vector<std::string>& buses,
          const FramePrinterOptions& options, const std::string& filter,
          std::function<Time()> until);

  void read(std::string& elements, std::size_t bytes_max) override;
  bool is_behind() const override { return !is_full() && next_ < end(); }
  std::uint64_t next() const override { return std::max(next_, since_); }
  std::uint64_t end() const override { return std::min(store_.first_after(until_()), limit_); }
  void begin_at(std::uint64_t number) override;
  void end_at(std::uint64_t number) override { limit_ = number; }
  /// 1 when all is reported.
  double searched() const override;
  bool is_full() const override { return is_filtered_ && matches_ >= matches_max; }
  /// Number of blocks of the store that were decoded for the filter.
  std::uint64_t blocks_read() const { return blocks_read_; }

 private:
  void begin_window();
  bool skip_blocks(std::uint64_t last);
  void decode(std::uint64_t from, std::uint64_t to);

  const FrameStore& store_;
  const std::vector<std::string>& buses_;
  std::function<Time()> until_;
  FramePrinter printer_;
  FrameCursor cursor_;
  LogSearch search_;
  bool is_filtered_;
  std::uint64_t next_ = 0;
  std::uint64_t since_ = 0;                  ///< earlier frames are only decoded
  std::uint64_t limit_ = ~std::uint64_t{0};  ///< number of the first frame that is not read
  std::uint64_t matches_ = 0;
  std::uint64_t followed_ = 0;  ///< end of the last block that was not skipped
  std::uint64_t blocks_read_ = 0;
};

}  // namespace canvoy::tools
