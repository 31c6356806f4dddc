#include "canvoy/tools/page/shared_frames.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace canvoy::tools::shared_frames_test {
namespace {

/// Frames that are numbers: as many as there are, of so many bytes each.
struct Source {
  std::uint64_t end = 0;
  std::uint64_t first = 0;  ///< earlier ones are gone
  std::size_t bytes = 8;
  std::uint64_t written = 0;  ///< by all walks
};

class Walk : public FrameWalk {
 public:
  explicit Walk(Source& source) : source_(source) {}

  void read(std::string& elements, std::size_t bytes_max) override {
    const std::uint64_t first = std::min(source_.first, limit_);
    if (next_ < first) {
      lost_ += first - next_;
      next_ = first;
    }
    for (; next_ < end() && elements.size() < bytes_max; ++next_) {
      if (!elements.empty()) elements += ',';
      elements += fmt::format("{:{}}", next_, source_.bytes);
      ++source_.written;
    }
  }
  bool is_behind() const override { return next_ < end(); }
  std::uint64_t take_lost() override { return std::exchange(lost_, 0); }
  std::uint64_t next() const override { return next_; }
  std::uint64_t end() const override { return std::min(source_.end, limit_); }
  void begin_at(std::uint64_t number) override { next_ = number; }
  void end_at(std::uint64_t number) override { limit_ = number; }

 private:
  Source& source_;
  std::uint64_t next_ = 0;
  std::uint64_t limit_ = ~std::uint64_t{0};
  std::uint64_t lost_ = 0;
};

struct Shared {
  std::unique_ptr<FrameWalk> walk() { return std::make_unique<Walk>(source); }
  std::unique_ptr<FrameStream> join() { return shared->join(walk()); }

  Source source{};
  std::shared_ptr<SharedFrames> shared = SharedFrames::create([this] { return walk(); });
};

/// What a viewer is told until there is no more.
std::vector<std::uint64_t> told(FrameStream& stream, std::size_t bytes_max = 100'000) {
  std::vector<std::uint64_t> all;
  while (stream.is_behind()) {
    std::string elements;
    stream.read(elements, bytes_max);
    const auto read = nlohmann::json::parse("[" + elements + "]");
    all.insert(all.end(), read.begin(), read.end());
  }
  return all;
}

std::vector<std::uint64_t> numbers(std::uint64_t from, std::uint64_t to) {
  std::vector<std::uint64_t> all;
  for (; from < to; ++from) all.push_back(from);
  return all;
}

TEST(SharedFrames, CommonFramesAreWrittenOnce) {
  Shared it;
  const auto first = it.join();
  const auto second = it.join();
  const auto third = it.join();
  it.source.end = 1000;
  for (const auto& each : {&first, &second, &third}) EXPECT_EQ(told(**each), numbers(0, 1000));
  EXPECT_EQ(it.source.written, 1000U);
  it.source.end = 1500;
  for (const auto& each : {&third, &first, &second}) EXPECT_EQ(told(**each), numbers(1000, 1500));
  EXPECT_EQ(it.source.written, 1500U);
}

TEST(SharedFrames, ALaterViewerHasWhatWasBefore) {
  Shared it;
  const auto first = it.join();
  it.source.end = 300;
  EXPECT_EQ(told(*first), numbers(0, 300));
  const auto second = it.join();
  it.source.end = 500;
  EXPECT_EQ(told(*second), numbers(0, 500));
  EXPECT_EQ(told(*first), numbers(300, 500));
  EXPECT_EQ(it.source.written, 300U + 300U + 200U);
}

TEST(SharedFrames, AViewerFarBehindLosesNothing) {
  Shared it;
  it.source.bytes = 1000;
  const auto quick = it.join();
  const auto slow = it.join();
  const std::uint64_t more_than_kept = 2 * SharedFrames::kept_max / it.source.bytes;
  for (std::uint64_t end = 100; end < more_than_kept; end += 100) {
    it.source.end = end;
    EXPECT_EQ(told(*quick), numbers(end - 100, end));
  }
  const std::uint64_t end = it.source.end;
  EXPECT_EQ(told(*slow), numbers(0, end));
  it.source.end += 10;
  EXPECT_EQ(told(*slow), numbers(end, end + 10));
  EXPECT_EQ(told(*quick), numbers(end, end + 10));
}

TEST(SharedFrames, WhatIsLostIsToldToEach) {
  Shared it;
  const auto first = it.join();
  const auto second = it.join();
  it.source.first = 7;
  it.source.end = 10;
  for (const auto& each : {&first, &second}) {
    EXPECT_EQ(told(**each), numbers(7, 10));
    EXPECT_EQ((*each)->take_lost(), 7U);
    EXPECT_EQ((*each)->take_lost(), 0U);
  }
}

TEST(SharedFrames, AMessageIsLittleLongerThanAsked) {
  Shared it;
  const auto viewer = it.join();
  it.source.end = 100'000;
  std::string elements;
  viewer->read(elements, 10'000);
  EXPECT_LE(elements.size(), 10'000 + SharedFrames::part_max + 100);
  EXPECT_TRUE(viewer->is_behind());
}

}  // namespace
}  // namespace canvoy::tools::shared_frames_test
