// Vector ASC, from Vector's description of the format and log2asc of can-utils.
#include <gtest/gtest.h>

#include "canvoy/can/frame_text.hpp"

#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_alike_test.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"

namespace canvoy::formats::trace_asc_test {
namespace {

constexpr std::string_view header =
    "date Tue Nov 14 22:13:20 2023\nbase hex  timestamps absolute\nno internal events logged\n";

TraceFrame the_frame(std::string_view line, std::string_view before = header) {
  const std::string content = std::string(before) + std::string(line);
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace);
  EXPECT_EQ(trace->format(), TraceFormat::asc);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame) << line << ": " << trace->problem();
  frame.channel = frame.channel == "can1" ? "can1" : "can0";
  return frame;
}

bool is_bad(std::string_view line) {
  const std::string content = std::string(header) + std::string(line) + "\n";
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  return trace && trace->next(frame) == TraceRead::bad && trace->where() == "line 4";
}

bool is_note(std::string_view line) {
  const std::string content = std::string(header) + std::string(line) + "\n";
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  return trace && trace->next(frame) == TraceRead::end && trace->notes_skipped() == 4;
}

TEST(AscTrace, HasTimeFromTheDateOfItsHeaderAndChannelFrom1) {
  const TraceFrame read = the_frame("   1.500000 2  185             Rx   d 2 1E 2F\n");
  EXPECT_EQ(read.time, Time{} + 1'700'000'001s + 500ms);
  EXPECT_EQ(read.channel, "can1");
  EXPECT_EQ(read.direction, TraceDirection::received);
  EXPECT_EQ(read.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
}

TEST(AscTrace, MarksA29BitIdentifierByAnX) {
  const TraceFrame read = the_frame("   0.000010 1  185x             Tx   d 1 FF\n");
  EXPECT_TRUE(read.frame.is_extended());
  EXPECT_EQ(read.frame.id, 0x185U);
  EXPECT_EQ(read.direction, TraceDirection::sent);
}

// A line with a leading tab is left to the tolerant path: the fast path must give the same result,
// for every character at every position of a line.
TEST(AscTrace, IsReadAlikeByTheQuickAndTheCarefulWay) {
  for (const std::string usual :
       {"   1.500000 2  185             Rx   d 2 1E 2F",
        "1234.000001 1  18EBFF00x       Tx d 8 01 A0 0F A6 60 3B D1 40  L",
        "0.000000 255 0 Rx d 0"}) {
    for (std::size_t at = 0; at <= usual.size(); ++at) {
      for (const char other : std::string_view("0189AFGafgxdrRT. \tX;-\0\xFF", 23)) {
        for (const bool insert : {false, true}) {
          std::string line = usual;
          if (insert || at == usual.size()) {
            line.insert(at, 1, other);
          } else {
            line[at] = other;
          }
          ASSERT_NO_FATAL_FAILURE(expect_read_alike(std::string(header) + line + "\n",
                                                    std::string(header) + "\t" + line + "\n"));
        }
      }
    }
  }
}

TEST(AscTrace, HasClassicFramesOnAChannelOfCanFd) {
  // As written by log2asc -f: BRS, ESI, code, length, bytes, duration, bits, flags (1000h: FD).
  const TraceFrame classic = the_frame(
      "   1.500000 CANFD   2 Rx        185                                   0 0 2  2 1E 2F   "
      "130000 "
      " 130        0 0 0 0 0 0\n");
  EXPECT_EQ(classic.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(classic.channel, "can1");
  EXPECT_EQ(classic.direction, TraceDirection::received);
  const TraceFrame named =
      the_frame("   1.5 CANFD 1 Tx 18EBFF00x Engine 0 0 1 1 FF 130000 130 0 0 0 0 0 0\n");
  EXPECT_EQ(named.frame, Frame::data_frame(0x18EBFF00, {0xFF}));
  EXPECT_EQ(named.direction, TraceDirection::sent);
  const TraceFrame remote = the_frame("   1.5 CANFD 1 Tx 185 0 0 4 0 130000 130 10 0 0 0 0 0\n");
  EXPECT_EQ(remote.frame, Frame::remote_frame(0x185, 4));
}

TEST(AscTrace, CountsFramesOfCanFd) {
  for (const std::string_view line :
       {"1.5 CANFD 1 Rx 185 1 0 2 2 1E 2F 130000 130 3000 0 0 0 0 0",
        "1.5 CANFD 1 Rx 185 0 0 9 12 1 2 3 4 5 6 7 8 9 A B C 130000 130 1000 0 0 0 0 0",
        "1.5 CANFD 1 Rx 185 0 0 2 2 1E 2F", "1.5 CANFD 1 Rx", "1.5 CANFD",
        "1.5 CANFD 1 Rx ErrorFrame Not Acknowledge error"}) {
    const std::string content = std::string(header) + std::string(line) + "\n";
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::fd) << line;
    EXPECT_EQ(trace->next(frame), TraceRead::end) << line;
    EXPECT_EQ(trace->fd_frames(), 1U) << line;
  }
}

// Vector's CANFD event: bit rate switch, error state, data length code, length, bytes.
TEST(AscTrace, TellsWhatAFrameOfCanFdHolds) {
  const auto fd_of = [](std::string_view line) {
    const std::string content = std::string(header) + std::string(line) + "\n";
    auto trace = TraceReader::of(content);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::fd) << line;
    EXPECT_EQ(frame.channel, "can1");
    EXPECT_EQ(frame.frame.id, 0x185U);
    return frame.fd;
  };
  const TraceFdContent twelve =
      fd_of("1.5 CANFD 2 Rx 185 1 0 9 12 1 2 3 4 5 6 7 8 9 A B C 130000 130 3000 0 0 0 0 0");
  EXPECT_EQ(twelve.length, 12);
  EXPECT_EQ(twelve.flags, TraceFdContent::bit_rate_switch);
  EXPECT_EQ(twelve.data[11], 0x0C);
  std::string bytes;
  for (int byte = 0; byte < 64; ++byte) bytes += " 5A";
  const TraceFdContent most =
      fd_of("1.5 CANFD 2 Tx 185 name 0 1 f 40" + bytes + " 130000 130 5000 0 0 0 0 0");
  EXPECT_EQ(most.length, 64) << "40h is how some programs write 64";
  EXPECT_EQ(most.flags, TraceFdContent::error_state);
  EXPECT_EQ(most.data[63], 0x5A);
}

TEST(AscTrace, WithoutAHeadIsReadInHexadecimalDigitsFromItsBeginning) {
  const auto read = [](std::string_view content) {
    auto trace = TraceReader::of(content);
    EXPECT_TRUE(trace) << content;
    TraceFrame frame;
    if (trace) {
      EXPECT_EQ(trace->format(), TraceFormat::asc);
      EXPECT_EQ(trace->next(frame), TraceRead::frame) << content;
    }
    return frame;
  };
  const TraceFrame first = read("   0.500000 1  18A             Rx   d 2 1E 2F\n");
  EXPECT_EQ(first.frame, Frame::data_frame(0x18A, {0x1E, 0x2F}));
  EXPECT_EQ(first.time, Time{} + 500ms);
  EXPECT_TRUE(read("// a remark\n\n 2.5 1 ErrorFrame\n").frame.is_error());
  EXPECT_FALSE(TraceReader::of("1.5 metres 2\n"));
  EXPECT_FALSE(TraceReader::of("1.5 1 18A Rx x 2\n"));
}

TEST(AscTrace, TakesALengthOfFortyHexadecimalForEightBytes) {
  EXPECT_EQ(the_frame("2.5 1  185  Rx   d 40 1 2 3 4 5 6 7 8").frame,
            Frame::data_frame(0x185, {1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(AscTrace, HasWhatVectorWritesBehindTheBytes) {
  const TraceFrame read = the_frame(
      "   3.098426 1  18EBFF00x       Rx d 8 01 A0 0F A6 60 3B D1 40    Length = 273910 BitCount = "
      "141 ID = 418119424x\r\n");
  EXPECT_EQ(read.frame, Frame::data_frame(0x18EBFF00, {1, 0xA0, 0x0F, 0xA6, 0x60, 0x3B, 0xD1, 64}));
}

TEST(AscTrace, HasRemoteFramesWithAndWithoutALength) {
  EXPECT_EQ(the_frame("2.5 1  701             Rx   r 4").frame, Frame::remote_frame(0x701, 4));
  EXPECT_EQ(the_frame("2.5 1  701             Rx   r").frame, Frame::remote_frame(0x701, 0));
  EXPECT_EQ(the_frame("2.52 3 200 Tx r Length = 1704000 BitCount = 145").frame,
            Frame::remote_frame(0x200, 0));
  EXPECT_EQ(the_frame("2.52 3 300 Tx r 8 Length = 1704000 BitCount = 145").frame,
            Frame::remote_frame(0x300, 8));
}

TEST(AscTrace, HasErrorFrames) {
  for (const std::string_view line :
       {"2.501 1 ErrorFrame", "2.501 1 ErrorFrame ECC: 10100010",
        "2.501 1 ErrorFrame Flags = 0xe CodeExt = 0x20a2 Code = 0x82 ID = 0 DLC = 0"}) {
    EXPECT_TRUE(the_frame(line).frame.is_error()) << line;
  }
}

// 10100010: a stuff error, on reception, in ID bits 28 to 21 (SJA1000, register ECC). 82h: the same
// kind and direction, by Vector's controller.
TEST(AscTrace, TellsWhichErrorItIs) {
  const auto error = [](std::string_view details) {
    const TraceFrame read = the_frame("2.501 1 ErrorFrame" + std::string(details));
    return std::string(FrameText(read.frame).view());
  };
  EXPECT_EQ(error(""), "20000080#0000000000000000");
  EXPECT_EQ(error(" ECC: 10100010"), "20000088#0000040200000000");
  EXPECT_EQ(error(" ECC: 11011001"), "20000088#0000801900000000") << "sent, in the ACK slot";
  EXPECT_EQ(error(" Flags = 0xe CodeExt = 0x20a2 Code = 0x82 ID = 0 DLC = 0"),
            "20000088#0000040000000000");
  EXPECT_EQ(error(" Flags = 0x1 Code = 0xa2"), "20000088#0000040200000000");
  EXPECT_EQ(error(" Flags = 0x0 Code = 0xa2"), "20000080#0000000000000000");
  EXPECT_EQ(error(" ECC: 1010"), "20000080#0000000000000000");
  EXPECT_EQ(error(" Flags = zz"), "20000080#0000000000000000");
}

TEST(AscTrace, InBaseDecHasDecimalIdentifiersAndBytes) {
  const TraceFrame read = the_frame("0.5 1 389 Rx d 2 30 255", "base dec timestamps absolute\n");
  EXPECT_EQ(read.frame, Frame::data_frame(389, {30, 255}));
  EXPECT_EQ(read.time, Time{} + 500ms) << "without a date, from the beginning of the trace";
}

TEST(AscTrace, WithRelativeTimesCountsFromTheEventBefore) {
  auto trace = TraceReader::of(
      "base hex timestamps relative\n"
      "0.5 1 185 Rx d 0\n"
      "0.25 1 Statistic: D 0 R 0\n"
      "0.125 1 185 Rx d 0\n");
  ASSERT_TRUE(trace);
  TraceFrame frame;
  ASSERT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(frame.time, Time{} + 500ms);
  ASSERT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(frame.time, Time{} + 875ms);
}

TEST(AscTrace, ADataLengthCodeAbove8StandsForEightBytes) {
  EXPECT_EQ(the_frame("0.5 1 185 Rx d f 1 2 3 4 5 6 7 8").frame.length, 8);
}

TEST(AscTrace, PassesOverEventsThatAreNoFrames) {
  for (const std::string_view line :
       {"", "// version 9.0.0", "Begin Triggerblock Sam Sep 30 15:06:13.191 2017",
        "End TriggerBlock", "0.000000 Start of measurement", "internal events logged",
        "0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0",
        "1.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%", "0.5 1 185 TxRq d 1 00",
        "3.297743 1  J1939TP FEE3p        6    0  0   -   Rx   d 23 A0 0F"}) {
    EXPECT_TRUE(is_note(line)) << line;
  }
}

TEST(AscTrace, WithALineThatCannotBeReadSaysSo) {
  for (const std::string_view line :
       {"rubbish", "1.2.3 1 185 Rx d 0", "1. 1 185 Rx d 0", "0.5 0 185 Rx d 0",
        "0.5 256 185 Rx d 0", "0.5 1 800 Rx d 0", "0.5 1 20000000x Rx d 0", "0.5 1 Engine Rx d 0",
        "0.5 1 185 Rx", "0.5 1 185 Rx e 0", "0.5 1 185 Rx d", "0.5 1 185 Rx d 10",
        "0.5 1 185 Rx d 2 00", "0.5 1 185 Rx d 1 100", "0.5 1 185 Rx d 1 G0", "0.5 1 185 Rx r G",
        "base oct timestamps absolute", "1000000000000.5 1 185 Rx d 0"}) {
    EXPECT_TRUE(is_bad(line)) << line;
  }
}

TEST(AscTrace, DatesAreReadInEnglishAndGermanWithAndWithoutAmAndPm) {
  const auto seconds = [](std::string_view text) {
    Duration since_1970{-1};
    return read_asc_date(text, since_1970) ? since_1970 : Duration{-1};
  };
  EXPECT_EQ(seconds("Tue Nov 14 22:13:20 2023"), 1'700'000'000s);
  EXPECT_EQ(seconds("Tue Nov 14 10:13:20.125 pm 2023"), 1'700'000'000s + 125ms);
  EXPECT_EQ(seconds("Die Nov 14 22:13:20.125 2023"), 1'700'000'000s + 125ms);
  EXPECT_EQ(seconds("Fre Mai 1 12:00:00 am 1970"), 120 * 24h);
  EXPECT_EQ(seconds("Thu Jan 1 12:00:00 pm 1970"), 12h);
  EXPECT_EQ(seconds("Don Okt 1 00:00:00 1970"), 273 * 24h);
  EXPECT_EQ(seconds("Son M\xE4r 1 00:00:00 1970"), 59 * 24h);
  EXPECT_EQ(seconds("Son M\xC3\xA4r 1 00:00:00 1970"), 59 * 24h);
  for (const std::string_view wrong :
       {"", "Tue", "Tue Foo 14 22:13:20 2023", "Tue Nov 31 22:13:20 2023", "Tue Nov 14 2023",
        "Tue Nov 14 24:13:20 2023", "Tue Nov 14 22:60:20 2023", "Tue Nov 14 22:13:61 2023",
        "Tue Nov 14 22:13:20", "Tue Nov 14 22:13:20 1969", "Tue Nov 14 22:13 2023"}) {
    EXPECT_EQ(seconds(wrong), Duration{-1}) << wrong;
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_asc_test
