// Sorts the frames of a log of any length by time, in a bounded part of memory: parts are sorted,
// written to files without a name, and merged.
//
//     FrameStore frames;
//     sort_by_time(frames);
#pragma once

#include <cstdint>

#include "canvoy/tools/page/frame_store.hpp"

namespace canvoy::tools {

/// Frames of one time keep their order. Takes 24 bytes for each frame of a part, 6 MB beside the
/// store, and for a while twice the file of the store. Throws Failure if the file cannot be
/// written.
void sort_by_time(FrameStore& frames, std::uint64_t part_frames = 250'000);

}  // namespace canvoy::tools
