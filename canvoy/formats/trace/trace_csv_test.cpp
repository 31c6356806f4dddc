// CSV of python-can and SavvyCAN. The lines of python-can are the output of can.CSVWriter of
// version 4.1.0 for the messages that are expected here; those of SavvyCAN follow its own log
// (framefileio.cpp of SavvyCAN, saveNativeCSVFile).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_alike_test.hpp"

namespace canvoy::formats::trace_csv_test {
namespace {

constexpr std::string_view python_can =
    "timestamp,arbitration_id,extended,remote,error,dlc,data\r\n"
    "1700000000.000125,0x185,0,0,0,2,Hi8=\r\n"
    "1700000001.5,0x18daf110,1,0,0,8,AQIDBAUGBwg=\r\n"
    "1700000002.5,0x701,0,1,0,4,\r\n"
    "1700000003.5,0x0,1,0,1,0,\r\n"
    "1700000004.0,0x123,0,0,0,12,AAECAwQFBgcICQoL\r\n"
    "1700000004.500001,0x0,0,0,0,0,\r\n";

std::vector<TraceFrame> all_of(std::string_view content, std::uint64_t bad = 0) {
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace);
  std::vector<TraceFrame> frames;
  TraceFrame frame;
  for (TraceRead read; (read = trace->next(frame)) != TraceRead::end;) {
    // The channel name has a shorter lifetime.
    frame.channel = frame.channel == "can1" ? "can1" : "can0";
    if (read == TraceRead::frame) frames.push_back(frame);
  }
  EXPECT_EQ(trace->bad(), bad) << content;
  return frames;
}

TEST(PythonCanCsv, IsReadAsItWasWritten) {
  const std::vector<TraceFrame> frames = all_of(python_can);
  ASSERT_EQ(frames.size(), 5U);
  EXPECT_EQ(frames[0].time, Time{} + 1'700'000'000s + 125us);
  EXPECT_EQ(frames[0].frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(frames[1].time, Time{} + 1'700'000'001s + 500ms);
  EXPECT_EQ(frames[1].frame, Frame::data_frame(0x18DAF110, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(frames[2].frame, Frame::remote_frame(0x701, 4));
  EXPECT_TRUE(frames[3].frame.is_error());
  EXPECT_EQ(frames[4].frame, Frame::data_frame(0, {}));
}

// A tab behind a cell, which is passed over, leaves a line to the tolerant path.
TEST(PythonCanCsv, IsReadAlikeOnBothPaths) {
  const std::string head = "timestamp,arbitration_id,extended,remote,error,dlc,data\n";
  for (const std::string usual :
       {"1700000000.000125,0x185,0,0,0,2,Hi8=", "1700000001.5,0x18daf110,1,0,0,8,AQIDBAUGBwg=",
        "12.000001,0x7ff,0,0,0,0,"}) {
    for (std::size_t at = 0; at < usual.size(); ++at) {
      for (int value = 0; value < 256; ++value) {
        if (value == '\n' || value == '\r') continue;
        std::string line = usual;
        line[at] = static_cast<char>(value);
        std::string careful = line;
        careful.insert(std::min(careful.find(','), careful.size()), 1, '\t');
        expect_read_alike(head + line, head + careful);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(PythonCanCsv, CountsFdFrames) {
  auto trace = TraceReader::of(python_can);
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->format(), TraceFormat::python_can_csv);
  TraceFrame frame;
  while (trace->next(frame) != TraceRead::end) continue;
  EXPECT_EQ(trace->fd_frames(), 1U);
}

TEST(PythonCanCsv, WithALineThatCannotBeReadSaysSo) {
  for (const std::string line :
       {"x,0x185,0,0,0,2,Hi8=", "1.5,0xG,0,0,0,2,Hi8=", "1.5,0x800,0,0,0,2,Hi8=",
        "1.5,0x185,2,0,0,2,Hi8=", "1.5,0x185,0,0,0,x,Hi8=", "1.5,0x185,0,0,0,3,Hi8=",
        "1.5,0x185,0,0,0,2,H*8=", "1.5,0x185,0,0,0,8,AAECAwQFBgcICQoL", "1.5,0x185",
        "-1,0x1,0,0,0,0,"}) {
    const std::string content =
        "timestamp,arbitration_id,extended,remote,error,dlc,data\n" + line + "\n";
    EXPECT_TRUE(all_of(content, 1).empty()) << line;
  }
}

TEST(PythonCanCsv, ReadsTimesWithExponents) {
  const auto frames =
      all_of("timestamp,arbitration_id,extended,remote,error,dlc,data\n1.5e-05,0x1,0,0,0,0,\n");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].time, Time{} + 15us);
}

TEST(SavvyCanCsv, HasMicrosecondsAndBuses) {
  const auto frames = all_of(
      "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n"
      "166064000,0000021A,false,Rx,0,8,FE,36,12,FE,69,05,07,AD,\n"
      "166096000,18DAF110,true,Tx,1,2,1E,2F,\n");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].time, Time{} + 166'064ms);
  EXPECT_EQ(frames[0].frame,
            Frame::data_frame(0x21A, {0xFE, 0x36, 0x12, 0xFE, 0x69, 0x05, 0x07, 0xAD}));
  EXPECT_EQ(frames[0].direction, TraceDirection::received);
  EXPECT_EQ(frames[1].frame, Frame::data_frame(0x18DAF110, {0x1E, 0x2F}));
  EXPECT_EQ(frames[1].channel, "can1");
  EXPECT_EQ(frames[1].direction, TraceDirection::sent);
}

TEST(SavvyCanCsv, OfOlderVersionsHasNoDirection) {
  const auto frames = all_of(
      "Time Stamp,ID,Extended,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n"
      "5,00000185,false,1,1,7F,\n");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].channel, "can1");
  EXPECT_EQ(frames[0].frame, Frame::data_frame(0x185, {0x7F}));
}

TEST(SavvyCanCsv, WithALineThatCannotBeReadSaysSo) {
  for (const std::string line :
       {"x,185,false,Rx,0,1,00", "5,800,false,Rx,0,1,00", "5,185,maybe,Rx,0,1,00",
        "5,185,false,Rx,x,1,00", "5,185,false,Rx,255,1,00", "5,185,false,Rx,0,2,00",
        "5,185,false,Rx,0,1,100"}) {
    const std::string content = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n" + line + "\n";
    EXPECT_TRUE(all_of(content, 1).empty()) << line;
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_csv_test
