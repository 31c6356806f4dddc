// The SQLite database of python-can: a table `messages`, a row a frame.
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

constexpr std::string_view sqlite_mark{"SQLite format 3\0", 16};
constexpr const char* wanted_columns = "ts, arbitration_id, extended, remote, error, dlc, data";
constexpr std::uint32_t error_class_max = 0x1FFF'FFFF;
/// From there on a double of seconds does not tell microseconds apart any more.
constexpr Duration sqlite_time_max = std::chrono::seconds{std::int64_t{1} << 33};

struct CloseDatabase {
  void operator()(sqlite3* database) const { ::sqlite3_close_v2(database); }
};
struct CloseStatement {
  void operator()(sqlite3_stmt* statement) const { ::sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, CloseStatement>;

Statement prepare(sqlite3* database, const char* text) {
  sqlite3_stmt* statement = nullptr;
  ::sqlite3_prepare_v2(database, text, -1, &statement, nullptr);
  return Statement(statement);
}

/// `file:` and the path, with what has a meaning in it as %XX.
std::string uri_of(std::string_view path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (c != '%' && c != '?' && c != '#') {
      uri += c;
      continue;
    }
    uri += '%';
    uri += digits[byte >> 4];
    uri += digits[byte & 0xF];
  }
  return uri;
}

Database open_file(const std::string& path) {
  sqlite3* database = nullptr;
  ::sqlite3_open_v2((uri_of(path) + "?mode=ro").c_str(), &database,
                    SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  return Database(database);
}

/// SQLite does not write into what is opened so.
Database open_memory(std::string_view content) {
  sqlite3* database = nullptr;
  ::sqlite3_open_v2(":memory:", &database, SQLITE_OPEN_READWRITE, nullptr);
  const auto size = static_cast<sqlite3_int64>(content.size());
  auto* const bytes = reinterpret_cast<unsigned char*>(const_cast<char*>(content.data()));
  ::sqlite3_deserialize(database, "main", bytes, size, size, SQLITE_DESERIALIZE_READONLY);
  return Database(database);
}

// What a file of others may make SQLite do.
void limit(sqlite3* database) {
  constexpr int length_max = 1'000'000;
  constexpr int busy_ms = 1000;
  ::sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  ::sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  ::sqlite3_limit(database, SQLITE_LIMIT_LENGTH, length_max);
  ::sqlite3_busy_timeout(database, busy_ms);
  ::sqlite3_exec(database, "PRAGMA cell_size_check=ON", nullptr, nullptr, nullptr);
}

class SqliteParser final : public TraceFileParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::sqlite; }
  std::string where() const override { return "row " + std::to_string(row_); }
  std::uint64_t position() const override { return std::min(row_ * row_size, file_.size()); }

  host::Result<void> open(TraceFile file, const std::string& name) override {
    file_ = std::move(file);
    const std::string path = file_.path();
    if (path.empty() && file_.content().empty()) {
      return host::Error{name, "it has no name any more", "write the database to a file first"};
    }
    database_ = path.empty() ? open_memory(file_.content()) : open_file(path);
    if (database_ == nullptr) return host::Error{name, "there is no memory for SQLite", ""};
    limit(database_.get());
    return find_table(name);
  }

  TraceStep read(TraceFrame& frame) override;

 private:
  host::Result<void> find_table(const std::string& name);
  host::Result<void> damaged(const std::string& name) const;
  std::string tables() const;
  TraceStep read_row(TraceFrame& frame) const;
  bool read_data(TraceFrame& frame, std::int64_t length) const;
  std::optional<std::int64_t> number(int column) const;
  TraceStep read_error(TraceFrame& frame, std::uint32_t id) const;

  static constexpr std::uint64_t row_size = 40;  ///< about
  static constexpr std::uint64_t row_size_min = 8;

  TraceFile file_;
  Database database_;
  Statement rows_;
  std::uint64_t row_ = 0;
  bool is_over_ = false;
};

host::Result<void> SqliteParser::damaged(const std::string& name) const {
  return host::Error{name,
                     std::string("SQLite cannot read it: ") + ::sqlite3_errmsg(database_.get()),
                     "`sqlite3 FILE .recover` may save what is left"};
}

/// `a, b, c`, as far as they are few.
std::string SqliteParser::tables() const {
  constexpr std::size_t length_max = 200;
  const Statement names =
      prepare(database_.get(), "SELECT name FROM sqlite_schema WHERE type='table' ORDER BY name");
  std::string text;
  while (names && ::sqlite3_step(names.get()) == SQLITE_ROW && text.size() < length_max) {
    const auto* const name = ::sqlite3_column_text(names.get(), 0);
    if (name == nullptr) continue;
    if (!text.empty()) text += ", ";
    text += plain_text(std::string_view(reinterpret_cast<const char*>(name)).substr(0, length_max));
  }
  return text;
}

host::Result<void> SqliteParser::find_table(const std::string& name) {
  const Statement table = prepare(database_.get(),
                                  "SELECT sql FROM sqlite_schema WHERE type='table' AND "
                                  "name='messages' AND rootpage>0");
  if (!table) return damaged(name);
  const int found = ::sqlite3_step(table.get());
  if (found != SQLITE_ROW && found != SQLITE_DONE) return damaged(name);
  const std::string what = "it is an SQLite database, but not a log of python-can: ";
  if (found == SQLITE_DONE) {
    const std::string others = tables();
    return host::Error{
        name,
        what + (others.empty() ? "it has no tables" : "it has no table 'messages', only " + others),
        "export its frames as CSV"};
  }
  rows_ = prepare(database_.get(),
                  (std::string("SELECT ") + wanted_columns + " FROM messages").c_str());
  if (!rows_) {
    return host::Error{name, what + ::sqlite3_errmsg(database_.get()),
                       std::string("the columns of its 'messages' are ") + wanted_columns};
  }
  return {};
}

// More rows than there is room for: pages that are used twice.
TraceStep SqliteParser::read(TraceFrame& frame) {
  if (is_over_) return {TraceItem::end, 0, {}};
  const int step = ::sqlite3_step(rows_.get());
  ++row_;
  if (step == SQLITE_ROW && row_ <= file_.size() / row_size_min) return read_row(frame);
  is_over_ = true;
  if (step == SQLITE_DONE) return {TraceItem::end, 0, {}};
  return bad_record(step == SQLITE_BUSY || step == SQLITE_LOCKED
                        ? "another program is writing into the database"
                        : "the database is damaged or cut behind it");
}

std::optional<std::int64_t> SqliteParser::number(int column) const {
  if (::sqlite3_column_type(rows_.get(), column) != SQLITE_INTEGER) return std::nullopt;
  return ::sqlite3_column_int64(rows_.get(), column);
}

TraceStep SqliteParser::read_row(TraceFrame& frame) const {
  constexpr double seconds_max = 1e11;
  const int time_type = ::sqlite3_column_type(rows_.get(), 0);
  const double seconds = ::sqlite3_column_double(rows_.get(), 0);
  const bool is_time = time_type == SQLITE_FLOAT || time_type == SQLITE_INTEGER;
  if (!is_time || !(seconds >= 0 && seconds < seconds_max)) return bad_record("it has no time");
  const auto id = number(1);
  const auto extended = number(2);
  const auto remote = number(3);
  const auto error = number(4);
  const auto length = number(5);
  if (!id || !extended || !remote || !error || !length) {
    return bad_record("a column has no number");
  }
  if (*id < 0 || *id > error_class_max) {
    return bad_record("the identifier has more bits than there are");
  }
  frame.time = Time{Duration{std::llround(seconds * 1e6)}};
  frame.channel = "can0";
  frame.direction = TraceDirection::unknown;
  frame.frame = {};
  const auto identifier = static_cast<std::uint32_t>(*id);
  if (*error != 0) return read_error(frame, identifier);
  frame.frame.id = identifier;
  frame.frame.flags = *extended != 0 ? FrameFlags::extended : FrameFlags::none;
  if (*extended == 0 && identifier > Frame::id_max) {
    return bad_record("the identifier has more bits than there are");
  }
  if (*remote != 0) {
    frame.frame.flags = frame.frame.flags | FrameFlags::remote;
    frame.frame.length =
        static_cast<std::uint8_t>(std::clamp<std::int64_t>(*length, 0, Frame::length_max));
    return {TraceItem::frame, 0, {}};
  }
  if (!read_data(frame, *length)) return bad_record("it has less data than its length says");
  return {*length > Frame::length_max ? TraceItem::fd : TraceItem::frame, 0, {}};
}

bool SqliteParser::read_data(TraceFrame& frame, std::int64_t length) const {
  const auto* const data = static_cast<const std::uint8_t*>(::sqlite3_column_blob(rows_.get(), 6));
  const int size = ::sqlite3_column_bytes(rows_.get(), 6);
  if (length < 0 || length > size || (data == nullptr && length > 0)) return false;
  if (length > Frame::length_max) {
    frame.fd = {};
    frame.fd.length = static_cast<std::uint8_t>(
        std::min<std::int64_t>(length, static_cast<std::int64_t>(frame.fd.data.size())));
    std::copy_n(data, frame.fd.length, frame.fd.data.begin());
    return true;
  }
  frame.frame.length = static_cast<std::uint8_t>(length);
  if (length > 0) std::copy_n(data, frame.frame.length, frame.frame.data.begin());
  return true;
}

// As SocketCAN tells of it; of other interfaces python-can keeps no class.
TraceStep SqliteParser::read_error(TraceFrame& frame, std::uint32_t id) const {
  frame.frame = trace_error_frame();
  if (id == 0 || ::sqlite3_column_bytes(rows_.get(), 6) < Frame::length_max) {
    return {TraceItem::frame, 0, {}};
  }
  frame.frame.id = id;
  read_data(frame, Frame::length_max);
  return {TraceItem::frame, 0, {}};
}

std::unique_ptr<TraceParser> recognize_sqlite(const TraceHead& head) {
  if (!head.is_first || !head.rest.starts_with(sqlite_mark)) return nullptr;
  return std::make_unique<SqliteParser>();
}

class SqliteEncoder final : public TraceFileEncoder {
 public:
  host::Result<void> open(const std::string& path, const std::string& name) override {
    sqlite3* database = nullptr;
    ::sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    database_.reset(database);
    // A log that is cut off by a loss of power is none the better for a wait on each second.
    run("PRAGMA synchronous=OFF");
    run("CREATE TABLE messages(ts REAL, arbitration_id INTEGER, extended INTEGER, remote INTEGER, "
        "error INTEGER, dlc INTEGER, data BLOB)");
    insert_ = prepare(database_.get(), "INSERT INTO messages VALUES(?,?,?,?,?,?,?)");
    run("BEGIN");
    if (insert_ && problem_.empty()) return {};
    return host::Error{name, problem_, "choose another file or folder"};
  }

  void write(const TraceFrame& frame) override;

  void flush() override {
    if (waiting_ == 0) return;
    waiting_ = 0;
    run("COMMIT");
    run("BEGIN");
  }

  void finish() override {
    run("COMMIT");
    insert_.reset();
    size_ = size();
    database_.reset();
  }

  std::uint64_t size() const override;
  std::string_view problem() const override { return problem_; }

 private:
  void run(const char* text) {
    if (::sqlite3_exec(database_.get(), text, nullptr, nullptr, nullptr) != SQLITE_OK) note();
  }
  void note() {
    if (problem_.empty()) problem_ = ::sqlite3_errmsg(database_.get());
  }

  Database database_;
  Statement insert_;
  std::uint64_t waiting_ = 0;
  std::uint64_t size_ = 0;
  std::string problem_;
};

void SqliteEncoder::write(const TraceFrame& heard) {
  const Frame& frame = heard.frame;
  const Duration time = time_from(heard, Duration{}, sqlite_time_max);
  sqlite3_stmt* const row = insert_.get();
  const int size = frame.is_remote() ? 0 : frame.length;
  ::sqlite3_bind_double(row, 1, static_cast<double>(time.count()) / 1e6);
  ::sqlite3_bind_int64(row, 2, frame.id);
  ::sqlite3_bind_int(row, 3, frame.is_extended() ? 1 : 0);
  ::sqlite3_bind_int(row, 4, frame.is_remote() ? 1 : 0);
  ::sqlite3_bind_int(row, 5, frame.is_error() ? 1 : 0);
  ::sqlite3_bind_int(row, 6, frame.length);
  ::sqlite3_bind_blob(row, 7, frame.data.data(), size, SQLITE_STATIC);
  if (::sqlite3_step(row) != SQLITE_DONE) note();
  ::sqlite3_reset(row);
  ++waiting_;
}

std::uint64_t SqliteEncoder::size() const {
  if (!database_) return size_;
  const auto number = [this](const char* text) {
    const Statement statement = prepare(database_.get(), text);
    const bool is_read = statement && ::sqlite3_step(statement.get()) == SQLITE_ROW;
    return is_read ? static_cast<std::uint64_t>(::sqlite3_column_int64(statement.get(), 0)) : 0;
  };
  return number("PRAGMA page_count") * number("PRAGMA page_size");
}

}  // namespace

constinit const TraceFormat TraceFormat::sqlite{
    .name = "python-can SQLite",
    .endings = ".db .sqlite .sqlite3",
    .lacks =
        trace_lack::direction | trace_lack::bus_names | trace_lack::buses | trace_lack::comments,
    .recognize = recognize_sqlite,
    .encoder = [](std::optional<Time>) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<SqliteEncoder>();
    },
};

}  // namespace canvoy::formats
