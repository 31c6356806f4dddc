#include "canvoy/formats/trace/trace_candump.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace/trace_candump_screen.hpp"
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

bool read_usual_time(std::string_view line, Time& time) {
  if (line.size() < time_length || line[0] != '(' || line[1 + second_digits] != '.' ||
      line[time_length - 1] != ')')
    return false;
  std::int64_t microseconds = 0;
  if (!take_digits(line.data() + 1, second_digits, microseconds)) return false;
  if (!take_digits(line.data() + second_digits + 2, fraction_digits, microseconds)) return false;
  time = Time{Duration{microseconds}};
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
  if (!read_hex(text.substr(0, hash), frame.id)) return false;
  if (frame.id > (hash == 3 ? Frame::id_max : Frame::extended_id_max)) return false;
  frame.flags = hash == 3 ? FrameFlags::none : FrameFlags::extended;
  return read_usual_data(text.substr(hash + 1), frame);
}

// What nearly all lines of a log look like, in a fraction of the time that parse_log_line takes;
// whatever is written otherwise is left to that.
bool read_usual_line(std::string_view line, TraceFrame& frame) {
  if (!read_usual_time(line, frame.time)) return false;
  line.remove_prefix(time_length);
  frame.channel = take_word(line);
  if (!read_usual_frame(take_word(line), frame.frame)) return false;
  return true;
}

TraceDirection direction_of(std::string_view line) {
  if (line.ends_with(" R")) return TraceDirection::received;
  return line.ends_with(" T") ? TraceDirection::sent : TraceDirection::unknown;
}

bool is_detail(std::string_view line) {
  return line.size() > 1 && line[0] == '\t' && line[1] >= 'a' && line[1] <= 'z';
}

class CandumpParser final : public TraceLineParser {
 public:
  explicit CandumpParser(bool are_deltas) : times_(are_deltas) {}
  TraceFormat format() const override { return TraceFormat::candump; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& frame) override {
    frame.direction = direction_of(line);
    if (read_usual_line(line, frame)) return {TraceItem::frame, 0, {}};
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
        return {TraceItem::fd, 0, {}};
      case host::LogLineKind::malformed:
        break;
    }
    return bad_record(read.problem);
  }

 private:
  ScreenTimes times_;
};

}  // namespace

std::unique_ptr<TraceParser> make_candump_parser(bool are_deltas) {
  return std::make_unique<CandumpParser>(are_deltas);
}

}  // namespace canvoy::formats
