// Which CAN-IDs of which buses the blocks of a FrameStore have, so that a search need not read the
// others: 2 bytes for each bus and CAN-ID in a block, some 200 bytes for a block of 4096 frames.
//
//     FrameIndex index;
//     index.add(frame);
//     index.end_block();
//     for (const FrameIndex::Key key : index.keys(0)) show(FrameIndex::can_id(key));
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/can/frame.hpp"

namespace canvoy::tools {

class FrameIndex {
 public:
  static constexpr std::size_t buses_max = 32;
  static constexpr std::size_t can_ids = Frame::id_max + 1;
  static constexpr std::size_t keys_max = buses_max * can_ids;
  /// Maximum of keys() of all blocks, 40 MB: blocks beyond it have none, and are to be read.
  static constexpr std::size_t keys_kept_max = 20'000'000;

  /// A bus and a CAN-ID of 11 bits.
  using Key = std::uint16_t;
  static std::uint32_t can_id(Key key) { return key % can_ids; }
  static std::size_t bus(Key key) { return key / can_ids; }

  /// Adds a frame to the last block. `bus` is below buses_max. Constant cost.
  void add(std::size_t bus, const Frame& frame);
  void end_block();

  /// False if the keys of the block are not kept.
  bool is_kept(std::size_t block) const { return blocks_[block].is_kept; }
  /// Each bus and CAN-ID of data and remote frames in the block once.
  std::span<const Key> keys(std::size_t block) const;
  /// Sets of buses with 29-bit frames, and with error frames.
  std::uint32_t extended(std::size_t block) const { return blocks_[block].extended; }
  std::uint32_t errors(std::size_t block) const { return blocks_[block].errors; }
  /// True if the block has a frame that may_teach(), or follows on such a block.
  bool teaches(std::size_t block) const {
    return blocks_[block].teaches || (block != 0 && blocks_[block - 1].teaches);
  }
  /// All keys of all blocks.
  const std::bitset<keys_max>& all_keys() const { return all_; }

 private:
  struct Block {
    std::size_t first_key = 0;
    std::uint32_t extended = 0;
    std::uint32_t errors = 0;
    bool teaches = false;
    bool is_kept = true;
  };

  std::vector<Block> blocks_;
  std::vector<Key> keys_;
  std::bitset<keys_max> here_;  ///< keys of the last block
  std::bitset<keys_max> all_;
  bool is_open_ = false;
};

}  // namespace canvoy::tools
