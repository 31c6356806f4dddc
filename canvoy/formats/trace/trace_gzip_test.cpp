// Logs compressed by gzip. `compressed` is the output of Python's gzip.compress(..., mtime=0) for
// the line beside it.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats::trace_gzip_test {
namespace {

using host::TemporaryFile;

// (1700000000.000125) can0 185#1E2F
constexpr std::array<std::uint8_t, 47> compressed = {
    0x1F, 0x8B, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x03, 0xD3, 0x30, 0x34, 0x37, 0x80, 0x02,
    0x3D, 0x20, 0x36, 0x34, 0x32, 0xD5, 0x54, 0x48, 0x4E, 0xCC, 0x33, 0x50, 0x30, 0xB4, 0x30, 0x55,
    0x36, 0x74, 0x35, 0x72, 0xE3, 0x02, 0x00, 0xC7, 0x7A, 0x70, 0x75, 0x22, 0x00, 0x00, 0x00};

std::string file() {
  return {reinterpret_cast<const char*>(compressed.data()), compressed.size()};
}

std::uint64_t frames_of(TraceReader& trace) {
  TraceFrame frame;
  while (trace.next(frame) != TraceRead::end) {
    EXPECT_EQ(frame.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  }
  return trace.frames();
}

TEST(GzipTrace, IsReadFromMemoryAndFromAFile) {
  const std::string content = file();
  auto trace = TraceReader::of(content);
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->format(), TraceFormat::candump);
  EXPECT_EQ(frames_of(*trace), 1U);
  EXPECT_EQ(trace->bad(), 0U);
  const TemporaryFile compressed_file(content);
  auto from_file = TraceReader::open(compressed_file.path());
  ASSERT_TRUE(from_file);
  EXPECT_EQ(frames_of(*from_file), 1U);
  EXPECT_EQ(from_file->position(), content.size());
}

// As made by `cat a.gz b.gz`, followed by zeros.
TEST(GzipTrace, OfSeveralPiecesIsReadToItsEnd) {
  const std::string content = file() + file() + file() + std::string(512, '\0');
  auto trace = TraceReader::of(content);
  ASSERT_TRUE(trace);
  EXPECT_EQ(frames_of(*trace), 3U);
  EXPECT_EQ(trace->bad(), 0U);
}

TEST(GzipTrace, ThatIsCutOrDamagedIsBadOnce) {
  std::string damaged = file();
  damaged[damaged.size() - 5] ^= 0x55;  // of the checksum
  for (const std::string& content : {file().substr(0, file().size() - 3), damaged}) {
    auto trace = TraceReader::of(content);
    ASSERT_TRUE(trace);
    EXPECT_EQ(frames_of(*trace), 1U);
    EXPECT_EQ(trace->bad(), 1U);
  }
}

TEST(GzipTrace, OfNoLogSaysWhatItLooksLike) {
  const TemporaryFile picture("\xFF\xD8\xFF\xE0");
  const auto trace = TraceReader::open(picture.path());
  ASSERT_FALSE(trace);
  EXPECT_NE(trace.error().line().find("it looks like a JPEG picture, not like a log"),
            std::string::npos);
}

}  // namespace
}  // namespace canvoy::formats::trace_gzip_test
