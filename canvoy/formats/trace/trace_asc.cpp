// Vector ASC: `   0.000125 1  185             Rx   d 2 1E 2F`, with or without a header.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_line.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_scanner.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::int64_t second_max = 1'000'000'000'000;  // times 10^6 fits in 63 bits

class AscParser final : public TraceLineParser {
 public:
  AscParser() : TraceLineParser(Behind::end_of_line) {}
  const TraceFormat& format() const override { return TraceFormat::asc; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& frame) override;

 private:
  TraceStep read_header(std::string_view line);
  bool read_usual_line(std::string_view line, TraceFrame& frame);
  bool read_time(std::string_view word, Time& time);
  TraceStep read_event(std::string_view channel, std::string_view rest, TraceFrame& frame);
  TraceStep read_fd_event(std::string_view rest, TraceFrame& frame);
  TraceStep read_fd_content(std::string_view rest, std::uint32_t code, std::int64_t length,
                            TraceFrame& frame) const;
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
  if (read_usual_line(line, frame)) return {TraceItem::frame, 0, {}};
  skip_blanks(line);
  if (line.empty() || line.front() < '0' || line.front() > '9') return read_header(line);
  if (!read_time(take_word(line), frame.time)) return bad_record("the time is no number");
  const std::string_view channel = take_word(line);
  return read_event(channel, line, frame);
}

// Fast path for the common form of a line; other forms are left to the tolerant path.
bool AscParser::read_usual_line(std::string_view line, TraceFrame& frame) {
  if (!hexadecimal_ || relative_) return false;
  TraceScanner scanner(line);
  std::int64_t microseconds = 0;
  unsigned channel = 0;
  scanner.skip_blanks();
  if (!scanner.take_fixed<microsecond_digits>(microseconds) || !scanner.take_blanks()) return false;
  if (!scanner.take_number(channel) || !scanner.take_blanks()) return false;
  frame.channel = channel_.name(channel);
  frame.frame = {};
  if (frame.channel.empty() || scanner.take_hex(frame.frame.id) == 0) return false;
  const bool extended = scanner.take('x');
  frame.frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
  if (frame.frame.id > (extended ? Frame::extended_id_max : Frame::id_max)) return false;
  if (!scanner.take_blanks()) return false;
  const char direction = scanner.take_direction();
  unsigned length = 0;
  if (direction == 0 || !scanner.take_blanks() || !scanner.take('d') || !scanner.take_blanks() ||
      !scanner.take_digit(length) || !scanner.take_bytes(length, frame.frame)) {
    return false;
  }
  frame.direction = direction == 'R' ? TraceDirection::received : TraceDirection::sent;
  latest_ = microseconds;
  frame.time = Time{start_ + Duration{latest_}};
  return true;
}

TraceStep AscParser::read_header(std::string_view line) {
  const std::string_view word = take_word(line);
  if (word == "date") {
    read_asc_date(line, start_);
    return trace_note;
  }
  if (word == "base") {
    const std::string_view base = take_word(line);
    if (base != "hex" && base != "dec") return bad_record("the base is neither hex nor dec");
    hexadecimal_ = base == "hex";
    relative_ = line.find("relative") != std::string_view::npos;
    return trace_note;
  }
  if (word.empty() || word.starts_with("//")) return trace_note;
  if (word == "Begin" || word == "End" || word == "internal" || word == "no") return trace_note;
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

// `ECC: 10100010`: the register of an SJA1000, as bits.
bool read_bits(std::string_view word, unsigned& value) {
  constexpr std::size_t bits = 8;
  value = 0;
  for (const char c : word) {
    if (c != '0' && c != '1') return false;
    value = value << 1 | (c == '1' ? 1U : 0U);
  }
  return word.size() == bits;
}

// `Flags = 0xe CodeExt = 0x20a2 Code = 0x82 ID = 0 DLC = 0`: the flags give the register of the
// code.
TraceError read_asc_error(std::string_view rest) {
  std::uint32_t flags = 0;
  std::uint32_t code = 0;
  unsigned bits = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word == "ECC:")
      return read_bits(take_word(rest), bits) ? sja1000_error(bits) : TraceError{};
    if (word != "Flags" && word != "Code") continue;
    std::uint32_t& value = word == "Flags" ? flags : code;
    std::string_view number = take_word(rest) == "=" ? take_word(rest) : std::string_view{};
    if (number.starts_with("0x")) number.remove_prefix(2);
    if (!read_hex(number, value)) return {};
  }
  return vector_error(flags, code);
}

// An event that is no frame has a word instead of the channel, or after it.
TraceStep AscParser::read_event(std::string_view channel, std::string_view rest,
                                TraceFrame& frame) {
  if (channel == "CANFD") return read_fd_event(rest, frame);
  std::int64_t number = 0;
  if (!read_decimal(channel, number)) return trace_note;
  frame.channel = channel_.name(number);
  if (frame.channel.empty()) return bad_record("the channel is not 1 to 255");
  const std::string_view identifier = take_word(rest);
  frame.direction = TraceDirection::unknown;
  frame.frame = {};
  if (identifier == "ErrorFrame") {
    frame.frame = trace_error_frame(read_asc_error(rest));
    return {TraceItem::frame, 0, {}};
  }
  const std::string_view direction = take_word(rest);
  if (direction != "Rx" && direction != "Tx") return trace_note;
  frame.direction = direction == "Rx" ? TraceDirection::received : TraceDirection::sent;
  if (!read_identifier(identifier, frame.frame)) return bad_record("the identifier is no number");
  return read_content(rest, frame.frame);
}

// `CANFD 1 Rx 185 name 0 0 2 2 1E 2F 130000 130 1000 ...`: BRS, ESI, data length code, length,
// bytes, duration, bits, flags. The name is optional. A CAN FD channel carries classic frames too.
TraceStep AscParser::read_fd_event(std::string_view rest, TraceFrame& frame) {
  constexpr TraceStep fd{TraceItem::fd, 0, {}};
  frame.frame = {};
  frame.fd = {};
  std::int64_t channel = 0;
  if (!read_decimal(take_word(rest), channel)) return fd;
  frame.channel = channel_.name(channel);
  if (frame.channel.empty()) return bad_record("the channel is not 1 to 255");
  const std::string_view direction = take_word(rest);
  frame.direction = direction == "Tx" ? TraceDirection::sent : TraceDirection::received;
  if (!read_identifier(take_word(rest), frame.frame)) return fd;
  std::string_view bit_rate_switch = take_word(rest);
  if (bit_rate_switch != "0" && bit_rate_switch != "1") bit_rate_switch = take_word(rest);
  if (bit_rate_switch == "1") frame.fd.flags |= TraceFdContent::bit_rate_switch;
  if (take_word(rest) == "1") frame.fd.flags |= TraceFdContent::error_state;
  std::uint32_t code = 0;
  std::int64_t length = 0;
  if (!read_hex(take_word(rest), code) || !read_decimal(take_word(rest), length)) return fd;
  return read_fd_content(rest, code, length, frame);
}

// Some programs write the length in hexadecimal; the code gives it as well.
TraceStep AscParser::read_fd_content(std::string_view rest, std::uint32_t code, std::int64_t length,
                                     TraceFrame& frame) const {
  constexpr std::uint32_t remote_bit = 0x10;
  constexpr std::uint32_t fd_flag = 0x1000;
  const bool is_remote_length = length == 0;
  const std::size_t count = is_remote_length ? 0 : fd_length(code);
  take_fd_bytes(rest, count, hexadecimal_, frame.fd);
  if (frame.fd.length < count) return {TraceItem::fd, 0, {}};
  take_word(rest);
  take_word(rest);
  std::uint32_t flags = fd_flag;
  const bool is_fd = !read_hex(take_word(rest), flags) || (flags & fd_flag) != 0;
  if (is_fd || count > Frame::length_max) return {TraceItem::fd, 0, {}};
  Frame& content = frame.frame;
  content.length = static_cast<std::uint8_t>(count);
  std::copy_n(frame.fd.data.begin(), count, content.data.begin());
  if ((flags & remote_bit) != 0) {
    content.flags = content.flags | FrameFlags::remote;
    content.data.fill(0);
    content.length = static_cast<std::uint8_t>(std::min<std::uint32_t>(code, Frame::length_max));
  }
  return {TraceItem::frame, 0, {}};
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
  // Some programs write `d 40` for 8: the length in bits.
  if (code_word == "40") code = Frame::length_max;
  if (code_word != "40" && (code_word.size() != 1 || !read_hex(code_word, code)))
    return bad_record("the data length code is not 0 to F");
  const unsigned length = code < Frame::length_max ? code : Frame::length_max;
  if (!take_bytes(rest, length, hexadecimal_, frame))
    return bad_record("there are fewer bytes than the data length code says, or they are no bytes");
  return {TraceItem::frame, 0, {}};
}

// Older programs write no length; newer ones append `Length = 1704000`.
TraceStep AscParser::read_remote(std::string_view rest, Frame& frame) const {
  std::uint32_t code = 0;
  const std::string_view word = take_word(rest);
  if (word.size() == 1 && !read_hex(word, code)) return bad_record("the length is not 0 to F");
  frame.flags = frame.flags | FrameFlags::remote;
  frame.length = static_cast<std::uint8_t>(code < Frame::length_max ? code : Frame::length_max);
  return {TraceItem::frame, 0, {}};
}

// Writes like log2asc of can-utils, with the register of error frames at the end.
class AscEncoder final : public TraceEncoder {
 public:
  explicit AscEncoder(std::optional<Time> begin) : start_(begin) {}

  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    if (!start_.is_known()) {
      start_.set(frame);
      append_header(bytes, std::chrono::floor<std::chrono::seconds>(start_.value()));
    }
    TraceLine line;
    const Duration offset = time_from(frame, start_.value()) - start_.value();
    time_.put(line, static_cast<std::uint64_t>(offset.count()));
    const std::size_t channel_at = line.length() + 1;
    line.put(' ');
    line.put_decimal(channels_[frame.channel]);
    line.pad_to(channel_at + 2);
    put_content(line, frame);
    line.put('\n');
    bytes += line.view();
  }

 private:
  static void append_header(std::string& bytes, std::chrono::seconds start);
  static void put_content(TraceLine& line, const TraceFrame& frame);

  TraceStart start_;
  TraceSeconds time_{{.width = 4}};
  TraceChannelNumbers channels_;
};

void AscEncoder::append_header(std::string& bytes, std::chrono::seconds start) {
  constexpr std::array<std::string_view, 7> days = {"Sun", "Mon", "Tue", "Wed",
                                                    "Thu", "Fri", "Sat"};
  constexpr std::array<std::string_view, 12> months = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const auto day = std::chrono::floor<std::chrono::days>(std::chrono::sys_seconds{start});
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{std::chrono::sys_seconds{start} - day};
  TraceLine line;
  line.put("date ");
  line.put(days.at(std::chrono::weekday{day}.c_encoding()));
  line.put(' ');
  line.put(months.at(static_cast<unsigned>(date.month()) - 1));
  line.put(' ');
  line.put_decimal(static_cast<unsigned>(date.day()));
  line.put(' ');
  line.put_decimal(static_cast<std::uint64_t>(clock.hours().count()), 2, '0');
  line.put(':');
  line.put_decimal(static_cast<std::uint64_t>(clock.minutes().count()), 2, '0');
  line.put(':');
  line.put_decimal(static_cast<std::uint64_t>(clock.seconds().count()), 2, '0');
  line.put(' ');
  line.put_decimal(static_cast<std::uint64_t>(static_cast<int>(date.year())));
  bytes += line.view();
  bytes += "\nbase hex  timestamps absolute\nno internal events logged\n";
}

void AscEncoder::put_content(TraceLine& line, const TraceFrame& frame) {
  constexpr std::size_t id_width = 15;
  const Frame& content = frame.frame;
  line.put(' ');
  if (content.is_error()) {
    line.put("ErrorFrame");
    const std::optional<std::uint8_t> ecc = sja1000_register(content);
    if (!ecc) return;
    line.put("  ECC: ");
    for (unsigned bit = 8; bit > 0;) line.put((unsigned{*ecc} >> --bit & 1U) != 0 ? '1' : '0');
    return;
  }
  const std::size_t id_at = line.length();
  line.put_hex(content.id, 1);
  if (content.is_extended()) line.put('x');
  line.pad_to(id_at + id_width);
  line.put(frame.direction == TraceDirection::sent ? " Tx   " : " Rx   ");
  line.put(content.is_remote() ? 'r' : 'd');
  line.put(' ');
  line.put(static_cast<char>('0' + content.length));
  line.put_bytes(content);
}

/// True for a line with a frame: some programs write no header.
bool is_asc_frame(std::string_view line) {
  std::string_view rest = line;
  std::int64_t number = 0;
  const std::string_view time = take_word(rest);
  if (time.find('.') == std::string_view::npos || !read_fixed(time, 6, number)) return false;
  std::string_view channel = take_word(rest);
  if (channel == "CANFD") return true;
  if (!read_decimal(channel, number) || number < 1 || number > TraceChannel::number_max)
    return false;
  std::string_view id = take_word(rest);
  if (id == "ErrorFrame") return true;
  if (id.ends_with('x')) id.remove_suffix(1);
  std::uint32_t value = 0;
  const std::string_view direction = take_word(rest);
  const std::string_view kind = take_word(rest);
  return read_hex(id, value) && (direction == "Rx" || direction == "Tx") &&
         (kind == "d" || kind == "r");
}

std::unique_ptr<TraceParser> recognize_asc(const TraceHead& head) {
  const std::string_view line = head.line;
  if (line.starts_with("date ") || line.starts_with("base hex") || line.starts_with("base dec") ||
      is_asc_frame(line)) {
    return std::make_unique<AscParser>();
  }
  return nullptr;
}

}  // namespace

constinit const TraceFormat TraceFormat::asc{
    .name = "Vector ASC",
    .endings = ".asc",
    .lacks = trace_lack::bus_names | trace_lack::comments | trace_lack::errors,
    .recognize = recognize_asc,
    .encoder = [](std::optional<Time> begin) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<AscEncoder>(begin);
    },
};

}  // namespace canvoy::formats
