// Logs in the form that other programs expect: the text of an ASC file is that of log2asc of
// can-utils.
#include "canvoy/formats/trace/trace_writer.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

#include "canvoy/can/host/temporary_file_test.hpp"

namespace canvoy::formats::trace_writer_test {
namespace {

using host::TemporaryFile;

constexpr Time start = Time{} + 1'700'000'000s;

Frame error_frame() {
  Frame frame = Frame::data_frame(0x80, {0, 0, 0, 0, 0, 0, 0, 0});
  frame.flags = FrameFlags::error;
  return frame;
}

std::vector<TraceFrame> some_frames() {
  return {{start, Frame::data_frame(0x185, {0x1E, 0x2F}), "can0", TraceDirection::received},
          {start + 1500ms, Frame::data_frame(0x18DAF110, {1, 2, 3, 4, 5, 6, 7, 8}), "can1",
           TraceDirection::received},
          {start + 2500ms, Frame::remote_frame(0x701, 0), "can0", TraceDirection::sent},
          {start + 2600ms, Frame::remote_frame(0x701, 4), "can0", TraceDirection::received},
          {start + 3500ms, error_frame(), "can0", TraceDirection::unknown},
          {start + 4500001us, Frame::data_frame(0, {}), "can1", TraceDirection::received}};
}

std::string written(const TraceFormat& format, const std::vector<TraceFrame>& frames,
                    std::string_view comment = {}) {
  const TemporaryFile file;
  {
    auto writer = TraceWriter::create(file.path(), format);
    EXPECT_TRUE(writer);
    for (const TraceFrame& frame : frames) EXPECT_TRUE(writer->write(frame, comment));
  }
  return file.content();
}

TEST(TraceWriter, WritesWhatLog2ascWrites) {
  EXPECT_EQ(written(TraceFormat::asc, some_frames()),
            "date Tue Nov 14 22:13:20 2023\n"
            "base hex  timestamps absolute\n"
            "no internal events logged\n"
            "   0.000000 1  185             Rx   d 2 1E 2F\n"
            "   1.500000 2  18DAF110x       Rx   d 8 01 02 03 04 05 06 07 08\n"
            "   2.500000 1  701             Tx   r 0\n"
            "   2.600000 1  701             Rx   r 4\n"
            "   3.500000 1  ErrorFrame\n"
            "   4.500001 2  0               Rx   d 0\n");
}

/// The ASC file of two frames, the second 10 s before the first, and the number counted as early.
std::pair<std::string, std::uint64_t> written_backwards(std::optional<Time> begin) {
  const TemporaryFile file;
  std::uint64_t early = 0;
  {
    const host::Descriptor out{::open(file.path().c_str(), O_WRONLY | O_CLOEXEC)};
    auto writer = TraceWriter::onto(out.get(), file.path(), TraceFormat::asc, begin);
    EXPECT_TRUE(writer->write({start + 10s, Frame::data_frame(1, {}), "can0"}));
    EXPECT_TRUE(writer->write({start, Frame::data_frame(2, {}), "can0"}));
    early = writer->early();
  }
  return {file.content(), early};
}

TEST(TraceWriter, AnAscFileBeginsWithTheEarliestFrameWhereThatIsSaid) {
  const auto [content, early] = written_backwards(start + 125us);
  EXPECT_EQ(early, 0U);
  EXPECT_EQ(content,
            "date Tue Nov 14 22:13:20 2023\n"
            "base hex  timestamps absolute\n"
            "no internal events logged\n"
            "  10.000000 1  1               Rx   d 0\n"
            "   0.000000 1  2               Rx   d 0\n");
}

TEST(TraceWriter, CountsFramesBeforeTheBeginningOfTheFile) {
  const auto [content, early] = written_backwards(std::nullopt);
  EXPECT_EQ(early, 1U);
  EXPECT_NE(content.find("   0.000000 1  2 "), std::string::npos);
  for (const TraceFormat* format : trace_formats()) {
    if (!format->is_written()) continue;
    const TemporaryFile file;
    auto writer = TraceWriter::create(file.path(), *format);
    EXPECT_TRUE(writer->write({Time{} - 1s, Frame::data_frame(1, {}), "can0"}));
    EXPECT_EQ(writer->early(), *format == TraceFormat::candump ? 0U : 1U) << format->name;
  }
}

TEST(TraceWriter, KeepsTheLatestTimeOrCountsIt) {
  const Time pcap_end{std::chrono::seconds{0xFFFF'FFFF}};
  for (const Time latest : {pcap_end, pcap_end + 1s, trace_time_max}) {
    for (const TraceFormat* format : trace_formats()) {
      if (!format->is_written()) continue;
      const TemporaryFile file;
      std::uint64_t late = 0;
      {
        auto writer = TraceWriter::create(file.path(), *format);
        for (const Time time : {Time{}, latest})
          EXPECT_TRUE(writer->write({time, Frame::data_frame(1, {}), "can0"}));
        late = writer->late();
      }
      auto reader = TraceReader::open(file.path());
      TraceFrame read;
      EXPECT_EQ(reader->next(read), TraceRead::frame);
      ASSERT_EQ(reader->next(read), TraceRead::frame) << format->name << reader->problem();
      EXPECT_EQ(read.time == latest, late == 0) << format->name;
    }
  }
}

TEST(TraceReader, RefusesATimeThatNoOtherFormatCouldHold) {
  auto reader = TraceReader::of("(64060588799.999999) can0 001#\n(64060588800.000000) can0 001#\n");
  TraceFrame read;
  EXPECT_EQ(reader->next(read), TraceRead::frame);
  EXPECT_EQ(read.time, trace_time_max);
  EXPECT_EQ(reader->next(read), TraceRead::bad);
  EXPECT_EQ(reader->problem(), "its time is behind the year 3999");
}

TEST(TraceWriter, WritesWhatCandumpWrites) {
  EXPECT_EQ(written(TraceFormat::candump, some_frames()),
            "(1700000000.000000) can0 185#1E2F\n"
            "(1700000001.500000) can1 18DAF110#0102030405060708\n"
            "(1700000002.500000) can0 701#R\n"
            "(1700000002.600000) can0 701#R4\n"
            "(1700000003.500000) can0 20000080#0000000000000000\n"
            "(1700000004.500001) can1 000#\n");
}

TEST(TraceWriter, GivesNamesWithoutBlanksToCandump) {
  EXPECT_EQ(written(TraceFormat::candump, {{start, Frame::data_frame(1, {}), "PCAN USB 1"}}),
            "(1700000000.000000) PCAN_USB_1 001#\n");
  EXPECT_EQ(written(TraceFormat::candump, {{start, Frame::data_frame(1, {}), ""}}),
            "(1700000000.000000) can0 001#\n");
}

TEST(TraceWriter, WritesAPacketWithItsCommentAndDirection) {
  const TraceFrame frame{start + 125us, Frame::data_frame(0x185, {0x1E, 0x2F}), "can0",
                         TraceDirection::received};
  const std::string content = written(TraceFormat::pcapng, {frame}, "SYNC!");
  const std::string section_and_interface =
      std::string("\x0A\x0D\x0D\x0A\x2C\0\0\0\x4D\x3C\x2B\x1A\1\0\0\0", 16) +
      std::string(8, '\xFF') + std::string("\4\0\6\0canvoy\0\0\0\0\0\0\x2C\0\0\0", 20) +
      std::string("\1\0\0\0\x20\0\0\0\xE3\0\0\0\0\0\0\0\2\0\4\0can0\0\0\0\0\x20\0\0\0", 32);
  const std::string packet =
      std::string("\6\0\0\0\x44\0\0\0\0\0\0\0\x24\x0A\6\0\x7D\x40\x1E\x18", 20) +
      std::string("\x0A\0\0\0\x0A\0\0\0\0\0\1\x85\2\0\0\0\x1E\x2F\0\0", 20) +
      std::string("\1\0\5\0SYNC!\0\0\0\2\0\4\0\1\0\0\0\0\0\0\0\x44\0\0\0", 28);
  EXPECT_EQ(content, section_and_interface + packet);
}

TEST(TraceWriter, CutsALongCommentBetweenCharacters) {
  std::string comment(TraceWriter::comment_length_max - 1, 'x');
  comment += "\xC2\xB0";
  const std::string content =
      written(TraceFormat::pcapng, {{start, Frame::data_frame(1, {}), "can0"}}, comment);
  EXPECT_EQ(content.find('\xC2'), std::string::npos);
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
}

Frame protocol_error() {
  // A stuff error in transmission, at position 2 (SocketCAN: violation 84h, location 2).
  Frame frame = Frame::data_frame(0x88, {0, 0, 0x84, 2, 0, 0, 0, 0});
  frame.flags = FrameFlags::error;
  return frame;
}

bool is_kept_error(const TraceFormat& format, const Frame& error, const Frame& read) {
  if ((format.lacks & trace_lack::errors) == 0) return read == error;
  return read.is_error() && read.data[2] == error.data[2] && read.data[3] == error.data[3];
}

// What a format keeps according to its row is read as it was written.
TEST(TraceWriter, WritesWhatTheReaderReads) {
  std::vector<TraceFrame> frames = some_frames();
  frames.push_back({start + 5s, protocol_error(), "can1", TraceDirection::unknown});
  for (const TraceFormat* format : trace_formats()) {
    if (!format->is_written()) continue;
    SCOPED_TRACE(format->name);
    const std::string content = written(*format, frames);
    auto trace = TraceReader::of(content);
    ASSERT_TRUE(trace);
    EXPECT_EQ(trace->format(), *format);
    for (const TraceFrame& expected : frames) {
      TraceFrame frame;
      ASSERT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
      const bool is_kept = expected.frame.is_error()
                               ? is_kept_error(*format, expected.frame, frame.frame)
                               : frame.frame == expected.frame;
      EXPECT_TRUE(is_kept) << expected.frame.id;
      EXPECT_EQ(frame.time, expected.time);
      if ((format->lacks & trace_lack::buses) == 0) {
        EXPECT_EQ(frame.channel, expected.channel);
      }
      if ((format->lacks & trace_lack::direction) == 0 &&
          expected.direction != TraceDirection::unknown) {
        EXPECT_EQ(frame.direction, expected.direction);
      }
    }
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::end);
    EXPECT_EQ(trace->bad(), 0U);
  }
}

TEST(TraceWriter, OfALogWithoutFramesWritesOneThatIsRead) {
  for (const TraceFormat* format : trace_formats()) {
    if (!format->is_written()) continue;
    const std::string content = written(*format, {});
    auto trace = TraceReader::of(content);
    ASSERT_TRUE(trace) << format->name;
    TraceFrame frame;
    EXPECT_EQ(trace->next(frame), TraceRead::end) << format->name;
    EXPECT_EQ(trace->bad(), 0U) << format->name;
  }
}

TEST(TraceWriter, SaysWhatTheFormatDoesNotKeep) {
  const TraceFrame plain{start, Frame::data_frame(1, {}), "can0"};
  const auto lost = [](const TraceFormat& format, const std::vector<TraceFrame>& frames,
                       std::string_view comment = {}) {
    const TemporaryFile file;
    auto writer = TraceWriter::create(file.path(), format);
    for (const TraceFrame& frame : frames) EXPECT_TRUE(writer->write(frame, comment));
    return writer->lost();
  };
  TraceFrame received = plain;
  received.direction = TraceDirection::received;
  TraceFrame named = plain;
  named.channel = "lift1";
  for (const TraceFormat* format : trace_formats()) {
    if (format->is_written()) {
      EXPECT_EQ(lost(*format, {plain, plain}), "") << format->name;
    }
  }
  EXPECT_EQ(lost(TraceFormat::candump, {received}, "why"), "the direction of frames, comments");
  EXPECT_EQ(lost(TraceFormat::asc, {received, named}), "names of buses");
  EXPECT_EQ(lost(TraceFormat::python_can_csv, {plain, named}),
            "names of buses, which bus a frame is of");
  EXPECT_EQ(lost(TraceFormat::blf, {{start, error_frame(), "can0"}}), "what error frames tell");
  EXPECT_EQ(lost(TraceFormat::pcapng, {received, named}, "why"), "");
}

TEST(TraceWriter, CompressesWhereTheNameSaysSo) {
  for (const TraceFormat* format : trace_formats()) {
    if (!format->is_written()) continue;
    SCOPED_TRACE(format->name);
    const TemporaryFile file;
    const std::string path =
        file.path() + std::string(format->endings.substr(0, format->endings.find(' '))) + ".gz";
    {
      auto writer = TraceWriter::create(path, *format);
      ASSERT_TRUE(writer);
      for (const TraceFrame& frame : some_frames()) EXPECT_TRUE(writer->write(frame));
      EXPECT_TRUE(writer->finish());
      EXPECT_GT(writer->size(), 0U);
    }
    auto trace = TraceReader::open(path);
    ASSERT_TRUE(trace);
    TraceFrame frame;
    for (const TraceFrame& expected : some_frames()) {
      ASSERT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
      if (!expected.frame.is_error()) EXPECT_EQ(frame.frame, expected.frame);
    }
    EXPECT_EQ(trace->next(frame), TraceRead::end);
    ::unlink(path.c_str());
  }
}

/// Records that reach over the end of what is read at once, in each format.
TEST(TraceWriter, WritesLogsThatAreReadWhereverTheBufferEnds) {
  constexpr std::uint32_t count = 10'000;
  for (const TraceFormat* format : trace_formats()) {
    if (!format->is_written()) continue;
    SCOPED_TRACE(format->name);
    const TemporaryFile file;
    {
      auto writer = TraceWriter::create(file.path(), *format);
      ASSERT_TRUE(writer);
      for (std::uint32_t i = 0; i < count; ++i) {
        Frame frame = Frame::data_frame(i & Frame::id_max, {1, 2, 3, 4, 5, 6, 7, 8});
        frame.length = i % 9;
        EXPECT_TRUE(writer->write({start + 1ms * i, frame, "can0", TraceDirection::received}));
      }
      EXPECT_TRUE(writer->finish());
    }
    auto trace = TraceReader::open(file.path());
    ASSERT_TRUE(trace);
    TraceFrame frame;
    for (std::uint32_t i = 0; i < count; ++i) {
      ASSERT_EQ(trace->next(frame), TraceRead::frame) << i << ": " << trace->problem();
      ASSERT_EQ(frame.time, start + 1ms * i);
      ASSERT_EQ(frame.frame.id, i & Frame::id_max);
      ASSERT_EQ(frame.frame.length, i % 9);
    }
    EXPECT_EQ(trace->next(frame), TraceRead::end);
  }
}

/// The fields of CSVWriter of python-can 4.1; times have six digits here.
TEST(TraceWriter, WritesWhatPythonCanWritesAsCsv) {
  EXPECT_EQ(written(TraceFormat::python_can_csv,
                    {{Time{} + 1500ms, Frame::data_frame(0, {1})},
                     {Time{} + 2s, Frame::data_frame(5, {})},
                     {Time{} + 3s, Frame::data_frame(0x18DAF110, {0x1E, 0x2F})}}),
            "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
            "1.500000,0x0,0,0,0,1,AQ==\n"
            "2.000000,0x5,0,0,0,0,\n"
            "3.000000,0x18daf110,1,0,0,2,Hi8=\n");
}

TEST(TraceWriter, KeepsToABoundedNumberOfInterfaces) {
  std::vector<std::string> names;
  for (int number = 0; number < 300; ++number) names.push_back("bus" + std::to_string(number));
  std::vector<TraceFrame> frames;
  for (const std::string& name : names) frames.push_back({start, Frame::data_frame(1, {}), name});
  const std::string content = written(TraceFormat::pcapng, frames);
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  for (int number = 0; number < 300; ++number) {
    ASSERT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    EXPECT_EQ(frame.channel, number < 255 ? names[static_cast<std::size_t>(number)] : "others");
  }
}

TEST(TraceWriter, GivesEachBusAChannelOfItsOwn) {
  std::vector<TraceFrame> frames;
  for (const char* name : {"group", "can0", "vcan0", "lift1", "", "group", "can1"}) {
    frames.push_back({start, Frame::data_frame(1, {}), name});
  }
  const std::string content = written(TraceFormat::asc, frames);
  auto trace = TraceReader::of(content);
  // group takes 1, the number of can0; vcan0 follows it, then lift1 and can1; a bus without a name
  // is can0.
  for (const char* name : {"can0", "can1", "can2", "can3", "can1", "can0", "can4"}) {
    TraceFrame frame;
    ASSERT_EQ(trace->next(frame), TraceRead::frame) << trace->problem();
    EXPECT_EQ(frame.channel, name);
  }
}

TEST(TraceWriter, KnowsFormatsByTheEndOfTheName) {
  EXPECT_EQ(trace_format_of("a.log"), TraceFormat::candump);
  EXPECT_EQ(trace_format_of("a.asc"), TraceFormat::asc);
  EXPECT_EQ(trace_format_of("a.pcapng"), TraceFormat::pcapng);
  EXPECT_EQ(trace_format_of("A.BLF"), TraceFormat::blf);
  EXPECT_EQ(trace_format_of("a.csv"), TraceFormat::python_can_csv);
  EXPECT_EQ(trace_format_of("night.2.trc.gz"), TraceFormat::trc);
  EXPECT_EQ(trace_format_of("a.txt"), std::nullopt);
  EXPECT_EQ(trace_format_of(".log"), std::nullopt);
  EXPECT_EQ(trace_format_of("a.gz"), std::nullopt);
}

TEST(TraceWriter, RefusesWhatItCannotWriteInOneLine) {
  const auto csv = TraceWriter::create("bus.csv", TraceFormat::savvycan_csv);
  ASSERT_FALSE(csv);
  EXPECT_EQ(csv.error().line(),
            "bus.csv: SavvyCAN CSV is only read, not written; these are written: candump log "
            "(.log), Vector ASC (.asc), Vector BLF (.blf), PEAK TRC (.trc), pcapng (.pcapng), "
            "pcap (.pcap), python-can CSV (.csv), ASAM MDF 4 (.mf4), python-can SQLite (.db)");
  EXPECT_FALSE(TraceWriter::create("/nowhere/bus.log", TraceFormat::candump));
}

TEST(TraceWriter, ToAFullDeviceFailsOnce) {
  auto writer = TraceWriter::create("/dev/full", TraceFormat::candump);
  ASSERT_TRUE(writer);
  EXPECT_TRUE(writer->write({start, Frame::data_frame(1, {}), "can0"}));
  EXPECT_FALSE(writer->flush());
  EXPECT_TRUE(writer->write({start, Frame::data_frame(1, {}), "can0"}));
  EXPECT_TRUE(writer->flush());
}

}  // namespace
}  // namespace canvoy::formats::trace_writer_test
