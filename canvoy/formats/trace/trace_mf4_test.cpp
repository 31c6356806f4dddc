// MDF 4 as loggers write it: channel groups that share a row of records, bytes of frames in groups
// of their own, data in compressed lists. Blocks are put together here as asammdf, which reads what
// we write, describes them; files that it wrote are read in tests/strangers/traces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::formats::trace_mf4_test {
namespace {

using host::TemporaryFile;
using testing::HasSubstr;

/// Puts an MDF 4 file together: a block stands behind those that it leads to.
class Mdf {
 public:
  explicit Mdf(const std::string& mark = "MDF     ", const std::string& version = "4.10") {
    bytes_ = mark + version + "    logger  ";
    bytes_.resize(64 + 104, '\0');
  }

  std::uint64_t add(const std::string& kind, const std::vector<std::uint64_t>& links,
                    const std::string& data, std::optional<std::uint64_t> length = {}) {
    bytes_.resize((bytes_.size() + 7) / 8 * 8, '\0');
    const std::uint64_t at = bytes_.size();
    bytes_ += block(kind, links, data, length);
    return at;
  }

  std::uint64_t text(const std::string& text) { return add("TX", {}, text + '\0'); }

  /// A channel of whole numbers, unless `kind` and `type` say something else.
  struct Channel {
    std::string name;
    std::uint32_t byte = 0;
    std::uint32_t bits = 8;
    std::uint8_t kind = 0;
    std::uint8_t type = 0;
    std::uint64_t data = 0;
    std::uint8_t bit = 0;
  };

  std::uint64_t channels(const std::vector<Channel>& all) {
    std::uint64_t next = 0;
    for (std::size_t at = all.size(); at-- > 0;) {
      const Channel& each = all.at(at);
      std::string data;
      append_little(data, each.kind, 1);
      append_little(data, each.kind == 2 ? 1 : 0, 1);
      append_little(data, each.type, 1);
      append_little(data, each.bit, 1);
      append_little(data, each.byte, 4);
      append_little(data, each.bits, 4);
      data.append(60, '\0');
      const std::uint64_t name = text(each.name);
      next = add("CN", {next, 0, name, 0, 0, each.data, 0, 0}, data);
    }
    return next;
  }

  std::uint64_t group(std::uint64_t next, std::uint64_t channels, std::uint64_t id,
                      std::uint64_t count, std::uint32_t size, std::uint16_t flags = 6) {
    std::string data;
    append_little(data, id, 8);
    append_little(data, count, 8);
    append_little(data, flags, 2);
    append_little(data, 0, 6);
    append_little(data, size, 4);
    append_little(data, 0, 4);
    return add("CG", {next, channels, 0, 0, 0, 0}, data);
  }

  std::uint64_t data_group(std::uint64_t next, std::uint64_t groups, std::uint64_t data,
                           std::uint8_t id_size) {
    return add("DG", {next, groups, data, 0},
               std::string(1, static_cast<char>(id_size)) + std::string(7, '\0'));
  }

  /// The file, which begins at `start`.
  std::string file(std::uint64_t data_groups, Time start = Time{} + 1'700'000'000s) {
    std::string data;
    append_little(data, static_cast<std::uint64_t>(start.time_since_epoch().count()) * 1000, 8);
    data.resize(32, '\0');
    bytes_.replace(64, 104, block("HD", {data_groups, 0, 0, 0, 0, 0}, data, {}));
    return bytes_;
  }

 private:
  static std::string block(const std::string& kind, const std::vector<std::uint64_t>& links,
                           const std::string& data, std::optional<std::uint64_t> length) {
    std::string bytes = "##" + kind + std::string(4, '\0');
    append_little(bytes, length.value_or(24 + 8 * links.size() + data.size()), 8);
    append_little(bytes, links.size(), 8);
    for (const std::uint64_t link : links) append_little(bytes, link, 8);
    return bytes + data;
  }

  std::string bytes_;
};

std::string seconds(double time) {
  std::string bytes;
  append_little(bytes, std::bit_cast<std::uint64_t>(time), 8);
  return bytes;
}

/// A record of small_channels.
std::string record(double time, std::uint32_t id, const std::string& data) {
  std::string bytes = seconds(time);
  append_little(bytes, 1, 1);
  append_little(bytes, id, 4);
  append_little(bytes, data.size(), 1);
  std::string padded = data;
  padded.resize(8, '\0');
  return bytes + padded;
}

constexpr std::uint32_t record_size = 22;

const std::vector<Mdf::Channel> small_channels = {
    {"Timestamp", 0, 64, 2, 4},
    {"CAN_DataFrame.BusChannel", 8, 8},
    {"CAN_DataFrame.ID", 9, 32},
    {"CAN_DataFrame.DataLength", 13, 8},
    {"CAN_DataFrame.DataBytes", 14, 64, 0, 10},
};

std::string small_file(const std::string& records, std::uint64_t count,
                       const std::string& mark = "MDF     ",
                       std::optional<std::uint64_t> length = {}) {
  Mdf mdf(mark);
  const std::uint64_t channels = mdf.channels(small_channels);
  const std::uint64_t group = mdf.group(0, channels, 0, count, record_size);
  const std::uint64_t data_group = mdf.data_group(0, group, 0, 0);
  const std::uint64_t data = mdf.add("DT", {}, records, length);
  std::string file = mdf.file(data_group);
  std::string link;
  append_little(link, data, 8);
  return file.replace(data_group + 24 + 16, 8, link);
}

struct Heard {
  TraceRead read;
  Duration at;  ///< since 1'700'000'000 s
  std::uint32_t id;
  std::string data;
  std::string bus;

  bool operator==(const Heard&) const = default;
};

std::vector<Heard> all_of(const std::string& content,
                          std::vector<std::string>* problems = nullptr) {
  std::vector<Heard> heard;
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace) << trace.error().line();
  if (!trace) return heard;
  TraceFrame frame;
  for (TraceRead read; (read = trace->next(frame)) != TraceRead::end;) {
    if (read == TraceRead::bad) {
      if (problems != nullptr) problems->emplace_back(trace->problem());
      continue;
    }
    const auto* const bytes = reinterpret_cast<const char*>(
        read == TraceRead::fd ? frame.fd.data.data() : frame.frame.data.data());
    const std::size_t length = read == TraceRead::fd ? frame.fd.length : frame.frame.length;
    heard.push_back({read, frame.time - Time{} - 1'700'000'000s, frame.frame.id,
                     std::string(bytes, length), std::string(frame.channel)});
  }
  EXPECT_EQ(trace->position(), trace->size());
  return heard;
}

TEST(TraceMf4, ReadsRecordsAsFrames) {
  const std::string file =
      small_file(record(0.000125, 0x185, "\x1E\x2F") + record(1.5, 0x80000000 | 0x18DAF110, ""), 2);
  const auto heard = all_of(file);
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0], (Heard{TraceRead::frame, 125us, 0x185, "\x1E\x2F", "can1"}));
  EXPECT_EQ(heard[1].id, 0x18DAF110U);
  EXPECT_EQ(heard[1].at, 1500ms);
}

TEST(TraceMf4, ReadsFromAFileAsFromMemory) {
  const TemporaryFile file(small_file(record(1, 0x185, "a"), 1));
  auto trace = TraceReader::open(file.path());
  ASSERT_TRUE(trace);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(frame.frame.id, 0x185U);
  EXPECT_EQ(trace->next(frame), TraceRead::end);
}

TEST(TraceMf4, SaysThatTheFileIsCut) {
  const std::string file = small_file(record(1, 0x185, "a") + record(2, 0x186, "b"), 2);
  std::vector<std::string> problems;
  EXPECT_EQ(all_of(file.substr(0, file.size() - 3), &problems).size(), 1U);
  EXPECT_EQ(problems, std::vector<std::string>{"the file ends within a frame"});
  problems.clear();
  EXPECT_EQ(all_of(file.substr(0, file.size() - record_size), &problems).size(), 1U);
  EXPECT_EQ(problems, std::vector<std::string>{"the file ends before the last of its frames"});
}

// What a logger leaves that lost its power: no count, and no length of the data.
TEST(TraceMf4, OfAFileThatWasNotFinishedReadsWhatThereIs) {
  const std::string records = record(1, 0x185, "a") + record(2, 0x186, "b");
  std::vector<std::string> problems;
  EXPECT_EQ(all_of(small_file(records, 0, "UnFinMF ", 24), &problems).size(), 2U);
  EXPECT_TRUE(problems.empty());
}

TEST(TraceMf4, PutsGroupsIntoTheOrderOfTime) {
  Mdf mdf;
  const std::uint64_t channels = mdf.channels(small_channels);
  const std::uint64_t odd = mdf.add("DT", {}, record(1, 1, "") + record(3, 3, ""));
  const std::uint64_t even = mdf.add("DT", {}, record(2, 2, "") + record(4, 4, ""));
  const std::uint64_t first = mdf.data_group(0, mdf.group(0, channels, 0, 2, record_size), odd, 0);
  const std::uint64_t second =
      mdf.data_group(first, mdf.group(0, channels, 0, 2, record_size), even, 0);
  std::vector<std::uint32_t> ids;
  for (const Heard& heard : all_of(mdf.file(second))) ids.push_back(heard.id);
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

/// A row of records of data frames (1), the bytes of these (2) and signals (3).
std::string unsorted_file(const std::string& records) {
  Mdf mdf("UnFinMF ");
  const std::uint64_t signal_group = mdf.group(0, 0, 3, 0, 5);
  const std::uint64_t bytes_group = mdf.group(signal_group, 0, 2, 0, 0, 1);
  const std::uint64_t channels = mdf.channels({
      {"Timestamp", 0, 64, 2, 4},
      {"CAN_DataFrame.ID", 8, 29},
      {"CAN_DataFrame.IDE", 11, 1, 0, 0, 0, 7},
      {"CAN_DataFrame.DLC", 12, 4},
      {"CAN_DataFrame.EDL", 12, 1, 0, 0, 0, 4},
      {"CAN_DataFrame.DataBytes", 13, 64, 1, 10, bytes_group},
  });
  const std::uint64_t group = mdf.group(bytes_group, channels, 1, 0, 21);
  const std::uint64_t data = mdf.add("DT", {}, records);
  return mdf.file(mdf.data_group(0, group, data, 1));
}

std::string unsorted_record(double time, std::uint32_t id, unsigned code, std::uint64_t offset) {
  std::string bytes = "\1" + seconds(time);
  append_little(bytes, id, 4);
  append_little(bytes, code, 1);
  append_little(bytes, offset, 8);
  return bytes;
}

std::string bytes_record(const std::string& data) {
  std::string bytes = "\2";
  append_little(bytes, data.size(), 4);
  return bytes + data;
}

TEST(TraceMf4, FindsTheBytesOfFramesBeforeAndBehindThem) {
  const std::string file =
      unsorted_file(unsorted_record(1, 0x80000000 | 0x123456, 2, 0) + bytes_record("ab") +
                    "\3....." + bytes_record("cde") + unsorted_record(2, 0x181, 3, 6) +
                    unsorted_record(3, 0x182, 0x10 | 9, 13) + bytes_record("0123456789AB"));
  std::vector<std::string> problems;
  const auto heard = all_of(file, &problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(heard[0], (Heard{TraceRead::frame, 1s, 0x123456, "ab", "can0"}));
  EXPECT_EQ(heard[1], (Heard{TraceRead::frame, 2s, 0x181, "cde", "can0"}));
  EXPECT_EQ(heard[2], (Heard{TraceRead::fd, 3s, 0x182, "0123456789AB", "can0"}));
}

TEST(TraceMf4, SaysWhichBytesAreMissing) {
  std::vector<std::string> problems;
  const auto heard = all_of(
      unsorted_file(unsorted_record(1, 1, 2, 99) + unsorted_record(2, 2, 0, 0) + bytes_record("")),
      &problems);
  EXPECT_EQ(problems, std::vector<std::string>{"the bytes of the frame are missing"});
  EXPECT_EQ(heard.size(), 1U);
}

/// Bytes of frames in a block SD of their own, each behind its length; frames have their offsets.
std::string apart_file(const std::vector<std::uint64_t>& offsets) {
  Mdf mdf;
  std::string bytes;
  for (const std::string& each : {std::string("ab"), std::string("cde")}) {
    append_little(bytes, each.size(), 4);
    bytes += each;
  }
  const std::uint64_t apart = mdf.add("SD", {}, bytes);
  const std::uint64_t channels = mdf.channels({{"Timestamp", 0, 64, 2, 4},
                                               {"CAN_DataFrame.ID", 8, 32},
                                               {"CAN_DataFrame.DataLength", 12, 8},
                                               {"CAN_DataFrame.DataBytes", 13, 64, 1, 10, apart}});
  std::string records;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    records += seconds(static_cast<double>(i + 1));
    append_little(records, 0x181 + i, 4);
    append_little(records, offsets[i] == 0 ? 2 : 3, 1);
    append_little(records, offsets[i], 8);
  }
  const std::uint64_t group = mdf.group(0, channels, 0, offsets.size(), 21);
  const std::uint64_t data = mdf.add("DT", {}, records);
  return mdf.file(mdf.data_group(0, group, data, 0));
}

TEST(TraceMf4, FindsTheBytesOfFramesInABlockOfTheirOwn) {
  const auto heard = all_of(apart_file({0, 6}));
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0], (Heard{TraceRead::frame, 1s, 0x181, "ab", "can0"}));
  EXPECT_EQ(heard[1], (Heard{TraceRead::frame, 2s, 0x182, "cde", "can0"}));
}

TEST(TraceMf4, BytesThatAreNotInTheOrderOfTheirFramesAreMissing) {
  for (const std::vector<std::uint64_t>& offsets :
       {std::vector<std::uint64_t>{6, 0}, std::vector<std::uint64_t>{6, 99}}) {
    std::vector<std::string> problems;
    const auto heard = all_of(apart_file(offsets), &problems);
    EXPECT_EQ(problems, std::vector<std::string>{"the bytes of the frame are missing"});
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].data, "cde");
  }
}

/// A block DZ of kind 1: the first bytes of all records, then the second ones, and so on. Of the
/// last record, that which is left over stands at the end, and goes on in the next block.
TEST(TraceMf4, ReadsRecordsThatWereTransposedAndCompressed) {
  constexpr std::size_t size = 21;
  constexpr std::size_t left_over = 5;
  const std::vector<std::string> all = {"ab", "cde", "f", "gh"};
  std::string records;
  for (std::size_t i = 0; i < all.size(); ++i) {
    append_little(records, 0x181 + i, 4);
    records += seconds(static_cast<double>(i + 1));
    append_little(records, all[i].size(), 1);
    records += all[i] + std::string(8 - all[i].size(), '\0');
  }
  std::string columns;
  for (std::size_t column = 0; column < size; ++column) {
    for (std::size_t row = 0; row < 3; ++row) columns += records[row * size + column];
  }
  columns += records.substr(3 * size, left_over);
  uLongf room = ::compressBound(columns.size());
  std::string packed(room, '\0');
  ASSERT_EQ(::compress(reinterpret_cast<Bytef*>(packed.data()), &room,
                       reinterpret_cast<const Bytef*>(columns.data()), columns.size()),
            Z_OK);
  packed.resize(room);
  std::string head("DT\1\0", 4);
  append_little(head, size, 4);
  append_little(head, columns.size(), 8);
  append_little(head, packed.size(), 8);
  Mdf mdf;
  const std::uint64_t channels = mdf.channels({{"CAN_DataFrame.ID", 0, 32},
                                               {"Timestamp", 4, 64, 2, 4},
                                               {"CAN_DataFrame.DataLength", 12, 8},
                                               {"CAN_DataFrame.DataBytes", 13, 64, 0, 10}});
  const std::uint64_t group = mdf.group(0, channels, 0, 4, size);
  const std::uint64_t first = mdf.add("DZ", {}, head + packed);
  const std::uint64_t rest = mdf.add("DT", {}, records.substr(3 * size + left_over));
  const std::uint64_t list = mdf.add("DL", {0, first, rest}, std::string(24, '\0'));
  const auto heard = all_of(mdf.file(mdf.data_group(0, group, list, 0)));
  ASSERT_EQ(heard.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(heard[i], (Heard{TraceRead::frame, (i + 1) * 1s, 0x181 + i, all[i], "can0"}));
  }
}

/// The block HD behind the 64 bytes of the file: header of 24, six links, the start in ns, the
/// offsets of the time zone and of summer time in minutes, and the flags, of which 2 says that both
/// are there.
TEST(TraceMf4, AFileThatIsWrittenBeginsInUtc) {
  const TemporaryFile file;
  auto writer = TraceWriter::create(file.path(), TraceFormat::mf4);
  ASSERT_TRUE(writer);
  TraceFrame frame;
  frame.time = Time{} + 1'700'000'000s;
  frame.frame = Frame::data_frame(0x181, {1});
  ASSERT_TRUE(writer->write(frame));
  ASSERT_TRUE(writer->finish());
  std::ifstream in(file.path(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  ASSERT_EQ(bytes.substr(64, 4), "##HD");
  std::string expected;
  append_little(expected, 1'700'000'000'000'000'000, 8);
  expected += std::string("\0\0\0\0\2", 5);
  EXPECT_EQ(bytes.substr(64 + 24 + 6 * 8, 13), expected);
}

TEST(TraceMf4, CannotGoOnBehindARecordThatIsNotDescribed) {
  std::vector<std::string> problems;
  EXPECT_TRUE(all_of(unsorted_file("\7" + std::string(100, 'x')), &problems).empty());
  EXPECT_EQ(problems, std::vector<std::string>{"a record of a group that is not described"});
}

TEST(TraceMf4, RefusesOneWithoutFramesInOneLine) {
  Mdf mdf;
  const std::uint64_t channels = mdf.channels({{"Timestamp", 0, 64, 2, 4}, {"EngineSpeed", 8, 16}});
  const std::string file = mdf.file(mdf.data_group(0, mdf.group(0, channels, 0, 0, 10), 0, 0));
  const auto trace = TraceReader::of(file);
  ASSERT_FALSE(trace);
  EXPECT_EQ(trace.error().line(),
            "the trace: the MDF file has no CAN frames (CAN_DataFrame), but 1 groups of other "
            "signals; record the bus itself, not signals of it");
}

TEST(TraceMf4, RefusesAnOlderVersionInOneLine) {
  Mdf mdf("MDF     ", "3.30");
  const std::string file = mdf.file(0);
  const auto trace = TraceReader::of(file);
  ASSERT_FALSE(trace);
  EXPECT_THAT(trace.error().line(), HasSubstr("it is an MDF file of version 3.30"));
}

// Links that lead in a circle end.
TEST(TraceMf4, IsNotLedInCircles) {
  std::string file = small_file(record(1, 0x185, "a"), 1);
  for (std::size_t at = 64; at + 8 <= file.size(); at += 8) {
    for (const std::uint64_t target : {64U, 168U, 0xFFFFU}) {
      std::string bent = file;
      std::string link;
      append_little(link, target, 8);
      bent.replace(at, 8, link);
      auto trace = TraceReader::of(bent);
      if (!trace) continue;
      TraceFrame frame;
      std::size_t steps = 0;
      while (trace->next(frame) != TraceRead::end) ASSERT_LT(++steps, 1000U);
    }
  }
}

TEST(TraceMf4, OfAPipeIsReadThoughItsHeaderStaysWithoutCounts) {
  const TemporaryFile file;
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  {
    auto writer = TraceWriter::onto(ends[1], "pipe.mf4", TraceFormat::mf4);
    EXPECT_TRUE(writer->write({Time{} + 1'700'000'000s, Frame::data_frame(0x185, {1}), "can2"}));
    EXPECT_TRUE(writer->finish());
  }
  ::close(ends[1]);
  std::string content(100'000, '\0');
  content.resize(static_cast<std::size_t>(::read(ends[0], content.data(), content.size())));
  ::close(ends[0]);
  EXPECT_TRUE(content.starts_with("UnFinMF "));
  const auto heard = all_of(content);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0], (Heard{TraceRead::frame, 0us, 0x185, "\1", "can2"}));
}

}  // namespace
}  // namespace canvoy::formats::trace_mf4_test
