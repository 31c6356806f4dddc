// Traces of any format: no content is a fatal error, and frames are counted (the format here is
// that of candump; each format has a test of its own).
#include "canvoy/formats/trace/trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>

#include "canvoy/can/host/temporary_file_test.hpp"

namespace canvoy::formats::trace_test {
namespace {

using host::TemporaryFile;
using testing::HasSubstr;

TEST(Trace, OfALogThatIsNotThereSaysSoInOneLine) {
  const auto trace = TraceReader::open("/nowhere/bus.log");
  ASSERT_FALSE(trace);
  EXPECT_EQ(trace.error().line(), "/nowhere/bus.log: No such file or directory; check the path");
}

TEST(Trace, OfAFolderIsRefused) {
  const auto trace = TraceReader::open("/tmp");
  ASSERT_FALSE(trace);
  EXPECT_EQ(trace.error().line(), "/tmp: it is a folder; name a log file");
}

/// EINTR is from a call before that has nothing to do with the file.
TEST(Trace, IsReadToItsEndWhateverErrnoWasBefore) {
  const TemporaryFile file("(1.000000) can0 185#1E2F\n(2.000000) can0 186#\n");
  errno = EINTR;
  auto trace = TraceReader::open(file.path());
  ASSERT_TRUE(trace);
  TraceFrame frame;
  for (const std::uint32_t id : {0x185U, 0x186U}) {
    errno = EINTR;
    ASSERT_EQ(trace->next(frame), TraceRead::frame);
    EXPECT_EQ(frame.frame.id, id);
  }
  EXPECT_EQ(trace->next(frame), TraceRead::end);
}

TEST(Trace, OfAnotherKindOfFileNamesTheKindsThatAreRead) {
  const TemporaryFile file("Dear reader,\nthis is a letter.\n");
  const auto trace = TraceReader::open(file.path());
  ASSERT_FALSE(trace);
  EXPECT_THAT(
      trace.error().line(),
      HasSubstr("it looks like text without frames, not like a log; these are read: candump "
                "log (.log), Vector ASC (.asc), Vector BLF (.blf)"));
}

// A log from another system: in UTF-16, after a byte order mark, with carriage returns alone.
TEST(Trace, InOtherEncodingsIsReadAlike) {
  std::string text;
  for (int number = 0; number < 5000; ++number) {
    text += "(1700000000.00" + std::to_string(1000 + number) + ") b\xC3\xBCs 185#1E2F\n";
  }
  std::string utf16 = "\xFF\xFE";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_umlaut = text[at] == '\xC3';
    utf16 += is_umlaut ? '\xFC' : text[at];
    utf16 += '\0';
    if (is_umlaut) ++at;
  }
  std::string big = "\xFE\xFF";
  for (std::size_t at = 2; at < utf16.size(); at += 2) big += {utf16[at + 1], utf16[at]};
  std::string returns = text;
  std::ranges::replace(returns, '\n', '\r');
  for (const std::string& content : {text, "\xEF\xBB\xBF" + text, utf16, big, returns}) {
    const TemporaryFile file(content);
    for (const bool is_file : {true, false}) {
      auto trace = is_file ? TraceReader::open(file.path()) : TraceReader::of(content);
      ASSERT_TRUE(trace);
      TraceFrame frame;
      for (int number = 0; number < 5000; ++number) {
        ASSERT_EQ(trace->next(frame), TraceRead::frame) << number << trace->problem();
        ASSERT_EQ(frame.channel, "b\xC3\xBCs");
        ASSERT_EQ(frame.time, Time{} + 1'700'000'000s + Duration{1000 + number});
      }
      EXPECT_EQ(trace->next(frame), TraceRead::end);
      EXPECT_EQ(trace->position(), content.size());
    }
  }
}

TEST(Trace, OfAnEmptyFileHasNoFrames) {
  for (const std::string content : {"", "\n", "\r\n\r\n", "  \n"}) {
    const TemporaryFile file(content);
    auto trace = TraceReader::open(file.path());
    ASSERT_TRUE(trace) << content;
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::end);
    EXPECT_EQ(trace->next(frame), TraceRead::end) << "and stays at its end";
  }
}

TEST(Trace, ShowsABadLineWithItsNumberAndReadsOn) {
  auto trace = TraceReader::of(
      "(1700000000.000125) can0 185#1E2F\n"
      "# a remark\n"
      "(1700000000.000225) can0 185#1E2\n"
      "(1700000000.000325) can0 185#1E\n");
  ASSERT_TRUE(trace);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(trace->where(), "line 1");
  EXPECT_EQ(trace->next(frame), TraceRead::bad);
  EXPECT_EQ(trace->where(), "line 3");
  EXPECT_FALSE(trace->problem().empty());
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(trace->where(), "line 4");
  EXPECT_EQ(trace->next(frame), TraceRead::end);
  EXPECT_EQ(trace->frames(), 2U);
  EXPECT_EQ(trace->bad(), 1U);
  EXPECT_EQ(trace->notes_skipped(), 1U);
}

TEST(Trace, ReadsALastLineWithoutALineFeed) {
  auto trace = TraceReader::of("(1700000000.000125) can0 185#1E2F");
  ASSERT_TRUE(trace);
  TraceFrame frame;
  ASSERT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(frame.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(trace->next(frame), TraceRead::end);
}

// A file larger than the buffer: lines cross its ends.
TEST(Trace, OfAnyLengthIsReadLineByLine) {
  std::string content;
  constexpr std::uint64_t count = 30'000;
  for (std::uint64_t number = 0; number < count; ++number) {
    content += "(" + std::to_string(1'700'000'000 + number) + ".000125) can0 185#";
    content += number % 2 == 0 ? "1E2F\n" : "1E2F30\n";
  }
  const TemporaryFile file(content);
  auto trace = TraceReader::open(file.path());
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->size(), content.size());
  TraceFrame frame;
  for (std::uint64_t number = 0; number < count; ++number) {
    ASSERT_EQ(trace->next(frame), TraceRead::frame) << number;
    const Duration expected = std::chrono::seconds{1'700'000'000 + number} + 125us;
    ASSERT_EQ(frame.time.time_since_epoch(), expected);
    ASSERT_EQ(frame.frame.length, number % 2 == 0 ? 2 : 3);
  }
  EXPECT_EQ(trace->next(frame), TraceRead::end);
  EXPECT_EQ(trace->position(), content.size());
}

// A line of any length is one bad line, and the next one has its number.
TEST(Trace, WithAnEndlessLineIsReadOnBehindIt) {
  for (const std::size_t length : {4097U, 65'535U, 65'536U, 65'537U, 300'000U, 1'000'000U}) {
    const TemporaryFile file("(1700000000.000125) can0 185#1E2F\n" + std::string(length, 'x') +
                             "\n(1700000000.000125) can0 185#1E\n");
    auto trace = TraceReader::open(file.path());
    ASSERT_TRUE(trace);
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::frame);
    EXPECT_EQ(trace->next(frame), TraceRead::bad) << length;
    EXPECT_EQ(trace->problem(), "it is longer than 4096 characters");
    EXPECT_EQ(trace->where(), "line 2");
    EXPECT_EQ(trace->next(frame), TraceRead::frame) << length;
    EXPECT_EQ(trace->where(), "line 3") << length;
    EXPECT_EQ(trace->next(frame), TraceRead::end);
  }
}

}  // namespace
}  // namespace canvoy::formats::trace_test
