#include "canvoy/tools/page/log_view.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
