// PEAK TRC in its six versions, from PEAK's description of the format.
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_alike_test.hpp"

namespace canvoy::formats::trace_trc_test {
namespace {

constexpr std::string_view header_1_0 = ";   Start time: 11.09.2002 16:00:20.682\n";
constexpr std::string_view header_1_1 = ";$FILEVERSION=1.1\n;$STARTTIME=45244.5\n";
constexpr std::string_view header_1_2 = ";$FILEVERSION=1.2\n;$STARTTIME=45244.5\n";
constexpr std::string_view header_1_3 = ";$FILEVERSION=1.3\n;$STARTTIME=45244.5\n";
constexpr std::string_view header_2_0 =
    ";$FILEVERSION=2.0\n;$STARTTIME=45244.5\n;$COLUMNS=N,O,T,I,d,l,D\n";
constexpr std::string_view header_2_1 =
    ";$FILEVERSION=2.1\n;$STARTTIME=45244.5\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n";
// 45244 days after 30 December 1899 is 14 November 2023; .5 is noon.
constexpr Time noon = Time{} + 1'699'963'200s;

TraceFrame the_frame(std::string_view header, std::string_view line) {
  const std::string content = std::string(header) + std::string(line) + "\r\n";
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace);
  EXPECT_EQ(trace->format(), TraceFormat::trc);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame) << line << ": " << trace->problem();
  EXPECT_EQ(trace->bad(), 0U);
  frame.channel = frame.channel == "can1" ? "can1" : frame.channel == "can0" ? "can0" : "?";
  return frame;
}

TraceRead read_of(std::string_view header, std::string_view line) {
  const std::string content = std::string(header) + std::string(line) + "\n";
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  return trace->next(frame);
}

TEST(TrcTrace, OfVersion10HasWholeMillisecondsAndNoDirection) {
  const TraceFrame read = the_frame(header_1_0, "     1)    1841 0001 8 00 11 22 33 44 55 66 77 ");
  EXPECT_EQ(read.time, Time{} + 1841ms);
  EXPECT_EQ(read.channel, "can0");
  EXPECT_EQ(read.direction, TraceDirection::unknown);
  EXPECT_EQ(read.frame, Frame::data_frame(1, {0, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77}));
}

TEST(TrcTrace, OfVersion10HasRemoteAndErrorFramesAndWarnings) {
  EXPECT_EQ(the_frame(header_1_0, "4) 1844 0100 3 RTR").frame, Frame::remote_frame(0x100, 3));
  EXPECT_TRUE(the_frame(header_1_0, "2) 1842 0008 4 ERROR 00 19 08 08").frame.is_error());
  EXPECT_EQ(read_of(header_1_0, "3) 1843 FFFFFFFF 4 00 00 00 04 ------BUSLIGHT"), TraceRead::end);
}

TEST(TrcTrace, OfVersion11HasTheDirectionAsType) {
  const TraceFrame read = the_frame(header_1_1, "1)      1059.9  Rx         0300  2  00 AA");
  EXPECT_EQ(read.time, noon + 1059900us);
  EXPECT_EQ(read.direction, TraceDirection::received);
  EXPECT_EQ(read.frame, Frame::data_frame(0x300, {0, 0xAA}));
  EXPECT_EQ(the_frame(header_1_1, "2) 7468.9 Tx 0000 8 RTR").frame, Frame::remote_frame(0, 8));
  EXPECT_EQ(read_of(header_1_1, "3) 17540.3 Warng FFFFFFFF 4 00 00 00 08 BUSHEAVY"),
            TraceRead::end);
  EXPECT_TRUE(the_frame(header_1_1, "4) 6180.5 Error 0008 4 00 19 08 00").frame.is_error());
}

TEST(TrcTrace, OfVersions12And13HasTheBus) {
  const TraceFrame one = the_frame(header_1_2, "1) 1059.900 2 Tx 18EFC034 2 00 AA");
  EXPECT_EQ(one.channel, "can1");
  EXPECT_EQ(one.direction, TraceDirection::sent);
  EXPECT_EQ(one.frame, Frame::data_frame(0x18EFC034, {0, 0xAA}));
  const TraceFrame other = the_frame(header_1_3, "1)  17535.4 1  Tx  00000100 -  2    00 01");
  EXPECT_EQ(other.channel, "can0");
  EXPECT_TRUE(other.frame.is_extended()) << "eight digits";
  EXPECT_EQ(other.frame.length, 2);
}

TEST(TrcTrace, OfVersion20HasTypesOfTwoLetters) {
  const TraceFrame read = the_frame(header_2_0, "1  1059.900 DT     0300 Rx 2  00 04");
  EXPECT_EQ(read.time, noon + 1059900us);
  EXPECT_EQ(read.direction, TraceDirection::received);
  EXPECT_EQ(read.frame, Frame::data_frame(0x300, {0, 4}));
  EXPECT_EQ(the_frame(header_2_0, "2 1.5 RR 0100 Tx 3").frame, Frame::remote_frame(0x100, 3));
}

TEST(TrcTrace, OfVersion21HasBusAndDataLengthCode) {
  const TraceFrame read = the_frame(
      header_2_1, "      1     17535.400 DT 2  00000100 Tx -  8    00 11 22 33 44 55 66 77 ");
  EXPECT_EQ(read.time, noon + 17535400us);
  EXPECT_EQ(read.channel, "can1");
  EXPECT_EQ(read.direction, TraceDirection::sent);
  EXPECT_EQ(read.frame.length, 8);
  EXPECT_EQ(read.frame.data[7], 0x77);
  EXPECT_TRUE(the_frame(header_2_1, "2 1.5 ER 1 - Rx - 5 04 00 02 00 00").frame.is_error());
}

// Error frames in PEAK's documentation: 1 bit, 2 form, 4 stuff, 8 other; then direction (0: while
// sending), position, and the counters of reception and transmission.
TEST(TrcTrace, TellsWhichErrorItIs) {
  const auto error = [](const auto& header, std::string_view line) {
    return std::string(FrameText(the_frame(header, std::string(line)).frame).view());
  };
  EXPECT_EQ(error(header_1_0, "2) 1842 0008 4 ERROR 00 19 08 10"), "20000288#0000801900001008");
  EXPECT_EQ(error(header_1_1, "4) 6180.5 Error 0001 4 01 0A 08 00"), "20000288#0000010A00000008");
  EXPECT_EQ(error(header_2_1, "2 1.5 ER 1 - Rx - 5 04 00 02 00 00"), "20000288#0000840200000000");
  EXPECT_EQ(error(header_2_1, "2 1.5 ER 1 - Rx - 2 04 00"), "20000080#0000000000000000");
}

TEST(TrcTrace, PassesOverStatusAndCountersAndCountsFdFrames) {
  for (const std::string_view type : {"ST", "EC", "EV"}) {
    const std::string line = "2 17540.300 " + std::string(type) + " 1 - Rx -  4    00 00 00 08";
    EXPECT_EQ(read_of(header_2_1, line), TraceRead::end) << type;
  }
  for (const std::string_view type : {"FD", "FB", "FE", "BI"}) {
    const std::string content = std::string(header_2_1) + "2 1.5 " + std::string(type) +
                                " 1 0100 Rx - 9 01 02 03 04 05 06 07 08 09 0A 0B 0C\n";
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    ASSERT_EQ(trace->next(frame), TraceRead::fd);
    EXPECT_EQ(frame.fd.length, 12) << "by the data length code 9";
    EXPECT_EQ(frame.fd.data[11], 12);
    EXPECT_EQ(trace->next(frame), TraceRead::end);
    EXPECT_EQ(trace->fd_frames(), 1U) << type;
  }
}

// A tab between the first two columns is left to the tolerant path: the fast path must give the
// same result.
void expect_line_read_alike(std::string_view header, const std::string& line) {
  const std::size_t blank = line.find(' ', line.find_first_not_of(' '));
  if (blank == std::string::npos) return;
  std::string with_tab = line;
  with_tab[blank] = '\t';
  expect_read_alike(std::string(header) + line + "\n", std::string(header) + with_tab + "\n");
}

TEST(TrcTrace, IsReadAlikeByTheQuickAndTheCarefulWay) {
  constexpr std::pair<std::string_view, std::string_view> usual[] = {
      {header_1_0, "     1)    1841 0001 8 00 11 22 33 44 55 66 77 "},
      {header_1_0, "     1)    1841.0 0001 0 RTR"},
      {header_1_1, "     2)  1059.9  Rx         0300  2  00 AA"},
      {header_1_1, "     3)  1060.0  Tx     0301  0  "},
      {header_1_2, "1) 1059.900 2 Tx 18EFC034 2 00 AA"},
      {header_1_3, "1)  17535.4 1  Tx  00000100 -  2    00 01"},
      {header_2_0, "1  1059.900 DT     0300 Rx 2  00 04"},
      {header_2_1, "      1     17535.400 DT 2  0100 Tx -  3    00 11 22 "}};
  for (const auto& [header, line] : usual) {
    expect_line_read_alike(header, std::string(line));
    for (std::size_t at = 0; at < line.size(); ++at) {
      for (const char other : std::string_view("0189AFGafgxdrRT. );-\0\xFF", 22)) {
        std::string replaced(line);
        replaced[at] = other;
        ASSERT_NO_FATAL_FAILURE(expect_line_read_alike(header, replaced));
        std::string inserted(line);
        inserted.insert(at, 1, other);
        ASSERT_NO_FATAL_FAILURE(expect_line_read_alike(header, inserted));
      }
    }
  }
}

TEST(TrcTrace, HasItsColumnsInTheOrderThatTheFileSays) {
  const std::string_view header = ";$FILEVERSION=2.1\n;$COLUMNS=O,B,T,I,L,d,D\n";
  const TraceFrame read = the_frame(header, "0.125 2 DT 0185 1 Rx 7F");
  EXPECT_EQ(read.time, Time{} + 125us);
  EXPECT_EQ(read.channel, "can1");
  EXPECT_EQ(read.frame, Frame::data_frame(0x185, {0x7F}));
}

TEST(TrcTrace, WithALineThatCannotBeReadSaysSo) {
  for (const std::string_view line :
       {"rubbish", "1 x DT 1 0185 Rx - 1 00", "1 1.5 DT x 0185 Rx - 1 00", "1 1.5",
        "1 1.5 DT 0 0185 Rx - 1 00", "1 1.5 DT 1 0800 Rx - 1 00", "1 1.5 DT 1 20000000 Rx - 0",
        "1 1.5 DT 1 G185 Rx - 1 00", "1 1.5 DT 1 0185 Rx - 16 00", "1 1.5 DT 1 0185 Rx - 2 00",
        "1 1.5 DT 1 0185 Rx - 1 1FF", "1 1.5 DT 1 0185 Rx", ";$FILEVERSION=3.0",
        ";$COLUMNS=N,O,Q,D", ";$COLUMNS=N,O", ";$COLUMNS=", ";$STARTTIME=now"}) {
    EXPECT_EQ(read_of(header_2_1, line), TraceRead::bad) << line;
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_trc_test
