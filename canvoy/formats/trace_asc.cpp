// Vector ASC: `   3.098426 1  18EBFF00x       Rx d 8 01 A0 0F A6 60 3B D1 40`, behind a header that
// says when it began, in which base its numbers are, and whether times count from the line before.
#include <cstdint>
#include <memory>
#include <string_view>

#include "canvoy/formats/trace_fields.hpp"
#include "canvoy/formats/trace_parser.hpp"
#include "canvoy/formats/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t microsecond_digits = 6;
constexpr std::int64_t second_max = 1'000'000'000'000;  // times 10^6, it fits in 63 bits

constexpr TraceStep note{TraceItem::note, 0, {}};

class AscParser final : public TraceLineParser {
 public:
  TraceFormat format() const override { return TraceFormat::asc; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& frame) override;

 private:
  TraceStep read_header(std::string_view line);
  bool read_time(std::string_view word, Time& time);
  TraceStep read_event(std::string_view channel, std::string_view rest, TraceFrame& frame);
  bool read_identifier(std::string_view word, Frame& frame) const;
  TraceStep read_content(std::string_view rest, Frame& frame) const;
  TraceStep read_remote(std::string_view rest, Frame& frame) const;

  TraceChannel channel_;
  Duration start_{};
  std::int64_t latest_ = 0;
  bool hexadecimal_ = true;
  bool relative_ = false;
};

TraceStep AscParser::read_line(std::string_view line, TraceFrame& frame) {
  skip_blanks(line);
  if (line.empty() || line.front() < '0' || line.front() > '9') return read_header(line);
  if (!read_time(take_word(line), frame.time)) return bad_record("the time is no number");
  const std::string_view channel = take_word(line);
  return read_event(channel, line, frame);
}

TraceStep AscParser::read_header(std::string_view line) {
  const std::string_view word = take_word(line);
  if (word == "date") {
    read_asc_date(line, start_);
    return note;
  }
  if (word == "base") {
    const std::string_view base = take_word(line);
    if (base != "hex" && base != "dec") return bad_record("the base is neither hex nor dec");
    hexadecimal_ = base == "hex";
    relative_ = line.find("relative") != std::string_view::npos;
    return note;
  }
  if (word.empty() || word.starts_with("//")) return note;
  if (word == "Begin" || word == "End" || word == "internal" || word == "no") return note;
  return bad_record("it begins neither with a time nor with a word of the header");
}

bool AscParser::read_time(std::string_view word, Time& time) {
  std::int64_t microseconds = 0;
  if (!read_fixed(word, microsecond_digits, microseconds)) return false;
  if (relative_) microseconds += latest_;
  if (microseconds > second_max * 1'000'000) return false;
  latest_ = microseconds;
  time = Time{start_ + Duration{latest_}};
  return true;
}

// An event that is no frame has a word instead of the channel, or behind it.
TraceStep AscParser::read_event(std::string_view channel, std::string_view rest,
                                TraceFrame& frame) {
  if (channel == "CANFD") return {TraceItem::fd, 0, {}};
  std::int64_t number = 0;
  if (!read_decimal(channel, number)) return note;
  frame.channel = channel_.name(number);
  if (frame.channel.empty()) return bad_record("the channel is not 1 to 255");
  const std::string_view identifier = take_word(rest);
  frame.direction = TraceDirection::unknown;
  frame.frame = {};
  if (identifier == "ErrorFrame") {
    frame.frame = trace_error_frame();
    return {TraceItem::frame, 0, {}};
  }
  const std::string_view direction = take_word(rest);
  if (direction != "Rx" && direction != "Tx") return note;
  frame.direction = direction == "Rx" ? TraceDirection::received : TraceDirection::sent;
  if (!read_identifier(identifier, frame.frame)) return bad_record("the identifier is no number");
  return read_content(rest, frame.frame);
}

bool AscParser::read_identifier(std::string_view word, Frame& frame) const {
  const bool extended = word.ends_with('x');
  if (extended) word.remove_suffix(1);
  std::uint32_t hexadecimal = 0;
  std::int64_t number = 0;
  if (hexadecimal_ ? !read_hex(word, hexadecimal) : !read_decimal(word, number)) return false;
  if (hexadecimal_) number = hexadecimal;
  frame.id = static_cast<std::uint32_t>(number & Frame::extended_id_max);
  frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
  return number <= (extended ? Frame::extended_id_max : Frame::id_max);
}

TraceStep AscParser::read_content(std::string_view rest, Frame& frame) const {
  const std::string_view kind = take_word(rest);
  if (kind == "r") return read_remote(rest, frame);
  if (kind != "d") return bad_record("behind the direction is neither d nor r");
  std::uint32_t code = 0;
  const std::string_view code_word = take_word(rest);
  if (code_word.size() != 1 || !read_hex(code_word, code))
    return bad_record("the data length code is not 0 to F");
  const unsigned length = code < Frame::length_max ? code : Frame::length_max;
  if (!take_bytes(rest, length, hexadecimal_, frame))
    return bad_record("there are fewer bytes than the data length code says, or they are no bytes");
  return {TraceItem::frame, 0, {}};
}

// Older programs write no length; newer ones go on with `Length = 1704000`.
TraceStep AscParser::read_remote(std::string_view rest, Frame& frame) const {
  std::uint32_t code = 0;
  const std::string_view word = take_word(rest);
  if (word.size() == 1 && !read_hex(word, code)) return bad_record("the length is not 0 to F");
  frame.flags = frame.flags | FrameFlags::remote;
  frame.length = static_cast<std::uint8_t>(code < Frame::length_max ? code : Frame::length_max);
  return {TraceItem::frame, 0, {}};
}

}  // namespace

std::unique_ptr<TraceParser> make_asc_parser() {
  return std::make_unique<AscParser>();
}

}  // namespace canvoy::formats
