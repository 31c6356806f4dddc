// Frames of a log of any length in order of time, found by number, by time, and in blocks by bus
// and CAN-ID: the first ones in memory, the others in an unnamed file that is removed with this.
//
//     FrameStore store;
//     store.add({time, frame, bus});
//     FrameCursor cursor(store);
//     for (std::uint64_t i = store.first_after(when); i < store.size(); ++i) look(cursor.at(i));
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/tools/page/frame_index.hpp"

namespace canvoy::tools {

struct StoredFrame {
  StoredFrame() = default;
  StoredFrame(Time at, const Frame& heard, std::uint8_t on_bus) : time(at), frame(heard) {
    frame.reserved = on_bus;
  }
  std::uint8_t bus() const { return static_cast<std::uint8_t>(frame.reserved); }
  /// The frame as heard.
  Frame plain() const {
    Frame made = frame;
    made.reserved = 0;
    return made;
  }

  Time time{};
  Frame frame;  ///< `reserved` holds the bus
};
static_assert(sizeof(StoredFrame) == 24, "25 million of them are 600 MB of a file");

class FrameStore {
 public:
  static constexpr std::size_t block_frames = 4096;
  /// Number of blocks in memory, 24 MiB; the others are in the file.
  static constexpr std::size_t memory_blocks = 256;

  FrameStore() = default;
  /// Keeps so many blocks in memory instead.
  explicit FrameStore(std::size_t blocks_in_memory) : blocks_in_memory_(blocks_in_memory) {}

  /// Adds a frame in order of time. Throws Failure if the file cannot be written.
  void add(const StoredFrame& frame);
  std::uint64_t size() const { return size_; }
  void clear();
  /// Number of the first frame later than `when`; size() if there is none. Logarithmic.
  std::uint64_t first_after(Time when) const;
  /// What the blocks have; the number of a frame, divided by block_frames, is that of its block.
  const FrameIndex& index() const { return index_; }
  /// Times between which the frames of a block are: those of its first frame, and of that of the
  /// next block, or far beyond the last one.
  std::pair<Time, Time> times(std::size_t block) const {
    const bool is_last = block + 1 == begins_.size();
    return {begins_[block],
            is_last ? Time(Time::max().time_since_epoch() / 2) : begins_[block + 1]};
  }

 private:
  friend class FrameCursor;
  using Block = std::vector<StoredFrame>;

  void spill(const Block& block);
  /// Throws Failure if the file cannot be read.
  void load(std::size_t number, Block& into) const;

  std::size_t blocks_in_memory_ = memory_blocks;
  std::uint64_t size_ = 0;
  std::vector<Block> blocks_;
  Block last_;  ///< the block being filled
  std::vector<Time> begins_;
  FrameIndex index_;
  host::Descriptor file_;
};

/// Reads frames in sequence, with a cache of the last block.
class FrameCursor {
 public:
  /// `store` must outlive this.
  explicit FrameCursor(const FrameStore& store) : store_(store) {}
  /// Valid until the next call, and until a frame is added.
  const StoredFrame& at(std::uint64_t number);

 private:
  const FrameStore& store_;
  FrameStore::Block block_;
  std::size_t loaded_ = ~std::size_t{0};
};

}  // namespace canvoy::tools
