// Frames without a filter, decoded and written once for all viewers that follow them. Each viewer
// begins with a walk of its own over earlier frames, and goes on with the common ones.
//
//     const auto shared = SharedFrames::create([&] { return walk_from_the_start(); });
//     std::unique_ptr<FrameStream> stream = shared->join(walk_of_this_viewer());
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "canvoy/tools/page/frame_feed.hpp"

namespace canvoy::tools {

class SharedFrames : public std::enable_shared_from_this<SharedFrames> {
 public:
  /// Makes a walk over all frames. Called again for each viewer that falls behind the kept frames.
  using Make = std::function<std::unique_ptr<FrameWalk>()>;
  /// Bytes of the latest frames that are kept. A viewer further behind has a walk of its own again.
  static constexpr std::size_t kept_max = std::size_t{4} << 20;
  /// Bytes of a part, approximately.
  static constexpr std::size_t part_max = std::size_t{64} << 10;

  /// Begins with the frame after the present last one.
  static std::shared_ptr<SharedFrames> create(Make make) {
    return std::shared_ptr<SharedFrames>(new SharedFrames(std::move(make)));
  }

  /// The frames of `own` up to the common ones, and then these.
  std::unique_ptr<FrameStream> join(std::unique_ptr<FrameWalk> own);

 private:
  class Follower;
  /// Elements of a JSON array.
  struct Part {
    std::string elements;
    std::uint64_t end = 0;   ///< number of the frame after it
    std::uint64_t lost = 0;  ///< frames lost before it
  };

  explicit SharedFrames(Make make);

  std::uint64_t end_part() const { return first_part_ + parts_.size(); }
  /// A part, which is read now if it is the next one; null: there is none yet.
  const Part* part(std::uint64_t number);

  Make make_;
  std::unique_ptr<FrameWalk> walk_;
  std::deque<Part> parts_;
  std::uint64_t first_part_ = 0;
  std::size_t kept_ = 0;  ///< bytes
};

}  // namespace canvoy::tools
