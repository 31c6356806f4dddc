// PEAK TRC, versions 1.0 to 2.1 (PEAK CAN TRC File Format); 2.1 is written.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/error_frame.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_line.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_scanner.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::string_view known_columns = "NOTBIdRlLD";
constexpr unsigned millisecond_fraction_digits = 3;
constexpr unsigned days_before_1970 = 25'569;                 // since 30 December 1899
constexpr std::int64_t offset_max = 100'000'000'000'000'000;  // microseconds

// The words of a line, by column; `rest` begins with the data.
struct Words {
  std::string_view offset;
  std::string_view type;
  std::string_view bus;
  std::string_view identifier;
  std::string_view direction;
  std::string_view length;
  std::string_view rest;
};

void put_word(Words& words, char column, std::string_view word) {
  switch (column) {
    case 'O':
      words.offset = word;
      break;
    case 'T':
      words.type = word;
      break;
    case 'B':
      words.bus = word;
      break;
    case 'I':
      words.identifier = word;
      break;
    case 'd':
      words.direction = word;
      break;
    case 'l':
    case 'L':
      words.length = word;
      break;
    default:
      break;
  }
}

// The fields of a common line: a data frame.
struct UsualLine {
  std::int64_t offset = 0;
  unsigned bus = 1;
  char direction = 0;
  char type_direction = 0;  // in old versions, the type gives it
  std::uint32_t identifier = 0;
  unsigned digits = 0;  // number of digits of the identifier
  unsigned length = Frame::length_max + 1;

  // False: not the common form.
  template <char column>
  [[gnu::always_inline]] bool take(TraceScanner& scanner) {
    if constexpr (column == 'O') return scanner.take_fixed<millisecond_fraction_digits>(offset);
    if constexpr (column == 'B') return scanner.take_number(bus);
    if constexpr (column == 'I') return (digits = scanner.take_hex(identifier)) != 0;
    if constexpr (column == 'd') return (direction = scanner.take_direction()) != 0;
    if constexpr (column == 'l' || column == 'L') return scanner.take_digit(length);
    if constexpr (column == 'T') {
      type_direction = scanner.take_direction();
      return type_direction != 0 || (scanner.take('D') && scanner.take('T'));
    }
    scanner.skip_word();
    return true;
  }
};

// All columns except the last one, which is the data.
template <char first, char... others>
bool take_columns(UsualLine& read, TraceScanner& scanner) {
  return read.take<first>(scanner) &&
         ((scanner.take_blanks() && read.take<others>(scanner)) && ...);
}

// The columns of a version, and the function that reads its common lines.
struct Version {
  std::string_view name;
  std::string_view columns;
  bool (*take)(UsualLine& read, TraceScanner& scanner);
};
// N number, O offset in ms, T type, B bus, I identifier, d direction, R reserved, l length, L data
// length code, D data.
constexpr std::array<Version, 6> versions = {{
    {"1.0", "NOIlD", take_columns<'N', 'O', 'I', 'l'>},
    {"1.1", "NOTIlD", take_columns<'N', 'O', 'T', 'I', 'l'>},
    {"1.2", "NOBTIlD", take_columns<'N', 'O', 'B', 'T', 'I', 'l'>},
    {"1.3", "NOBTIRlD", take_columns<'N', 'O', 'B', 'T', 'I', 'R', 'l'>},
    {"2.0", "NOTIdlD", take_columns<'N', 'O', 'T', 'I', 'd', 'l'>},
    {"2.1", "NOTBIdRLD", take_columns<'N', 'O', 'T', 'B', 'I', 'd', 'R', 'L'>},
}};

class TrcParser final : public TraceLineParser {
 public:
  TrcParser() : TraceLineParser(Behind::end_of_line) {}
  const TraceFormat& format() const override { return TraceFormat::trc; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& frame) override;

 private:
  TraceStep read_comment(std::string_view line);
  TraceStep choose_version(std::string_view version);
  TraceStep choose_columns(std::string_view list);
  TraceStep read_start(std::string_view days);
  bool read_usual_line(std::string_view line, TraceFrame& frame);
  Words split(std::string_view line) const;
  TraceStep read_words(const Words& words, TraceFrame& frame);
  TraceStep read_frame(const Words& words, TraceFrame& frame);
  TraceStep read_fd_frame(const Words& words, TraceFrame& frame) const;

  std::string columns_{versions.front().columns};
  bool (*take_usual_)(UsualLine& read, TraceScanner& scanner) = versions.front().take;
  TraceChannel channel_;
  Duration start_{};
};

TraceStep TrcParser::read_line(std::string_view line, TraceFrame& frame) {
  skip_blanks(line);
  if (line.empty()) return trace_note;
  if (line.front() == ';') return read_comment(line.substr(1));
  if (read_usual_line(line, frame)) return {TraceItem::frame, 0, {}};
  return read_words(split(line), frame);
}

TraceStep TrcParser::read_comment(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (!line.starts_with('$') || equals == std::string_view::npos) return trace_note;
  const std::string_view key = line.substr(1, equals - 1);
  std::string_view rest = line.substr(equals + 1);
  const std::string_view value = take_word(rest);
  if (key == "FILEVERSION") return choose_version(value);
  if (key == "COLUMNS") return choose_columns(value);
  if (key == "STARTTIME") return read_start(value);
  return trace_note;
}

TraceStep TrcParser::choose_version(std::string_view version) {
  for (const Version& known : versions) {
    if (known.name != version) continue;
    columns_ = known.columns;
    take_usual_ = known.take;
    return trace_note;
  }
  return bad_record("the file has another version than 1.0 to 2.1");
}

// `N,O,T,B,I,d,R,L,D`: the data, with a varying number of words, are last.
TraceStep TrcParser::choose_columns(std::string_view list) {
  std::string columns;
  for (std::size_t at = 0; at < list.size(); ++at) {
    const bool comma = at % 2 == 1;
    if (comma ? list[at] != ',' : known_columns.find(list[at]) == std::string_view::npos)
      return bad_record("a column is not known");
    if (!comma) columns += list[at];
  }
  if (columns.size() > known_columns.size() || !columns.ends_with('D'))
    return bad_record("the last column is not D, the data");
  columns_ = columns;
  const auto* same = std::ranges::find(versions, std::string_view(columns), &Version::columns);
  take_usual_ = same == versions.end() ? nullptr : same->take;
  return trace_note;
}

// Days since 30 December 1899, which is 25569 days before 1970.
TraceStep TrcParser::read_start(std::string_view days) {
  constexpr std::size_t digits = 12;
  constexpr std::int64_t parts = 1'000'000'000'000;
  std::int64_t value = 0;
  if (!read_fixed(days, digits, value)) return bad_record("the time of the start is no number");
  const std::int64_t whole = value / parts - days_before_1970;
  const std::int64_t microseconds = value % parts * 864 / 10'000;
  start_ = std::chrono::days{whole} + Duration{microseconds};
  return trace_note;
}

// Fast path for the common form of a line; other forms are left to the tolerant path.
bool TrcParser::read_usual_line(std::string_view line, TraceFrame& frame) {
  constexpr unsigned base_digits = 4;
  TraceScanner scanner(line);
  UsualLine read;
  if (take_usual_ == nullptr || !take_usual_(read, scanner)) return false;
  const bool extended = read.digits > base_digits;
  if (read.identifier > (extended ? Frame::extended_id_max : Frame::id_max)) return false;
  frame.channel = channel_.name(read.bus);
  frame.frame = {};
  if (frame.channel.empty() || !scanner.take_bytes(read.length, frame.frame)) return false;
  // RTR may take the place of the data.
  if (read.length == 0 && !scanner.is_at_end()) return false;
  frame.frame.id = read.identifier;
  frame.frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
  const char direction = read.direction != 0 ? read.direction : read.type_direction;
  frame.direction = direction == 'R'   ? TraceDirection::received
                    : direction == 'T' ? TraceDirection::sent
                                       : TraceDirection::unknown;
  frame.time = Time{start_ + Duration{read.offset}};
  return true;
}

Words TrcParser::split(std::string_view line) const {
  Words words;
  for (const char column : columns_) {
    if (column == 'D') break;
    put_word(words, column, take_word(line));
  }
  words.rest = line;
  return words;
}

TraceStep TrcParser::read_words(const Words& words, TraceFrame& frame) {
  std::int64_t offset = 0;
  if (!read_fixed(words.offset, millisecond_fraction_digits, offset) || offset > offset_max)
    return bad_record("the time offset is no number");
  frame.time = Time{start_ + Duration{offset}};
  std::int64_t bus = 1;
  if (!words.bus.empty() && !read_decimal(words.bus, bus))
    return bad_record("the bus is no number");
  frame.channel = channel_.name(bus);
  if (frame.channel.empty()) return bad_record("the bus is not 1 to 255");
  const std::string_view direction = words.direction.empty() ? words.type : words.direction;
  frame.direction = direction == "Rx"   ? TraceDirection::received
                    : direction == "Tx" ? TraceDirection::sent
                                        : TraceDirection::unknown;
  return read_frame(words, frame);
}

// The type is in place of the CAN-ID or, if that is missing, before the other bytes: direction,
// position, counters of reception and of transmission.
TraceError read_trc_error(const Words& words, std::string_view rest) {
  constexpr unsigned bytes_max = 5;
  if (rest.starts_with("ERROR")) take_word(rest);
  std::array<std::uint32_t, bytes_max> bytes{};
  unsigned count = 0;
  if (words.identifier != "-" && read_hex(words.identifier, bytes[0])) ++count;
  while (count < bytes_max && read_hex(take_word(rest), bytes[count])) ++count;
  TraceError error;
  if (count < bytes_max) return error;
  const auto byte = [&bytes](unsigned place) { return static_cast<std::uint8_t>(bytes[place]); };
  constexpr std::uint32_t kinds =
      error_violation::bit | error_violation::form | error_violation::stuff;
  error.violation = static_cast<std::uint8_t>(bytes[0] & kinds);
  if (bytes[1] == 0) error.violation |= error_violation::on_transmission;
  error.location = byte(2);
  error.receive_counter = byte(3);
  error.transmit_counter = byte(4);
  return error;
}

// `L` is the data length code, `l` the length; FB and BI have the bit rate switch, FE and BI an
// error state.
TraceStep TrcParser::read_fd_frame(const Words& words, TraceFrame& frame) const {
  frame.frame = {};
  frame.fd = {};
  if (words.identifier.size() > 4) frame.frame.flags = FrameFlags::extended;
  if (words.type == "FB" || words.type == "BI") frame.fd.flags |= TraceFdContent::bit_rate_switch;
  if (words.type == "FE" || words.type == "BI") frame.fd.flags |= TraceFdContent::error_state;
  std::int64_t length = 0;
  if (!read_hex(words.identifier, frame.frame.id) || !read_decimal(words.length, length))
    return {TraceItem::fd, 0, {}};
  const bool is_code = columns_.find('L') != std::string::npos;
  std::string_view rest = words.rest;
  take_fd_bytes(rest,
                is_code ? fd_length(static_cast<std::uint32_t>(length & 0xF))
                        : static_cast<std::size_t>(length),
                true, frame.fd);
  return {TraceItem::fd, 0, {}};
}

// FD, FB, FE and BI are frames of CAN FD; ST, EC, EV and Warng are no frames.
TraceStep TrcParser::read_frame(const Words& words, TraceFrame& frame) {
  const std::string_view type = words.type;
  std::string_view rest = words.rest;
  skip_blanks(rest);
  if (type == "FD" || type == "FB" || type == "FE" || type == "BI")
    return read_fd_frame(words, frame);
  if (type == "ER" || type == "Error" || (type.empty() && rest.starts_with("ERROR"))) {
    frame.frame = trace_error_frame(read_trc_error(words, rest));
    return {TraceItem::frame, 0, {}};
  }
  const bool known = type.empty() || type == "Rx" || type == "Tx" || type == "DT" || type == "RR";
  if (!known || words.identifier == "FFFFFFFF") return trace_note;
  std::uint32_t id = 0;
  std::int64_t length = 0;
  const bool extended = words.identifier.size() > 4;
  if (!read_hex(words.identifier, id) || id > (extended ? Frame::extended_id_max : Frame::id_max))
    return bad_record("the identifier is no number of 4 or 8 hexadecimal digits");
  if (!read_decimal(words.length, length) || length > 15)
    return bad_record("the length is not 0 to 15");
  const auto count = static_cast<std::uint8_t>(length < 8 ? length : 8);
  const bool remote = type == "RR" || rest.starts_with("RTR");
  frame.frame = Frame::remote_frame(id, count);
  frame.frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
  if (remote) frame.frame.flags = frame.frame.flags | FrameFlags::remote;
  if (!remote && !take_bytes(rest, count, true, frame.frame))
    return bad_record("there are fewer bytes than the length says, or they are no bytes");
  return {TraceItem::frame, 0, {}};
}

class TrcEncoder final : public TraceEncoder {
 public:
  explicit TrcEncoder(std::optional<Time> begin) : start_(begin) {}

  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    if (!start_.is_known()) {
      start_.set(frame);
      append_header(bytes);
    }
    const Duration offset = time_from(frame, start_.value()) - start_.value();
    TraceLine line;
    line.put_decimal(++number_, 7);
    line.put(' ');
    line.put_fixed<millisecond_fraction_digits>(static_cast<std::uint64_t>(offset.count()), 9);
    put_content(line, frame);
    line.put('\n');
    bytes += line.view();
  }
  /// For a log without frames.
  void end(std::string& bytes) override {
    if (start_.is_known()) return;
    start_.set({});
    append_header(bytes);
  }

 private:
  // Rounded up, so that the days are read as the same microsecond.
  void append_header(std::string& bytes) const {
    constexpr std::uint64_t seconds_per_day = 86'400;
    constexpr std::uint64_t parts = 1'000'000'000'000;
    const auto seconds = static_cast<std::uint64_t>(
        std::chrono::floor<std::chrono::seconds>(start_.value()).count());
    TraceLine line;
    line.put(";$STARTTIME=");
    line.put_decimal(seconds / seconds_per_day + days_before_1970);
    line.put('.');
    const std::uint64_t of_day = seconds % seconds_per_day;
    line.put_decimal((of_day * parts + seconds_per_day - 1) / seconds_per_day, 12, '0');
    bytes += ";$FILEVERSION=2.1\n";
    bytes += line.view();
    bytes +=
        "\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n;\n"
        ";   Message   Time    Type Bus ID    Rx/Tx\n"
        ";   Number    Offset  |    |   [hex] |  Reserved\n"
        ";   |         [ms]    |    |   |     |  |  Data Length Code\n"
        ";   |         |       |    |   |     |  |  |    Data [hex] ...\n"
        ";---+-- ------+------ +- --+- --+-- +- +- +--  +- -- -- -- -- -- -- --\n";
  }

  void put_content(TraceLine& line, const TraceFrame& frame) {
    constexpr std::size_t id_width = 8;
    const Frame& content = frame.frame;
    line.put(content.is_error() ? " ER " : content.is_remote() ? " RR " : " DT ");
    const std::size_t bus_at = line.length();
    line.put_decimal(channels_[frame.channel]);
    line.pad_to(bus_at + 2);
    line.put(' ');
    if (content.is_error()) return put_error(line, content);
    line.pad_to(line.length() + (content.is_extended() ? 0 : id_width - 4));
    line.put_hex(content.id, content.is_extended() ? 8 : 4);
    line.put(frame.direction == TraceDirection::sent ? " Tx -  " : " Rx -  ");
    line.put(static_cast<char>('0' + content.length));
    line.put("   ");
    line.put_bytes(content);
  }

  // Writes kind, direction, position, counters of reception and of transmission.
  static void put_error(TraceLine& line, const Frame& error) {
    constexpr std::uint8_t kinds =
        error_violation::bit | error_violation::form | error_violation::stuff;
    const std::uint8_t violation = error.data[error_byte::violation];
    Frame bytes;
    bytes.length = 5;
    bytes.data = {
        static_cast<std::uint8_t>(violation & kinds),
        (violation & error_violation::on_transmission) != 0 ? std::uint8_t{0} : std::uint8_t{1},
        error.data[error_byte::location], error.data[error_byte::receive_counter],
        error.data[error_byte::transmit_counter]};
    line.put("       - Rx -  5   ");
    line.put_bytes(bytes);
  }

  TraceStart start_;
  TraceChannelNumbers channels_;
  std::uint64_t number_ = 0;
};

std::unique_ptr<TraceParser> recognize_trc(const TraceHead& head) {
  std::string_view line = head.line;
  skip_blanks(line);
  return line.starts_with(';') ? std::make_unique<TrcParser>() : nullptr;
}

}  // namespace

constinit const TraceFormat TraceFormat::trc{
    .name = "PEAK TRC",
    .endings = ".trc",
    .lacks = trace_lack::bus_names | trace_lack::comments | trace_lack::errors,
    .recognize = recognize_trc,
    .encoder = [](std::optional<Time> begin) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<TrcEncoder>(begin);
    },
};

}  // namespace canvoy::formats
