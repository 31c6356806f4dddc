#include "canvoy/tools/page/frame_feed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::frame_feed_test {
namespace {

using Json = nlohmann::json;

/// 160 eighths of a degree are 20 °C (CiA 418, 6010h).
const Frame twenty_degrees = Frame::data_frame(0x18A, {0xA0, 0x00, 0x01});
const Frame heartbeat_of_5 = Frame::data_frame(0x705, {0x05});

Json read_all(FrameReader& reader) {
  std::string elements;
  reader.read(elements, 1 << 20);
  return Json::parse("[" + elements + "]");
}

TEST(FrameFeed, TellsFramesAsTheCommandLineDoes) {
  FrameFeed feed({});
  feed.add(1s, "can0", heartbeat_of_5);
  FrameReader reader(feed, "", 0);
  const Json frames = read_all(reader);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0]["frame"], "705#05");
  EXPECT_EQ(frames[0]["service"], "heartbeat");
  EXPECT_EQ(frames[0]["time"], 1.0);
  EXPECT_FALSE(reader.is_behind());
  EXPECT_TRUE(read_all(reader).empty());
}

TEST(FrameFeed, EachReaderHasHisFilter) {
  FrameFeed feed({});
  feed.add(0s, "can0", heartbeat_of_5);
  feed.add(1s, "can0", Frame::data_frame(0x706, {0x05}));
  FrameReader reader(feed, "node=6", 0);
  const Json frames = read_all(reader);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0]["node"], 6);
  EXPECT_THROW(FrameReader(feed, "node=", 0), UsageError);
}

TEST(FrameFeed, AReaderLearnsFromWhatWasBeforeHim) {
  FrameFeed feed({.nodes = {"10=418"}});
  feed.add(0s, "can0", heartbeat_of_5);
  feed.add(1s, "can0", twenty_degrees);
  FrameReader reader(feed, "", 1);
  EXPECT_EQ(read_all(reader).size(), 1U);
}

TEST(FrameFeed, WhoComesTooLateIsToldHowMuchHeMissed) {
  FrameFeed feed({});
  FrameReader reader(feed, "", 0);
  for (std::size_t i = 0; i < FrameFeed::frames_max + 3; ++i) feed.add(0s, "can0", heartbeat_of_5);
  EXPECT_EQ(feed.first(), 3U);
  read_all(reader);
  EXPECT_EQ(reader.take_lost(), 3U);
  EXPECT_EQ(reader.take_lost(), 0U);
}

TEST(FrameFeed, AReaderThatEndsBeforeAFrameLosesNoneBehindIt) {
  FrameFeed feed({});
  FrameReader reader(feed, "", 0);
  reader.end_at(2);
  for (std::size_t i = 0; i < FrameFeed::frames_max + 3; ++i) feed.add(0s, "can0", heartbeat_of_5);
  EXPECT_TRUE(read_all(reader).empty());
  EXPECT_EQ(reader.take_lost(), 2U);
  EXPECT_EQ(reader.next(), 2U);
  EXPECT_FALSE(reader.is_behind());
}

TEST(FrameFeed, AReaderBeginsAtAFrame) {
  FrameFeed feed({});
  for (std::size_t i = 0; i < 30'000; ++i) feed.add(Duration(i), "can0", heartbeat_of_5);
  FrameReader reader(feed, "", 0);
  reader.begin_at(29'998);
  EXPECT_EQ(reader.next(), 29'998U);
  Json found = Json::array();
  while (reader.is_behind()) {
    for (const Json& each : read_all(reader)) found.push_back(each);
  }
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]["time"], 0.029998);
}

TEST(FrameFeed, AValueIsToldWhenItHasChanged) {
  FrameFeed feed({.nodes = {"10=418"}});
  feed.add(1s, "can0", twenty_degrees);
  std::string members;
  feed.append_values(members, 0);
  const Json values = Json::parse("{" + members + "}");
  const auto temperature = std::ranges::find_if(
      values, [](const Json& each) { return each["values"][0]["index"] == "6010"; });
  ASSERT_NE(temperature, values.end());
  EXPECT_EQ((*temperature)["values"][0]["value"], 20.0);
  EXPECT_EQ((*temperature)["values"][0]["unit"], "°C");
  EXPECT_EQ((*temperature)["text"], "20.000 °C");

  const std::uint64_t told = feed.changes();
  feed.add(2s, "can0", twenty_degrees);
  EXPECT_EQ(feed.changes(), told);
  feed.add(3s, "can0", Frame::data_frame(0x18A, {0xA8, 0x00, 0x01}));
  members.clear();
  feed.append_values(members, told);
  const Json changed = Json::parse("{" + members + "}");
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed.begin()->at("values").at(0).at("value"), 21.0);
}

TEST(FrameFeed, CountsByNodeAndService) {
  FrameFeed feed({});
  feed.add(1s, "can0", heartbeat_of_5);
  feed.add(2s, "can0", heartbeat_of_5);
  feed.add(3s, "can1", heartbeat_of_5);
  const FrameFeed::BusCounts& counts = feed.counts(0);
  EXPECT_EQ(counts.all.frames, 2U);
  EXPECT_EQ(counts.nodes.at(5).frames, 2U);
  EXPECT_EQ(counts.nodes.at(5).last, Duration(2s));
  EXPECT_EQ(counts.services.at("heartbeat").frames, 2U);
  // 44 bits around the data, 8 of data, at most 3 of intermission, and stuff bits.
  EXPECT_GE(counts.all.bits, 2U * 52);
  EXPECT_LE(counts.all.bits, 2U * 70);
}

TEST(FrameFeed, MoreBusesThanItKeepsArePassedOver) {
  FrameFeed feed({});
  for (int i = 0; i < 100; ++i) feed.add(0s, "can" + std::to_string(i), heartbeat_of_5);
  EXPECT_EQ(feed.buses().size(), FrameFeed::buses_max);
  EXPECT_EQ(feed.end(), FrameFeed::buses_max);
}

TEST(FrameFeed, ForgetsAllWhenARunBeginsAnew) {
  FrameFeed feed({.nodes = {"10=418"}});
  feed.add(1s, "can0", twenty_degrees);
  feed.clear();
  std::string members;
  feed.append_values(members, 0);
  EXPECT_EQ(members, "");
  EXPECT_EQ(feed.first(), feed.end());
  EXPECT_EQ(feed.counts(0).all.frames, 0U);
}

}  // namespace
}  // namespace canvoy::tools::frame_feed_test
