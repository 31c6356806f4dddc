// Screen output of candump: `  can0  185   [2]  1E 2F`, after a time or none (-t a, d, z, A), with
// `RX - -` (-x), with `{9}` for the raw data length code (-8) and with the bytes as characters
// (-a); the lines after an error frame give its details (-e), and begin with a tab.
#include "canvoy/formats/trace/trace_candump_screen.hpp"

#include <algorithm>
#include <chrono>

#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t date_length = 10;   // 2023-11-14
constexpr std::size_t epoch_digits = 10;  // of a time since 1970

/// `2023-11-14 22:13:20.000125`.
bool read_date(std::string_view text, Duration& time) {
  if (text.size() < date_length + 1 || text[4] != '-' || text[7] != '-') return false;
  std::int64_t year = 0;
  std::int64_t month = 0;
  std::int64_t day = 0;
  if (!read_decimal(text.substr(0, 4), year) || !read_decimal(text.substr(5, 2), month) ||
      !read_decimal(text.substr(8, 2), day)) {
    return false;
  }
  const std::chrono::year_month_day date{std::chrono::year{static_cast<int>(year)},
                                         std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  Duration of_day{};
  if (!date.ok() || !read_clock_time(text.substr(date_length + 1), of_day)) return false;
  time = std::chrono::sys_days{date}.time_since_epoch() + of_day;
  return true;
}

/// Takes the text in parentheses at the front; false if they are not closed.
bool take_time(std::string_view& line, std::string_view& time) {
  skip_blanks(line);
  if (!line.starts_with('(')) return true;
  const std::size_t end = line.find(')');
  if (end == std::string_view::npos) return false;
  time = line.substr(1, end - 1);
  line.remove_prefix(end + 1);
  return true;
}

bool is_length(std::string_view word) {
  const bool is_plain = word.starts_with('[') && word.ends_with(']');
  const bool is_code = word.starts_with('{') && word.ends_with('}');
  if (word.size() < 3 || word.size() > 4 || (!is_plain && !is_code)) return false;
  std::uint32_t number = 0;
  return read_hex(word.substr(1, word.size() - 2), number);
}

bool is_flag(std::string_view word, char flag) {
  return word.size() == 1 && (word[0] == '-' || word[0] == flag);
}

/// `[12]`: decimal, with two digits.
TraceStep read_screen_fd(const ScreenLine& line, TraceFrame& frame) {
  frame.fd = {};
  if (line.identifier.size() == 8) frame.frame.flags = FrameFlags::extended;
  std::int64_t length = 0;
  std::string_view bytes = line.bytes;
  if (read_hex(line.identifier, frame.frame.id) && read_decimal(line.length.substr(1, 2), length)) {
    take_fd_bytes(bytes, static_cast<std::size_t>(length), true, frame.fd);
  }
  return {TraceItem::fd, 0, {}};
}

bool read_bytes(std::string_view text, unsigned length, Frame& frame) {
  return take_bytes(text, length, true, frame);
}

}  // namespace

bool ScreenLine::parse(std::string_view line) {
  *this = {};
  if (!take_time(line, time)) return false;
  channel = take_word(line);
  identifier = take_word(line);
  if (identifier == "RX" || identifier == "TX") {
    direction = identifier == "RX" ? TraceDirection::received : TraceDirection::sent;
    if (!is_flag(take_word(line), 'B') || !is_flag(take_word(line), 'E')) return false;
    identifier = take_word(line);
  }
  length = take_word(line);
  std::uint32_t id = 0;
  const bool has_id =
      (identifier.size() == 3 || identifier.size() == 8) && read_hex(identifier, id);
  bytes = line;
  return has_id && is_length(length);
}

bool ScreenTimes::read(std::string_view text, Time& time) {
  Duration read{};
  std::int64_t microseconds = 0;
  if (text.empty()) {
    time = latest_;
    return true;
  }
  if (read_fixed(text, microsecond_digits, microseconds)) {
    read = Duration{microseconds};
    constexpr std::int64_t second_max = 1'000'000'000'000;
    if (microseconds / 1'000'000 > second_max / 2) return false;
    if (are_deltas_) read += latest_.time_since_epoch();
    if (read.count() / 1'000'000 > second_max) return false;
  } else if (!read_date(text, read)) {
    return false;
  }
  latest_ = Time{read};
  time = latest_;
  return true;
}

// A time less than the previous one counts from it: candump -t d and -t z look alike.
bool ScreenTimes::look_like_deltas(std::string_view head) {
  std::int64_t latest = 0;
  ScreenLine screen;
  while (!head.empty()) {
    const std::size_t end = head.find('\n');
    if (end == std::string_view::npos) break;
    std::int64_t time = 0;
    if (screen.parse(head.substr(0, end)) && screen.time.size() < epoch_digits + 1 &&
        read_fixed(screen.time, microsecond_digits, time)) {
      if (time < latest) return true;
      latest = time;
    }
    head.remove_prefix(end + 1);
  }
  return false;
}

TraceStep read_screen_line(const ScreenLine& line, ScreenTimes& times, TraceFrame& frame) {
  constexpr TraceStep read{TraceItem::frame, 0, {}};
  if (!times.read(line.time, frame.time)) return bad_record("the time is no number");
  frame.channel = line.channel;
  frame.direction = line.direction;
  frame.frame = {};
  if (line.length.size() == 4) return read_screen_fd(line, frame);
  std::uint32_t code = 0;
  std::uint32_t id = 0;
  if (!read_hex(line.length.substr(1, 1), code) || !read_hex(line.identifier, id)) {
    return bad_record("the identifier is no number");
  }
  const unsigned length = std::min<unsigned>(code, Frame::length_max);
  const bool is_long = line.identifier.size() == 8;
  if (is_long && (id & error_flag) != 0) {
    frame.frame.flags = FrameFlags::error;
    id &= ~error_flag;
  } else if (is_long) {
    frame.frame.flags = FrameFlags::extended;
  }
  frame.frame.id = id;
  if (id > (is_long ? Frame::extended_id_max : Frame::id_max)) {
    return bad_record("the identifier has more bits than there are");
  }
  std::string_view rest = line.bytes;
  if (take_word(rest) == "remote" && !frame.frame.is_error()) {
    frame.frame.flags = frame.frame.flags | FrameFlags::remote;
    frame.frame.length = static_cast<std::uint8_t>(length);
    return read;
  }
  if (!read_bytes(line.bytes, length, frame.frame)) {
    return bad_record("there are fewer bytes than the length says, or they are no bytes");
  }
  return read;
}

}  // namespace canvoy::formats
