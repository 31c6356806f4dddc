// Screen output of candump, as printed by lib.c and candump.c of can-utils.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats::trace_candump_screen_test {
namespace {

struct Read {
  std::vector<TraceFrame> frames;
  std::uint64_t bad = 0;
  std::uint64_t fd = 0;
};

Read all_of(std::string_view content) {
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace) << content;
  Read made;
  if (!trace) return made;
  EXPECT_EQ(trace->format(), TraceFormat::candump);
  TraceFrame frame;
  for (TraceRead read; (read = trace->next(frame)) != TraceRead::end;) {
    if (read == TraceRead::frame) made.frames.push_back(frame);
  }
  made.bad = trace->bad();
  made.fd = trace->fd_frames();
  return made;
}

TraceFrame the_frame(std::string_view line) {
  const Read read = all_of(line);
  EXPECT_EQ(read.frames.size(), 1U) << line;
  return read.frames.empty() ? TraceFrame{} : read.frames.front();
}

const Frame usual = Frame::data_frame(0x185, {0x1E, 0x2F});

TEST(CandumpScreen, HasFramesWithoutTimes) {
  const TraceFrame read = the_frame("  can0  185   [2]  1E 2F\n");
  EXPECT_EQ(read.frame, usual);
  EXPECT_EQ(read.channel, "can0");
  EXPECT_EQ(read.time, Time{});
  EXPECT_EQ(the_frame("  can0  18DAF110   [1]  7F").frame, Frame::data_frame(0x18DAF110, {0x7F}));
  EXPECT_EQ(the_frame("  can0  000   [0] ").frame, Frame::data_frame(0, {}));
}

TEST(CandumpScreen, HasTimesSince1970OrOfTheDay) {
  const Time expected = Time{} + 1'700'000'000s + 125us;
  EXPECT_EQ(the_frame(" (1700000000.000125)  can0  185   [2]  1E 2F").time, expected);
  EXPECT_EQ(the_frame(" (2023-11-14 22:13:20.000125)  can0  185   [2]  1E 2F").time, expected);
  EXPECT_EQ(the_frame(" (2023-11-14 22:13:20.000125)  can0  185   [2]  1E 2F").frame, usual);
}

TEST(CandumpScreen, HasTimesFromTheFirstFrameOn) {
  const Read read = all_of(
      " (000.000000)  can0  185   [1]  01\n (000.500000)  can0  185   [1]  02\n"
      " (012.000000)  can0  185   [1]  03\n");
  ASSERT_EQ(read.frames.size(), 3U);
  EXPECT_EQ(read.frames[2].time, Time{} + 12s);
}

TEST(CandumpScreen, HasTimesFromTheFrameBefore) {
  const Read read = all_of(
      " (000.000000)  can0  185   [1]  01\n (000.500000)  can0  185   [1]  02\n"
      " (000.250000)  can0  185   [1]  03\n (001.000000)  can0  185   [1]  04\n");
  ASSERT_EQ(read.frames.size(), 4U);
  EXPECT_EQ(read.frames[1].time, Time{} + 500ms);
  EXPECT_EQ(read.frames[2].time, Time{} + 750ms);
  EXPECT_EQ(read.frames[3].time, Time{} + 1750ms);
}

TEST(CandumpScreen, HasDirectionsAndFlags) {
  const TraceFrame received = the_frame("  can0  RX - -  185   [2]  1E 2F");
  EXPECT_EQ(received.direction, TraceDirection::received);
  EXPECT_EQ(received.frame, usual);
  EXPECT_EQ(the_frame("  can0  TX - -  185   [2]  1E 2F").direction, TraceDirection::sent);
}

TEST(CandumpScreen, HasCharactersBehindTheBytes) {
  EXPECT_EQ(the_frame("  can0  185   [2]  1E 2F                     './'").frame, usual);
  EXPECT_EQ(the_frame("  can0  185   [2]  41 42                     'AB'").frame.length, 2);
}

TEST(CandumpScreen, HasRawDataLengthCodes) {
  const TraceFrame read = the_frame("  can0  185   {E}  01 02 03 04 05 06 07 08");
  EXPECT_EQ(read.frame, Frame::data_frame(0x185, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(the_frame("  can0  185   {2}  1E 2F").frame, usual);
}

TEST(CandumpScreen, HasRemoteAndErrorFrames) {
  EXPECT_EQ(the_frame("  can0  701   [4]  remote request").frame, Frame::remote_frame(0x701, 4));
  const Read read = all_of(
      "  can0  20000088   [8]  00 00 08 00 00 00 00 00   ERRORFRAME\n"
      "\tprotocol-violation{{tx-recessive-bit-error}{}}\n\tbus-error\n"
      "  can0  185   [2]  1E 2F\n");
  ASSERT_EQ(read.frames.size(), 2U);
  EXPECT_TRUE(read.frames[0].frame.is_error());
  EXPECT_EQ(read.frames[0].frame.id, 0x88U);
  EXPECT_EQ(read.frames[0].frame.data[2], 0x08);
  EXPECT_EQ(read.bad, 0U);
}

TEST(CandumpScreen, CountsFdFrames) {
  EXPECT_EQ(all_of("  can0  185  [12]  00 01 02 03 04 05 06 07 08 09 0A 0B\n").fd, 1U);
  EXPECT_EQ(all_of("  can0  185  [02]  00 01\n").fd, 1U);
}

TEST(CandumpScreen, WithALineThatCannotBeReadSaysSo) {
  for (const std::string line :
       {"  can0  185   [3]  1E 2F", "  can0  185   [2]  1E 2G", "  can0  985   [2]  1E 2F",
        " (x)  can0  185   [2]  1E 2F", " (2023-13-14 22:13:20.0)  can0  185   [2]  1E 2F",
        " (2023-11-14 25:13:20.0)  can0  185   [2]  1E 2F", "  can0  185   [9]  1E", "nothing"}) {
    const Read read = all_of("  can0  185   [2]  1E 2F\n" + line + "\n");
    EXPECT_EQ(read.frames.size(), 1U) << line;
    EXPECT_EQ(read.bad, 1U) << line;
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_candump_screen_test
