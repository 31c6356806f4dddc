// Tells which blocks of a log a filter need not look at: those whose times, buses, CAN-IDs,
// services and nodes it excludes, and that teach nothing about what others mean.
//
//     LogSearch search(store, buses, printer);
//     if (search.is_needed(block)) look_at(block);
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/tools/page/frame_store.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy::tools {

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

}  // namespace canvoy::tools
