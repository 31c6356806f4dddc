#include "canvoy/tools/page/frame_sort.hpp"

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace canvoy::tools {

namespace {

/// Number of parts merged at once; a cursor takes 96 KiB.
constexpr std::size_t merged_at_once = 64;

/// Frames in order of time, one part after the other.
struct SortedParts {
  FrameStore frames{0};
  std::vector<std::uint64_t> ends;
};

SortedParts sort_parts(const FrameStore& frames, std::uint64_t part_frames) {
  SortedParts sorted;
  FrameCursor cursor(frames);
  std::vector<StoredFrame> part;
  for (std::uint64_t next = 0; next < frames.size();) {
    const std::uint64_t end = std::min(frames.size(), next + part_frames);
    part.clear();
    for (; next < end; ++next) part.push_back(cursor.at(next));
    std::ranges::stable_sort(part, {}, &StoredFrame::time);
    for (const StoredFrame& each : part) sorted.frames.add(each);
    sorted.ends.push_back(end);
  }
  return sorted;
}

/// Appends the merged parts from `first` to `end`.
void merge(const SortedParts& parts, std::size_t first, std::size_t end, FrameStore& into) {
  struct Source {
    FrameCursor cursor;
    std::uint64_t next;
    std::uint64_t end;
  };
  std::vector<Source> sources;
  // Of equal times, the frame of the earlier part comes first.
  using Head = std::pair<Time, std::size_t>;
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
  for (std::size_t i = first; i < end; ++i) {
    const std::uint64_t begin = i == 0 ? 0 : parts.ends[i - 1];
    sources.push_back({FrameCursor(parts.frames), begin, parts.ends[i]});
    heads.emplace(sources.back().cursor.at(begin).time, sources.size() - 1);
  }
  while (!heads.empty()) {
    const std::size_t from = heads.top().second;
    heads.pop();
    Source& source = sources[from];
    into.add(source.cursor.at(source.next++));
    if (source.next < source.end) heads.emplace(source.cursor.at(source.next).time, from);
  }
}

}  // namespace

void sort_by_time(FrameStore& frames, std::uint64_t part_frames) {
  SortedParts parts = sort_parts(frames, part_frames);
  frames.clear();
  while (parts.ends.size() > merged_at_once) {
    SortedParts fewer;
    for (std::size_t i = 0; i < parts.ends.size(); i += merged_at_once) {
      merge(parts, i, std::min(parts.ends.size(), i + merged_at_once), fewer.frames);
      fewer.ends.push_back(fewer.frames.size());
    }
    parts = std::move(fewer);
  }
  merge(parts, 0, parts.ends.size(), frames);
}

}  // namespace canvoy::tools
