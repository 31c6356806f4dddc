// Reading ahead gives the same result as reading item by item.
#include "canvoy/tools/watch/log_reader.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace canvoy::tools::log_reader_test {
namespace {

using formats::TraceFrame;
using formats::TraceRead;
using formats::TraceReader;

class LogReaderTest : public testing::Test {
 protected:
  ~LogReaderTest() override { std::filesystem::remove(path_); }

  void write(std::string_view text) { std::ofstream(path_) << text; }
  TraceReader open() const { return *TraceReader::open(path_); }

  /// A line for each result of next(), with its details.
  template <class Reader>
  static std::string told(Reader& reader, std::size_t count_max = 1'000'000) {
    std::string all;
    TraceFrame heard;
    for (std::size_t i = 0; i < count_max; ++i) {
      const TraceRead read = reader.next(heard);
      if (read == TraceRead::end) break;
      all += std::to_string(static_cast<int>(read)) + ' ';
      if (read == TraceRead::bad) {
        all += reader.where() + ' ' + std::string(reader.problem()) + '\n';
        continue;
      }
      all += std::to_string(heard.time.time_since_epoch().count()) + ' ';
      all += std::string(heard.channel) + ' ' + std::to_string(heard.frame.id) + ' ';
      all += std::to_string(static_cast<int>(heard.direction)) + ' ';
      for (const std::uint8_t byte : heard.frame.payload()) all += std::to_string(byte) + '.';
      if (read == TraceRead::fd) all += " fd " + std::to_string(heard.fd.length);
      all += '\n';
    }
    return all + std::to_string(reader.frames()) + ' ' + std::to_string(reader.bad()) + ' ' +
           std::to_string(reader.fd_frames());
  }

  const std::string path_ = std::string(testing::TempDir()) + "log_reader_" +
                            std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                            testing::UnitTest::GetInstance()->current_test_info()->name() + ".log";
};

/// More than all batches hold, with two buses, directions, bad lines and frames of CAN FD.
std::string long_log(int lines) {
  std::string log;
  for (int i = 0; i < lines; ++i) {
    char text[80];
    const char* const bus = i % 1000 < 500 ? "can0" : "can1";
    std::snprintf(text, sizeof text, "(%010d.%06d) %s %03X#%02X%02X%s\n", 1'700'000'000 + i / 100,
                  i % 100, bus, 0x180 + i % 127, i % 256, i / 256 % 256, i % 3 == 0 ? " R" : "");
    log += text;
    if (i % 777 == 0) log += "(1.0) can0 nonsense\n";
    if (i % 1111 == 0) log += "(1700000000.000000) can1 185##1AABBCC\n";
  }
  return log;
}

TEST_F(LogReaderTest, ReadsAheadWhatIsReadOneByOne) {
  write(long_log(50'000));
  TraceReader one_by_one = open();
  const std::string wanted = told(one_by_one);
  EXPECT_NE(wanted.find("fd 3"), std::string::npos);
  EXPECT_TRUE(wanted.ends_with("\n50000 65 46")) << wanted.substr(wanted.size() - 40);
  LogReader ahead(open());
  EXPECT_EQ(told(ahead), wanted);
  EXPECT_EQ(ahead.position(), ahead.size());
  TraceFrame heard;
  EXPECT_EQ(ahead.next(heard), TraceRead::end);
  EXPECT_EQ(ahead.next(heard), TraceRead::end);
  LogReader not_ahead(open(), std::uint64_t{1} << 40);
  EXPECT_EQ(told(not_ahead), wanted);
}

TEST_F(LogReaderTest, CountsWhatWasTakenWhereSomebodyStops) {
  write(long_log(50'000));
  for (const std::size_t taken : {std::size_t{0}, std::size_t{3}, std::size_t{5000}}) {
    TraceReader one_by_one = open();
    LogReader ahead(open());
    EXPECT_EQ(told(ahead, taken), told(one_by_one, taken));
  }
}

TEST_F(LogReaderTest, ALogThatHasNothingEnds) {
  write("");
  LogReader ahead(open(), 0);
  TraceFrame heard;
  EXPECT_EQ(ahead.next(heard), TraceRead::end);
  EXPECT_EQ(ahead.position(), 0U);
}

}  // namespace
}  // namespace canvoy::tools::log_reader_test
