// Logs of candump -l, as written by can-utils (lib.h of can-utils).
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats::trace_candump_test {
namespace {

TraceFrame the_frame(std::string_view line) {
  auto trace = TraceReader::of(line);
  EXPECT_TRUE(trace);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame) << line;
  return frame;
}

TEST(CandumpTrace, HasTimeInterfaceAndFrame) {
  const TraceFrame read = the_frame("(1700000000.000125) can0 185#1E2F");
  EXPECT_EQ(read.time, Time{} + 1'700'000'000s + 125us);
  EXPECT_EQ(read.channel, "can0");
  EXPECT_EQ(read.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(read.direction, TraceDirection::unknown);
}

TEST(CandumpTrace, OfNewerToolsHasTheDirectionBehindTheFrame) {
  EXPECT_EQ(the_frame("(1700000000.000125) can0 185#1E2F R").direction, TraceDirection::received);
  EXPECT_EQ(the_frame("(1700000000.000125) can0 185#1E2F T").direction, TraceDirection::sent);
}

TEST(CandumpTrace, WithEightDigitsHasA29BitIdentifier) {
  Frame expected = Frame::data_frame(0x185, {0x11});
  expected.flags = FrameFlags::extended;
  EXPECT_EQ(the_frame("(1700000000.000125) can0 00000185#11").frame, expected);
  EXPECT_EQ(the_frame("(1700000000.000125) can0 1FFFFFFF#").frame,
            Frame::data_frame(0x1FFF'FFFF, {}));
}

TEST(CandumpTrace, HasRemoteAndErrorFrames) {
  EXPECT_EQ(the_frame("(1700000000.000125) can0 701#R").frame, Frame::remote_frame(0x701, 0));
  EXPECT_EQ(the_frame("(1700000000.000125) can0 701#R4").frame, Frame::remote_frame(0x701, 4));
  const Frame error = the_frame("(1700000000.000125) can0 20000004#0001000000000000").frame;
  EXPECT_TRUE(error.is_error());
  EXPECT_EQ(error.id, 4U);
}

TEST(CandumpTrace, TellsFdFrames) {
  auto trace = TraceReader::of("(1700000000.000125) can0 123##1112233\n");
  ASSERT_TRUE(trace);
  TraceFrame frame;
  ASSERT_EQ(trace->next(frame), TraceRead::fd);
  EXPECT_EQ(frame.channel, "can0");
  EXPECT_EQ(frame.frame.id, 0x123U);
  EXPECT_EQ(frame.fd.flags, TraceFdContent::bit_rate_switch);
  EXPECT_EQ(frame.fd.length, 3);
  EXPECT_EQ(frame.fd.data[2], 0x33);
  EXPECT_EQ(trace->next(frame), TraceRead::end);
  EXPECT_EQ(trace->fd_frames(), 1U);
}

// The fast path and the tolerant path agree on every character at every position of a line.
TEST(CandumpTrace, IsReadAsTheLineReaderReadsIt) {
  for (const std::string usual :
       {"(1700000000.000125) can0 185#1E2F", "(1700000000.000125) can0 1ABCDE85#0102030405060708",
        "(1700000000.000125) can0 185#R4 T"}) {
    for (std::size_t at = 0; at <= usual.size(); ++at) {
      for (int value = 0; value < 256; ++value) {
        if (value == '\n') continue;
        std::string line = "(0.0) can0 000#\n" + usual;
        line.insert(line.end() - static_cast<std::ptrdiff_t>(at), static_cast<char>(value));
        if (value % 2 == 0 && at > 0) line.erase(line.size() - at, 1);
        auto trace = TraceReader::of(line);
        ASSERT_TRUE(trace);
        TraceFrame frame;
        ASSERT_EQ(trace->next(frame), TraceRead::frame);
        const TraceRead read = trace->next(frame);
        const host::LogLine expected = host::parse_log_line(std::string_view(line).substr(16));
        const bool is_held = expected.time <= trace_time_max;
        ASSERT_EQ(read == TraceRead::frame, expected.kind == host::LogLineKind::frame && is_held)
            << line;
        ASSERT_EQ(read == TraceRead::bad, expected.kind == host::LogLineKind::malformed || !is_held)
            << line;
        if (read != TraceRead::frame) continue;
        ASSERT_EQ(frame.frame, expected.frame) << line;
        ASSERT_EQ(frame.time, expected.time) << line;
        ASSERT_EQ(frame.channel, expected.interface) << line;
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_candump_test
