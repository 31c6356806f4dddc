#include "canvoy/tools/page/log_view.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::log_view_test {
namespace {

using Json = nlohmann::ordered_json;

/// Heartbeats of node 5, one each millisecond; every hundred thousandth is of node 6.
class Log {
 public:
  explicit Log(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const bool is_rare = i % 100'000 == 99'999;
      store_.add({Time(Duration(1ms) * static_cast<int>(i)),
                  Frame::data_frame(is_rare ? 0x706 : 0x705, {0x05}), 0});
    }
    until = Time(Duration(1ms) * static_cast<int>(count));
  }
  LogView reader(const std::string& filter) {
    return LogView(store_, buses_, {}, filter, [this] { return until; });
  }

  Time until;

 private:
  FrameStore store_;
  std::vector<std::string> buses_{"can0"};
};

Json read_all(LogView& reader) {
  std::string elements;
  do {
    std::string more;
    reader.read(more, 1 << 20);
    if (!more.empty()) elements += (elements.empty() ? "" : ",") + more;
  } while (reader.is_behind());
  return Json::parse("[" + elements + "]");
}

TEST(LogView, FindsByAFilterInAllOfTheLog) {
  Log log(500'000);
  LogView reader = log.reader("node=6");
  const Json found = read_all(reader);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[0]["time"], 99.999);
  EXPECT_EQ(found[4]["time"], 499.999);
  EXPECT_EQ(reader.searched(), 1);
}

/// A log of heartbeats of node 5, with other frames at some places.
class LogWith {
 public:
  LogWith(std::uint64_t count, const std::map<std::uint64_t, Frame>& others) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto other = others.find(i);
      store_.add({Time(Duration(1ms) * static_cast<int>(i)),
                  other == others.end() ? Frame::data_frame(0x705, {0x05}) : other->second, 0});
    }
  }
  LogView reader(const std::string& filter) {
    return LogView(store_, buses_, {}, filter, [] { return Time(1h * 1000); });
  }

 private:
  FrameStore store_;
  std::vector<std::string> buses_{"can0"};
};

constexpr std::uint64_t block = FrameStore::block_frames;
const Frame emergency = Frame::data_frame(0x08A, {0x10, 0x81, 0x11, 0, 0, 0, 0, 0});

TEST(LogView, NeverReadsABlockWithoutAMatch) {
  LogWith log(100 * block, {{70 * block + 5, emergency}, {99 * block + 7, emergency}});
  struct Case {
    std::string filter;
    std::size_t matches;
    std::uint64_t blocks;
  };
  // The first block, each block with a match, and the one before it.
  for (const Case& each : {
           Case{"service=EMCY", 2, 5},
           {"node=10", 2, 5},
           {"id=08A", 2, 5},
           {"not (id=705 or service=SYNC)", 2, 5},
           {"service=EMCY and node=11", 0, 1},
           {"service=EMCY and bus=can1", 0, 1},
           {"service=\"29-bit frame\" or service=\"error frame\"", 0, 1},
           {"time=280s..281s and service=EMCY", 0, 1},
           {"time=300s..301s and id=705", 1001, 3},
       }) {
    SCOPED_TRACE(each.filter);
    LogView reader = log.reader(each.filter);
    EXPECT_EQ(read_all(reader).size(), each.matches);
    EXPECT_EQ(reader.blocks_read(), each.blocks);
    EXPECT_EQ(reader.searched(), 1);
  }
}

TEST(LogView, ReadsBlocksThatTeachWhatOthersMean) {
  // 1000h of node 10, in a block of its own, is that of a battery (CiA 418); 160 eighths of a
  // degree in its TPDO1 are 20 degrees (6010h).
  LogWith log(
      100 * block,
      {{50 * block, Frame::data_frame(0x60A, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0})},
       {50 * block + 1, Frame::data_frame(0x58A, {0x43, 0x00, 0x10, 0x00, 0xA2, 0x01, 0, 0})},
       {90 * block, Frame::data_frame(0x18A, {0xA0, 0x00, 0x01})}});
  LogView reader = log.reader("id=18A");
  const Json found = read_all(reader);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["values"][0]["value"], 20.0);
  // The first one; the one that teaches, and its two neighbours; the one found, and the one before.
  EXPECT_EQ(reader.blocks_read(), 6U);
}

TEST(LogView, FollowsTransfersOnChannelsThatWereLearned) {
  // 1201h of node 10 makes 4F1h and 4F2h an SDO channel (CiA 301, 7.5.2.34), by which 1000h is
  // read.
  const auto written = [](std::uint8_t sub, std::uint8_t low) {
    return Frame::data_frame(0x60A, {0x23, 0x01, 0x12, sub, low, 0x04, 0, 0});
  };
  const auto done = [](std::uint8_t sub) {
    return Frame::data_frame(0x58A, {0x60, 0x01, 0x12, sub, 0, 0, 0, 0});
  };
  LogWith log(
      100 * block,
      {{10 * block, written(1, 0xF1)},
       {10 * block + 1, done(1)},
       {10 * block + 2, written(2, 0xF2)},
       {10 * block + 3, done(2)},
       {50 * block, Frame::data_frame(0x4F1, {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0})},
       {50 * block + 1, Frame::data_frame(0x4F2, {0x43, 0x00, 0x10, 0x00, 0xA2, 0x01, 0, 0})},
       {90 * block, Frame::data_frame(0x18A, {0xA0, 0x00, 0x01})}});
  LogView reader = log.reader("id=18A");
  const Json found = read_all(reader);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["values"][0]["value"], 20.0);
  LogView by_service = log.reader("service=SDO and id=400..4FF");
  EXPECT_EQ(read_all(by_service).size(), 2U);
}

/// A few frames that belong together.
std::vector<Frame> any_group(std::mt19937& random) {
  const auto node = static_cast<std::uint8_t>(10 + random() % 2);
  const auto id = [node](std::uint32_t function) { return function + node; };
  switch (random() % 7) {
    case 0:  // 1000h: a battery (CiA 418)
      return {Frame::data_frame(id(0x600), {0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0}),
              Frame::data_frame(id(0x580), {0x43, 0x00, 0x10, 0x00, 0xA2, 0x01, 0, 0})};
    case 1:
      return {Frame::data_frame(id(0x600), {0x40, 0x10, 0x60, 0x00, 0, 0, 0, 0}),
              Frame::data_frame(id(0x580), {0x4B, 0x10, 0x60, 0x00, 0xA0, 0x00, 0, 0})};
    case 2:
      return {Frame::data_frame(id(0x080), {0x10, 0x81, 0x11, 0, 0, 0, 0, 0})};
    case 3:
      return {Frame::remote_frame(id(0x700), 1), Frame::data_frame(id(0x700), {0x05})};
    case 4:
      return {Frame::data_frame(0x000, {0x01, node}), Frame::data_frame(0x080, {})};
    case 5:
      return {Frame::data_frame(0x1234567, {node})};
    default:
      return {Frame::data_frame(id(0x180), {0xA0, 0x00, 0x01})};
  }
}

TEST(LogView, FindsTheSameFramesAsALookAtAll) {
  std::mt19937 random(5);
  std::map<std::uint64_t, Frame> others;
  for (std::uint64_t i = block / 2; i < 16 * block; i += 1 + random() % (3 * block)) {
    for (const Frame& frame : any_group(random)) others.emplace(++i, frame);
  }
  LogWith log(16 * block, others);
  std::size_t count = 0;
  for (const std::string filter :
       {"node=10", "node=11 and service=SDO", "service=TPDO", "service=EMCY or service=NMT",
        "object=6010", "temperature=20", "id=18A,18B", "guarding", "not heartbeat",
        "service=\"29-bit frame\"", "time>20s and node=10", "text=CiA", "not node=5"}) {
    if (count++ % 3 != 0 && !tries_all()) continue;
    SCOPED_TRACE(filter);
    LogView all = log.reader("time>=0s and (" + filter + " or text=neverthere)");
    LogView sut = log.reader(filter);
    EXPECT_EQ(read_all(sut), read_all(all));
    EXPECT_LE(sut.blocks_read(), all.blocks_read());
  }
}

TEST(LogView, WithoutAFilterTellsThoseBeforeTheTime) {
  Log log(500'000);
  log.until = Time(300s);
  LogView reader = log.reader("");
  const Json found = read_all(reader);
  ASSERT_EQ(found.size(), LogView::window);
  EXPECT_EQ(found.back()["time"], 300.0);
  // Time advances, and then jumps.
  log.until = Time(300'010ms);
  EXPECT_EQ(read_all(reader).size(), 10U);
  log.until = Time(480s);
  const Json jumped = read_all(reader);
  EXPECT_EQ(jumped.size(), LogView::window);
  EXPECT_EQ(jumped.back()["time"], 480.0);
}

TEST(LogView, ALongLogThatIsPlayedFromItsStartIsToldFromItsFirstFrame) {
  Log log(500'000);
  log.until = Time(4ms);
  LogView reader = log.reader("");
  EXPECT_EQ(read_all(reader).size(), 5U);  // at 0 ms to 4 ms
  log.until = Time(1s);
  const Json next = read_all(reader);
  ASSERT_EQ(next.size(), 996U);
  EXPECT_EQ(next.front()["time"], 0.005);
}

TEST(LogView, GoesFromAFrameToAFrame) {
  for (const std::uint64_t size : {50'000U, 500'000U}) {
    Log log(size);
    LogView reader = log.reader("");
    reader.begin_at(40'000);
    EXPECT_EQ(reader.next(), 40'000U);
    reader.end_at(40'100);
    const Json found = read_all(reader);
    ASSERT_EQ(found.size(), 100U);
    EXPECT_EQ(found.front()["time"], 40.0);
    EXPECT_EQ(reader.next(), 40'100U);
    EXPECT_EQ(reader.searched(), 1);
  }
}

TEST(LogView, TellsAllOfAShortLog) {
  Log log(30'000);
  LogView reader = log.reader("");
  EXPECT_EQ(read_all(reader).size(), 30'000U);
}

TEST(LogView, TellsNoMoreThanAPageShows) {
  Log log(LogView::matches_max + 50'000);
  LogView reader = log.reader("node=5");
  EXPECT_EQ(read_all(reader).size(), LogView::matches_max);
  EXPECT_TRUE(reader.is_full());
}

TEST(LogView, RefusesAFilterThatMakesNoSense) {
  Log log(10);
  EXPECT_THROW(log.reader("no such object>4"), UsageError);
}

}  // namespace
}  // namespace canvoy::tools::log_view_test
