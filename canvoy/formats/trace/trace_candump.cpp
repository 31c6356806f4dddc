// candump -l: `(1700000000.000125) can0 185#1E2F`, newer ones followed by ` R` or ` T`; and the
// screen output of candump.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace/trace_candump_screen.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_line.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t second_digits = 10;
constexpr std::size_t fraction_digits = 6;
constexpr std::size_t time_length = 1 + second_digits + 1 + fraction_digits + 1;

bool take_digits(const char* text, std::size_t count, std::int64_t& sum) {
  std::int64_t value = sum;
  unsigned wrong = 0;
  for (std::size_t at = 0; at < count; ++at) {
    const unsigned digit = static_cast<unsigned char>(text[at]) - unsigned{'0'};
    wrong |= static_cast<unsigned>(digit > 9);
    value = value * 10 + static_cast<std::int64_t>(digit);
  }
  sum = value;
  return wrong == 0;
}

/// Six decimal digits; eight characters are read.
bool take_six(const char* text, std::int64_t& sum) {
  if constexpr (std::endian::native != std::endian::little) return take_digits(text, 6, sum);
  constexpr std::uint64_t zeros = 0x3030'3030'3030'3030;
  constexpr std::uint64_t high_halves = 0xF0F0'F0F0'F0F0'F0F0;
  // As eight digits: two zeros in front, in place of the two characters behind.
  std::uint64_t digits = detail::load<std::uint64_t>(text) << 16 | 0x3030;
  const std::uint64_t above_nine = digits + 0x0606'0606'0606'0606;
  if ((((digits & high_halves) ^ zeros) | ((above_nine & high_halves) ^ zeros)) != 0) return false;
  // Pairs, then fours, then all of them; the first digit is the lowest byte.
  digits -= zeros;
  digits = digits * 10 + (digits >> 8);
  constexpr std::uint64_t every_fourth = 0x0000'00FF'0000'00FF;
  digits = (digits & every_fourth) * (100 + (std::uint64_t{1'000'000} << 32)) +
           (digits >> 16 & every_fourth) * (1 + (std::uint64_t{10'000} << 32));
  sum = sum * 1'000'000 + static_cast<std::int64_t>(digits >> 32);
  return true;
}

bool read_usual_data(std::string_view pairs, Frame& frame) {
  const std::size_t length = pairs.size() / 2;
  if (pairs.size() % 2 != 0 || length > Frame::length_max) return false;
  unsigned seen = 0;
  for (std::size_t at = 0; at < length; ++at) {
    const unsigned high = hex_digit(pairs[2 * at]);
    const unsigned low = hex_digit(pairs[2 * at + 1]);
    seen |= high | low;
    frame.data[at] = static_cast<std::uint8_t>(high << 4 | low);
  }
  frame.length = static_cast<std::uint8_t>(length);
  return seen < 16;
}

// 185#1E2F or 00000185#1E2F.
bool read_usual_frame(std::string_view text, Frame& frame) {
  frame = {};
  const std::size_t hash = text.size() > 3 && text[3] == '#' ? 3 : 8;
  if (text.size() <= hash || text[hash] != '#') return false;
  if (!read_hex({text.data(), hash}, frame.id)) return false;
  if (frame.id > (hash == 3 ? Frame::id_max : Frame::extended_id_max)) return false;
  frame.flags = hash == 3 ? FrameFlags::none : FrameFlags::extended;
  text.remove_prefix(hash + 1);
  return read_usual_data(text, frame);
}

/// Fast path for the common form of a line; other forms are left to parse_log_line. Most lines have
/// the second and the interface of the line before.
class CandumpLine {
 public:
  /// Without a direction at its end.
  bool read(std::string_view line, TraceFrame& frame) {
    if (!read_time(line, frame.time) || line[time_length] != ' ') return false;
    line.remove_prefix(time_length + 1);
    const bool is_same =
        line.size() >= channel_.size() && same_bytes({line.data(), channel_.size()}, channel_);
    if (!is_same && !take_channel(line)) return false;
    frame.channel = {line.data(), channel_.size() - 1};
    line.remove_prefix(channel_.size());
    return read_usual_frame(line, frame.frame);
  }

 private:
  static constexpr std::size_t second_length = 1 + second_digits + 1;

  bool read_time(std::string_view line, Time& time) {
    if (line.size() <= time_length || line[time_length - 1] != ')') return false;
    const bool is_same = std::memcmp(line.data(), second_.data(), second_length) == 0;
    if (!is_same && !take_second(line)) return false;
    std::int64_t microseconds = seconds_;
    if (!take_six(line.data() + second_length, microseconds)) return false;
    time = Time{Duration{microseconds}};
    return true;
  }
  bool take_second(std::string_view line) {
    if (line[0] != '(' || line[second_length - 1] != '.') return false;
    std::int64_t seconds = 0;
    if (!take_digits(line.data() + 1, second_digits, seconds)) return false;
    seconds_ = seconds;
    std::copy_n(line.data(), second_length, second_.data());
    return true;
  }
  bool take_channel(std::string_view line) {
    const std::size_t length = line.find(' ');
    if (length == std::string_view::npos || length == 0) return false;
    if (line.substr(0, length).find('\t') != std::string_view::npos) return false;
    channel_ = line.substr(0, length + 1);
    return true;
  }

  std::array<char, second_length + 1> second_ = {"(0000000000."};
  std::int64_t seconds_ = 0;
  std::string channel_ = "can0 ";  ///< with the blank behind it
};

TraceDirection direction_of(std::string_view line) {
  if (line.size() < 2 || line[line.size() - 2] != ' ') return TraceDirection::unknown;
  if (line.back() == 'R') return TraceDirection::received;
  return line.back() == 'T' ? TraceDirection::sent : TraceDirection::unknown;
}

bool is_detail(std::string_view line) {
  return line.size() > 1 && line[0] == '\t' && line[1] >= 'a' && line[1] <= 'z';
}

// `(1700000000.000125) can0 185##1AABB`: flags, then the bytes.
void read_fd_frame(std::string_view line, TraceFrame& frame) {
  frame.frame = {};
  frame.fd = {};
  const std::size_t hashes = line.find("##");
  if (hashes == std::string_view::npos || hashes + 3 > line.size()) return;
  std::string_view before = line.substr(0, hashes);
  const std::size_t blank = before.find_last_of(" \t");
  const std::string_view id = before.substr(blank == std::string_view::npos ? 0 : blank + 1);
  if (!read_hex(id, frame.frame.id)) return;
  if (id.size() > 3) frame.frame.flags = FrameFlags::extended;
  frame.fd.flags = static_cast<std::uint8_t>(hex_digit(line[hashes + 2]) & 3U);
  std::string_view pairs = line.substr(hashes + 3);
  for (std::uint32_t byte = 0; frame.fd.length < frame.fd.data.size() && pairs.size() >= 2 &&
                               read_hex(pairs.substr(0, 2), byte);
       pairs.remove_prefix(2)) {
    frame.fd.data.at(frame.fd.length++) = static_cast<std::uint8_t>(byte);
  }
}

class CandumpParser final : public TraceLineParser {
 public:
  explicit CandumpParser(bool are_deltas) : times_(are_deltas) {}
  const TraceFormat& format() const override { return TraceFormat::candump; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& frame) override {
    frame.direction = direction_of(line);
    const std::size_t behind = frame.direction == TraceDirection::unknown ? 0 : 2;
    if (usual_.read({line.data(), line.size() - behind}, frame)) return {TraceItem::frame, 0, {}};
    // The details of an error frame above (-e).
    if (is_detail(line)) return trace_note;
    ScreenLine screen;
    if (screen.parse(line)) return read_screen_line(screen, times_, frame);
    const host::LogLine read = host::parse_log_line(line);
    frame.time = read.time;
    frame.frame = read.frame;
    frame.channel = read.interface;
    switch (read.kind) {
      case host::LogLineKind::frame:
        return {TraceItem::frame, 0, {}};
      case host::LogLineKind::note:
        return trace_note;
      case host::LogLineKind::fd:
        read_fd_frame(line, frame);
        return {TraceItem::fd, 0, {}};
      case host::LogLineKind::malformed:
        break;
    }
    return bad_record(read.problem);
  }

 private:
  ScreenTimes times_;
  CandumpLine usual_;
};

class CandumpEncoder final : public TraceEncoder {
 public:
  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    TraceLine line;
    time_.put(line, static_cast<std::uint64_t>(
                        std::max<std::int64_t>(frame.time.time_since_epoch().count(), 0)));
    line.put(") ");
    const std::string_view name = name_of(frame.channel);
    if (name.size() <= name_usual_max) {
      line.put(name);
    } else {
      bytes.append(line.view()).append(name);
      line.clear();
    }
    put_frame(line, frame.frame);
    bytes += line.view();
  }

 private:
  static void put_frame(TraceLine& line, const Frame& frame) {
    line.put(' ');
    line.put_hex(frame.id | (frame.is_error() ? error_flag : 0U),
                 frame.is_extended() || frame.is_error() ? 8 : 3);
    line.put('#');
    if (frame.is_remote()) line.put('R');
    if (frame.is_remote() && frame.length > 0) line.put(static_cast<char>('0' + frame.length));
    line.put_pairs(frame.payload());
    line.put('\n');
  }

  // The name of an interface ends at a blank; names of other systems contain blanks.
  std::string_view name_of(std::string_view channel) {
    if (same_bytes(channel, latest_) && !name_.empty()) return name_;
    latest_ = channel;
    name_ = channel.empty() ? "can0" : channel;
    std::ranges::replace_if(
        name_, [](char each) { return each <= ' ' && each >= 0; }, '_');
    return name_;
  }

  static constexpr std::size_t name_usual_max = 64;

  TraceSeconds time_{{.before = '(', .width = 10, .fill = '0'}};
  std::string latest_;
  std::string name_;
};

std::unique_ptr<TraceParser> recognize_candump(const TraceHead& head) {
  std::string_view line = head.line;
  skip_blanks(line);
  // An empty file is a log without frames.
  const bool is_empty =
      head.is_first && head.rest.find_first_not_of(" \t\r\n") == std::string_view::npos;
  ScreenLine screen;
  if (!is_empty && !line.starts_with('(') && !line.starts_with("DROPCOUNT") && !screen.parse(line))
    return nullptr;
  return std::make_unique<CandumpParser>(ScreenTimes::look_like_deltas(head.rest));
}

}  // namespace

constinit const TraceFormat TraceFormat::candump{
    .name = "candump log",
    .endings = ".log .candump",
    .lacks = trace_lack::direction | trace_lack::comments,
    .recognize = recognize_candump,
    .encoder = [](std::optional<Time>) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<CandumpEncoder>();
    },
};

}  // namespace canvoy::formats
