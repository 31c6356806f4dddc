#include "canvoy/can/host/candump_log.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <string>

#include "canvoy/can/host/temporary_file_test.hpp"

namespace canvoy::host::candump_log_test {
namespace {

const Frame tpdo = Frame::data_frame(0x185, {0x1E, 0x2F});

Frame bus_off_frame() {
  Frame frame = Frame::data_frame(0, {0, 0, 0, 0, 0, 0, 0, 0});
  frame.id = 0x40;
  frame.flags = FrameFlags::error;
  return frame;
}

std::string line_of(Duration since_1970, std::string_view interface, const Frame& frame) {
  std::string text;
  append_log_line(text, since_1970, interface, frame);
  return text;
}

TEST(LogLine, IsWrittenAsCandumpDoes) {
  EXPECT_EQ(line_of(1700000000s + 125us, "can0", tpdo), "(1700000000.000125) can0 185#1E2F\n");
  EXPECT_EQ(line_of(1700000000s, "vcan1", Frame::remote_frame(0x701, 1)),
            "(1700000000.000000) vcan1 701#R1\n");
  EXPECT_EQ(line_of(1700000000s + 999999us, "can0", Frame::data_frame(0x12345678, {})),
            "(1700000000.999999) can0 12345678#\n");
  EXPECT_EQ(line_of(1700000000s, "can0", bus_off_frame()),
            "(1700000000.000000) can0 20000040#0000000000000000\n");
}

TEST(LogLine, SecondsHaveTenDigitsAtLeast) {
  EXPECT_EQ(line_of(5s + 7us, "can0", tpdo), "(0000000005.000007) can0 185#1E2F\n");
  EXPECT_EQ(line_of(-5s, "can0", tpdo), "(0000000000.000000) can0 185#1E2F\n");
}

TEST(ParseLogLine, ReadsTimeInterfaceAndFrame) {
  const LogLine line = parse_log_line("(1700000000.000125) can0 185#1E2F");
  EXPECT_EQ(line.kind, LogLineKind::frame);
  EXPECT_EQ(line.time, Time{1700000000s + 125us});
  EXPECT_EQ(line.interface, "can0");
  EXPECT_EQ(line.frame, tpdo);
}

TEST(ParseLogLine, TakesOtherBlanksDirectionsAndLineEnds) {
  for (const char* text :
       {"(1.000000)   can0   185#1E2F", " (1.000000)\tcan0\t185#1E2F", "(1.000000) can0 185#1E2F R",
        "(1.000000) can0 185#1E2F T B E", "(1.000000) can0 185#1E2F\r"}) {
    EXPECT_EQ(parse_log_line(text).kind, LogLineKind::frame) << text;
    EXPECT_EQ(parse_log_line(text).frame, tpdo) << text;
  }
}

TEST(ParseLogLine, NanosecondsAreCutToMicrosecondsAndShortFractionsAreFractions) {
  EXPECT_EQ(parse_log_line("(1.000001999) can0 185#").time, Time{1s + 1us});
  EXPECT_EQ(parse_log_line("(1.5) can0 185#").time, Time{1500ms});
}

TEST(ParseLogLine, BlankLinesCommentsAndDropCountsAreNotes) {
  for (const char* text : {"", "  ", "\r", "# a comment",
                           "DROPCOUNT: dropped 2 CAN frames on 'can0' socket (total drops 2)"}) {
    EXPECT_EQ(parse_log_line(text).kind, LogLineKind::note) << text;
  }
}

TEST(ParseLogLine, ACanFdFrameIsKnownAsSuch) {
  EXPECT_EQ(parse_log_line("(1.000000) can0 123##0112233").kind, LogLineKind::fd);
}

class ParseLogLineRefuses : public testing::TestWithParam<const char*> {};

TEST_P(ParseLogLineRefuses, WithAReason) {
  const LogLine line = parse_log_line(GetParam());
  EXPECT_EQ(line.kind, LogLineKind::malformed) << GetParam();
  EXPECT_FALSE(line.problem.empty()) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Texts, ParseLogLineRefuses,
                         testing::Values("can0 185#1E2F", "(1.000000 can0 185#1E2F", "() can0 185#",
                                         "(1) can0 185#", "(1.) can0 185#", "(.5) can0 185#",
                                         "(-1.0) can0 185#", "(1.0x) can0 185#",
                                         "(1.0000000000) can0 185#", "(1000000000000.0) can0 185#",
                                         "(1.0)", "(1.0) can0", "(1.0) 185#1E2F", "(1.0) can0 185",
                                         "(1.0) can0 185#1", "(1.0) can0 185#xx",
                                         "(1.0) can0 800#"));

TEST(CandumpWriter, WritesALineForEachFrameFromItsEpochOn) {
  const TemporaryFile file;
  {
    Result<CandumpWriter> log = CandumpWriter::create(file.path(), 1700000000s);
    ASSERT_TRUE(log);
    EXPECT_TRUE(log->write(Time{125us}, "can0", tpdo));
    EXPECT_TRUE(log->write(Time{1s}, "can1", Frame::remote_frame(0x701, 1)));
    EXPECT_EQ(log->lines(), 2U);
  }
  EXPECT_EQ(file.content(), "(1700000000.000125) can0 185#1E2F\n(1700000001.000000) can1 701#R1\n");
}

TEST(CandumpWriter, FlushHandsTheLinesToThoseWhoReadAlong) {
  const TemporaryFile file;
  Result<CandumpWriter> log = CandumpWriter::create(file.path());
  ASSERT_TRUE(log);
  EXPECT_TRUE(log->write(Time{}, "can0", tpdo));
  EXPECT_TRUE(log->flush());
  EXPECT_EQ(file.content(), "(0000000000.000000) can0 185#1E2F\n");
}

TEST(CandumpWriter, WhoFollowsTheFileHasTheLinesASecondLaterAtMost) {
  const TemporaryFile file;
  Result<CandumpWriter> log = CandumpWriter::create(file.path());
  ASSERT_TRUE(log);
  EXPECT_TRUE(log->flush_each_second(Time{50s}));
  EXPECT_TRUE(log->write(Time{}, "can0", tpdo));
  EXPECT_TRUE(log->flush_each_second(Time{50s + 999ms}));
  EXPECT_EQ(file.content(), "");
  EXPECT_TRUE(log->flush_each_second(Time{51s}));
  EXPECT_EQ(file.content(), "(0000000000.000000) can0 185#1E2F\n");
  EXPECT_TRUE(log->write(Time{}, "can0", tpdo));
  EXPECT_TRUE(log->flush_each_second(Time{51s + 999ms}));
  EXPECT_EQ(file.content(), "(0000000000.000000) can0 185#1E2F\n");
}

TEST(CandumpWriter, AFileThatCannotBeMadeIsRefusedInOneLine) {
  const Result<CandumpWriter> log = CandumpWriter::create("/no/such/folder/bus.log");
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().line(),
            "/no/such/folder/bus.log: No such file or directory; check the path");
}

TEST(CandumpWriter, AFullDiskIsReportedOnceWithWhatToDo) {
  Result<CandumpWriter> log = CandumpWriter::create("/dev/full");
  ASSERT_TRUE(log);
  EXPECT_TRUE(log->write(Time{}, "can0", tpdo));
  const Result<void> flushed = log->flush();
  ASSERT_FALSE(flushed);
  EXPECT_EQ(flushed.error().line(),
            "/dev/full: No space left on device; make room, or write the log elsewhere");
  EXPECT_TRUE(log->write(Time{}, "can0", tpdo));
  EXPECT_TRUE(log->flush());
}

TEST(CandumpWriter, AFullDiskIsFoundOutWithoutAFlush) {
  Result<CandumpWriter> log = CandumpWriter::create("/dev/full");
  ASSERT_TRUE(log);
  int failures = 0;
  for (int i = 0; i < 5000; ++i) failures += log->write(Time{}, "can0", tpdo) ? 0 : 1;
  EXPECT_EQ(failures, 1);
}

TEST(CandumpWriter, AFileThatCannotGrowEndsWithAWholeLine) {
  const TemporaryFile file;
  const auto fill = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'010, 100'010};
    setrlimit(RLIMIT_FSIZE, &limit);
    Result<CandumpWriter> log = CandumpWriter::create(file.path());
    int failures = 0;
    for (int i = 0; i < 5000; ++i) failures += log->write(Time{}, "can0", tpdo) ? 0 : 1;
    ::_exit(failures);
  };
  EXPECT_EXIT(fill(), testing::ExitedWithCode(1), "");
  // A line has 34 characters.
  EXPECT_EQ(file.content().size(), 100'010U / 34 * 34);
  EXPECT_TRUE(file.content().ends_with("185#1E2F\n"));
}

TEST(CandumpReader, GivesTheFramesOneByOneAndCountsWhatItSkips) {
  const TemporaryFile file(
      "# made by hand\n"
      "(1.000000) can0 185#1E2F\n"
      "\n"
      "(2.000000) can1 123##0112233\n"
      "(3.000000) can1 701#R");
  Result<CandumpReader> log = CandumpReader::open(file.path());
  ASSERT_TRUE(log);
  const Result<std::optional<LogEntry>> first = log->next();
  ASSERT_TRUE(first && *first);
  EXPECT_EQ((*first)->frame, tpdo);
  const Result<std::optional<LogEntry>> second = log->next();
  ASSERT_TRUE(second && *second);
  EXPECT_EQ((*second)->time, Time{3s});
  EXPECT_EQ((*second)->interface, "can1");
  EXPECT_EQ((*second)->frame, Frame::remote_frame(0x701, 0));
  const Result<std::optional<LogEntry>> end = log->next();
  ASSERT_TRUE(end);
  EXPECT_FALSE(*end);
  EXPECT_EQ(log->fd_skipped(), 1U);
  EXPECT_EQ(log->notes_skipped(), 2U);
}

TEST(CandumpReader, AMalformedLineIsNamedByItsNumberAndTheNextOneIsRead) {
  const TemporaryFile file("(1.000000) can0 185#1E2F\n(2.0) can0 185#1\n(3.000000) can0 185#\n");
  Result<CandumpReader> log = CandumpReader::open(file.path());
  ASSERT_TRUE(log);
  ASSERT_TRUE(log->next());
  const Result<std::optional<LogEntry>> malformed = log->next();
  ASSERT_FALSE(malformed);
  EXPECT_EQ(malformed.error().line(),
            file.path() +
                " line 2: the data is not made of pairs of hexadecimal digits; a line is written "
                "(1700000000.000125) can0 185#1E2F");
  const Result<std::optional<LogEntry>> next = log->next();
  ASSERT_TRUE(next && *next);
  EXPECT_EQ((*next)->time, Time{3s});
}

TEST(CandumpReader, AFileWithoutLineFeedsDoesNotFillTheMemory) {
  const TemporaryFile file(std::string(1'000'000, '(') + "\n(1.000000) can0 185#\n");
  Result<CandumpReader> log = CandumpReader::open(file.path());
  ASSERT_TRUE(log);
  const Result<std::optional<LogEntry>> malformed = log->next();
  ASSERT_FALSE(malformed);
  EXPECT_EQ(malformed.error().what, "it is longer than 512 characters");
  EXPECT_TRUE(*log->next());
}

TEST(CandumpReader, WhatCannotBeReadIsRefusedInOneLine) {
  const Result<CandumpReader> missing = CandumpReader::open("no-such.log");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().line(), "no-such.log: No such file or directory; check the path");
  Result<CandumpReader> folder = CandumpReader::open("/tmp");
  ASSERT_TRUE(folder);
  const Result<std::optional<LogEntry>> entry = folder->next();
  ASSERT_FALSE(entry);
  EXPECT_EQ(entry.error().line(), "/tmp: Is a directory");
}

TEST(CandumpReader, ReadsBackWhatTheWriterWrote) {
  const TemporaryFile file;
  const Frame frames[] = {tpdo, Frame::remote_frame(0x701, 1),
                          Frame::data_frame(0x12345678, {1, 2, 3}), bus_off_frame()};
  {
    Result<CandumpWriter> log = CandumpWriter::create(file.path(), 1700000000s);
    ASSERT_TRUE(log);
    for (const Frame& frame : frames) EXPECT_TRUE(log->write(Time{1ms}, "can0", frame));
  }
  Result<CandumpReader> log = CandumpReader::open(file.path());
  ASSERT_TRUE(log);
  for (const Frame& frame : frames) {
    const Result<std::optional<LogEntry>> entry = log->next();
    ASSERT_TRUE(entry && *entry);
    EXPECT_EQ((*entry)->frame, frame);
    EXPECT_EQ((*entry)->time, Time{1700000000s + 1ms});
  }
}

}  // namespace
}  // namespace canvoy::host::candump_log_test
