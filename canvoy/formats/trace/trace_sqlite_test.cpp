// The database that python-can's SqliteWriter makes: its CREATE TABLE, and rows as it puts them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>
#include <utility>

#include "canvoy/can/host/temporary_file_test.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::formats::trace_sqlite_test {
namespace {

using host::TemporaryFile;
using testing::HasSubstr;

constexpr const char* python_can_table =
    "CREATE TABLE IF NOT EXISTS messages(ts REAL, arbitration_id INTEGER, extended INTEGER, "
    "remote INTEGER, error INTEGER, dlc INTEGER, data BLOB);";

/// The bytes of a database in which these statements were run.
std::string database(const std::string& statements) {
  const TemporaryFile file;
  sqlite3* made = nullptr;
  EXPECT_EQ(::sqlite3_open(file.path().c_str(), &made), SQLITE_OK);
  EXPECT_EQ(::sqlite3_exec(made, statements.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << ::sqlite3_errmsg(made);
  ::sqlite3_close(made);
  return file.content();
}

std::string log_of(const std::string& rows) {
  return database(python_can_table + ("INSERT INTO messages VALUES " + rows));
}

/// What is read of the one row of such a log.
std::pair<TraceRead, TraceFrame> read_row(const std::string& row) {
  const std::string content = log_of(row);
  auto trace = TraceReader::of(content);
  EXPECT_TRUE(trace);
  TraceFrame frame;
  const TraceRead read = trace->next(frame);
  frame.channel = {};
  TraceFrame none;
  EXPECT_EQ(trace->next(none), TraceRead::end);
  EXPECT_EQ(trace->position(), trace->size());
  return {read, frame};
}

std::string problem_of(const std::string& row) {
  const std::string content = log_of(row);
  auto trace = TraceReader::of(content);
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::bad);
  return trace->where() + ": " + std::string(trace->problem());
}

std::string refusal_of(const std::string& statements) {
  const TemporaryFile file(database(statements));
  const auto trace = TraceReader::open(file.path());
  if (trace) return {};
  return trace.error().line().substr(file.path().size());
}

TEST(TraceSqlite, ReadsARowAsAFrame) {
  const auto [read, frame] = read_row("(1700000000.000125, 0x185, 0, 0, 0, 2, x'1E2F')");
  EXPECT_EQ(read, TraceRead::frame);
  EXPECT_EQ(frame.time, Time{} + 1'700'000'000s + 125us);
  EXPECT_EQ(frame.frame, Frame::data_frame(0x185, {0x1E, 0x2F}));
  EXPECT_EQ(frame.direction, TraceDirection::unknown);
}

TEST(TraceSqlite, ReadsIdentifiersOf29Bits) {
  const auto [read, frame] = read_row("(0, 0x18DAF110, 1, 0, 0, 0, x'')");
  EXPECT_EQ(read, TraceRead::frame);
  EXPECT_TRUE(frame.frame.is_extended());
  EXPECT_EQ(frame.frame.id, 0x18DAF110U);
}

TEST(TraceSqlite, ReadsWhatARemoteFrameAsksFor) {
  const auto [read, frame] = read_row("(1, 0x701, 0, 1, 0, 4, NULL)");
  EXPECT_EQ(read, TraceRead::frame);
  EXPECT_EQ(frame.frame, Frame::remote_frame(0x701, 4));
}

TEST(TraceSqlite, ReadsAnErrorFrameAsSocketCanToldIt) {
  const auto [read, frame] = read_row("(1, 0x88, 0, 0, 1, 8, x'0000840200000000')");
  EXPECT_EQ(read, TraceRead::frame);
  EXPECT_TRUE(frame.frame.is_error());
  EXPECT_EQ(frame.frame.id, 0x88U);
  EXPECT_EQ(frame.frame.data[2], 0x84);
  const auto [untold, without] = read_row("(1, 0, 0, 0, 1, 0, x'')");
  EXPECT_EQ(untold, TraceRead::frame);
  EXPECT_EQ(without.frame.id, 0x80U);
}

TEST(TraceSqlite, TellsOfCanFdByTheLength) {
  const auto [read, frame] = read_row("(1, 0x123, 0, 0, 0, 12, x'0102030405060708090A0B0C')");
  EXPECT_EQ(read, TraceRead::fd);
  EXPECT_EQ(frame.fd.length, 12);
  EXPECT_EQ(frame.fd.data[11], 12);
}

TEST(TraceSqlite, SaysOfEachRowWhatIsWrongWithIt) {
  EXPECT_EQ(problem_of("(NULL, 1, 0, 0, 0, 0, x'')"), "row 1: it has no time");
  EXPECT_EQ(problem_of("('soon', 1, 0, 0, 0, 0, x'')"), "row 1: it has no time");
  EXPECT_EQ(problem_of("(-1.5, 1, 0, 0, 0, 0, x'')"), "row 1: it has no time");
  EXPECT_EQ(problem_of("(1e300, 1, 0, 0, 0, 0, x'')"), "row 1: it has no time");
  EXPECT_EQ(problem_of("(1, 'one', 0, 0, 0, 0, x'')"), "row 1: a column has no number");
  EXPECT_EQ(problem_of("(1, 0x800, 0, 0, 0, 0, x'')"),
            "row 1: the identifier has more bits than there are");
  EXPECT_EQ(problem_of("(1, 0x20000000, 1, 0, 0, 0, x'')"),
            "row 1: the identifier has more bits than there are");
  EXPECT_EQ(problem_of("(1, 1, 0, 0, 0, 8, x'0102')"),
            "row 1: it has less data than its length says");
}

TEST(TraceSqlite, RefusesADatabaseOfOtherTablesInOneLine) {
  EXPECT_EQ(refusal_of("CREATE TABLE people(name); CREATE TABLE towns(name);"),
            ": it is an SQLite database, but not a log of python-can: it has no table 'messages', "
            "only people, towns; export its frames as CSV");
  EXPECT_THAT(refusal_of("CREATE TABLE messages(ts REAL, text TEXT);"),
              HasSubstr("no such column: arbitration_id"));
  EXPECT_THAT(refusal_of("PRAGMA user_version=1;"), HasSubstr("it has no tables"));
}

// A view could make SQLite calculate for without end.
TEST(TraceSqlite, RefusesAViewInPlaceOfTheTable) {
  EXPECT_THAT(refusal_of("CREATE TABLE other(a); CREATE VIEW messages AS SELECT 1 AS ts;"),
              HasSubstr("it has no table 'messages'"));
}

TEST(TraceSqlite, TellsOfADatabaseThatIsCut) {
  std::string rows = "(0, 1, 0, 0, 0, 8, x'0000000000000000')";
  for (int row = 1; row < 2000; ++row) {
    rows += ", (" + std::to_string(row) + ", 1, 0, 0, 0, 8, x'0102030405060708')";
  }
  const std::string whole = log_of(rows);
  const TemporaryFile cut(whole.substr(0, whole.size() / 2 / 4096 * 4096));
  auto trace = TraceReader::open(cut.path());
  if (!trace) {
    EXPECT_THAT(trace.error().line(), HasSubstr("SQLite cannot read it"));
    return;
  }
  TraceFrame frame;
  TraceRead read = TraceRead::frame;
  while (read == TraceRead::frame) read = trace->next(frame);
  EXPECT_EQ(read, TraceRead::bad);
  EXPECT_THAT(trace->problem(), HasSubstr("damaged or cut"));
  EXPECT_EQ(trace->next(frame), TraceRead::end);
}

TEST(TraceSqlite, IsReadFromAPipeAsFromAFile) {
  const std::string content = log_of("(1, 0x181, 0, 0, 0, 1, x'05'), (2, 0x182, 0, 0, 0, 0, x'')");
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], content.data(), content.size()), static_cast<ssize_t>(content.size()));
  ::close(ends[1]);
  auto trace = TraceReader::open("/proc/self/fd/" + std::to_string(ends[0]));
  ::close(ends[0]);
  ASSERT_TRUE(trace) << trace.error().line();
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(frame.frame.id, 0x182U);
  EXPECT_EQ(trace->next(frame), TraceRead::end);
}

TEST(TraceSqlite, IsNotChangedByReading) {
  const std::string content = log_of("(1, 0x181, 0, 0, 0, 1, x'05')");
  const TemporaryFile file(content);
  auto trace = TraceReader::open(file.path());
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(file.content(), content);
}

TEST(TraceSqlite, OfWhatIsRecordedIsReadWhenItIsFlushed) {
  const TemporaryFile file;
  auto writer = TraceWriter::create(file.path(), TraceFormat::sqlite);
  ASSERT_TRUE(writer) << writer.error().line();
  EXPECT_TRUE(writer->write({Time{} + 1s, Frame::data_frame(0x181, {5}), "can0"}));
  EXPECT_TRUE(writer->flush());
  EXPECT_TRUE(writer->write({Time{} + 2s, Frame::data_frame(0x181, {6}), "can0"}));
  auto trace = TraceReader::open(file.path());
  ASSERT_TRUE(trace) << trace.error().line();
  TraceFrame frame;
  EXPECT_EQ(trace->next(frame), TraceRead::frame);
  EXPECT_EQ(trace->next(frame), TraceRead::end);
  EXPECT_GT(writer->size(), 4096U);
}

TEST(TraceSqlite, ThatCannotBeWrittenIsSaidOnce) {
  auto writer = TraceWriter::create("/dev/full", TraceFormat::sqlite);
  ASSERT_TRUE(writer);
  EXPECT_TRUE(writer->write({Time{}, Frame::data_frame(1, {}), "can0"}));
  EXPECT_FALSE(writer->finish());
  EXPECT_TRUE(writer->finish());
}

}  // namespace
}  // namespace canvoy::formats::trace_sqlite_test
