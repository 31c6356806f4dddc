// CSV of python-can: `timestamp,arbitration_id,extended,remote,error,dlc,data`, data in base64; and
// of SavvyCAN: `Time Stamp,ID,Extended,Dir,Bus,LEN,D1,...`, times in microseconds.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_line.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_scanner.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::string_view python_can_header =
    "timestamp,arbitration_id,extended,remote,error,dlc,data";
constexpr std::string_view savvycan_header = "Time Stamp,ID,Extended,";
constexpr std::int64_t cell_microseconds_max = 1'000'000'000'000'000'000;

constexpr TraceStep read{TraceItem::frame, 0, {}};

std::string_view take_cell(std::string_view& line) {
  const std::size_t comma = std::min(line.find(','), line.size());
  std::string_view cell = line.substr(0, comma);
  line.remove_prefix(std::min(comma + 1, line.size()));
  skip_blanks(cell);
  while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
  return cell;
}

bool read_flag(std::string_view cell, bool& flag) {
  flag = cell == "1" || cell == "true" || cell == "True";
  return flag || cell == "0" || cell == "false" || cell == "False";
}

/// Python writes small numbers as `1e-05`.
bool read_seconds(std::string_view cell, Time& time) {
  std::int64_t microseconds = 0;
  if (!read_fixed(cell, microsecond_digits, microseconds)) {
    double seconds = 0;
    const char* const end = cell.data() + cell.size();
    const auto [last, error] = real_from_chars(cell.data(), end, seconds);
    if (error != std::errc{} || last != end || !(seconds >= 0 && seconds < 1e12)) return false;
    microseconds = static_cast<std::int64_t>(seconds * 1e6 + 0.5);
  }
  time = Time{Duration{microseconds}};
  return microseconds <= cell_microseconds_max;
}

constexpr std::string_view base64_characters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_base64_digit = 64;
constexpr std::array<std::uint8_t, 256> base64_digits = [] {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(no_base64_digit);
  for (std::uint8_t value = 0; value < no_base64_digit; ++value) {
    digits[static_cast<std::uint8_t>(base64_characters[value])] = value;
  }
  return digits;
}();

/// Reads into `data` and `length`; false if it is no base64, or does not fit.
bool read_base64(std::string_view text, std::span<std::uint8_t> data, std::uint8_t& length) {
  while (text.ends_with('=')) text.remove_suffix(1);
  unsigned bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    const unsigned digit = base64_digits[static_cast<std::uint8_t>(c)];
    if (digit == no_base64_digit) return false;
    bits = (bits << 6 | digit) & 0xFFFF;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    if (length == data.size()) return false;
    data[length++] = static_cast<std::uint8_t>(bits >> count);
  }
  return count < 6;
}

bool has_valid_id(const Frame& frame) {
  return frame.id <=
         (frame.is_extended() || frame.is_error() ? Frame::extended_id_max : Frame::id_max);
}

/// Reads a line of a data frame as python-can and we write it; other forms are left to the tolerant
/// path.
bool read_usual_line(std::string_view line, TraceFrame& heard) {
  TraceScanner scanner(line);
  std::int64_t microseconds = 0;
  if (!scanner.take_fixed<microsecond_digits>(microseconds) || !scanner.take(',')) return false;
  if (microseconds > cell_microseconds_max || !scanner.take('0') || !scanner.take('x'))
    return false;
  Frame& frame = heard.frame;
  frame = {};
  if (scanner.take_hex(frame.id) == 0 || !scanner.take(',')) return false;
  unsigned extended = 0;
  unsigned length = 0;
  if (!scanner.take_digit(extended) || extended > 1) return false;
  for (const char character : std::string_view(",0,0,")) {
    if (!scanner.take(character)) return false;
  }
  if (!scanner.take_digit(length) || length > Frame::length_max || !scanner.take(',')) return false;
  frame.flags = extended != 0 ? FrameFlags::extended : FrameFlags::none;
  if (!has_valid_id(frame) || !read_base64(scanner.rest(), frame.data, frame.length)) return false;
  heard.time = Time{Duration{microseconds}};
  return frame.length == length;
}

class PythonCanParser final : public TraceLineParser {
 public:
  PythonCanParser() : TraceLineParser(Behind::end_of_line) {}
  const TraceFormat& format() const override { return TraceFormat::python_can_csv; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& heard) override {
    heard.channel = "can0";
    heard.direction = TraceDirection::unknown;
    return read_usual_line(line, heard) ? read : read_any_line(line, heard);
  }

 private:
  static TraceStep read_any_line(std::string_view line, TraceFrame& heard) {
    if (line.empty() || line.starts_with(python_can_header)) return trace_note;
    if (!read_seconds(take_cell(line), heard.time)) return bad_record("the time is no number");
    heard.frame = {};
    Frame& frame = heard.frame;
    std::string_view id = take_cell(line);
    if (id.starts_with("0x")) id.remove_prefix(2);
    if (!read_hex(id, frame.id)) return bad_record("the identifier is no number");
    bool extended = false;
    bool remote = false;
    bool error = false;
    if (!read_flag(take_cell(line), extended) || !read_flag(take_cell(line), remote) ||
        !read_flag(take_cell(line), error)) {
      return bad_record("extended, remote and error are not 0 or 1");
    }
    std::int64_t length = 0;
    if (!read_decimal(take_cell(line), length)) return bad_record("the length is no number");
    if (length > Frame::length_max) {
      frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
      heard.fd = {};
      read_base64(take_cell(line), heard.fd.data, heard.fd.length);
      return {TraceItem::fd, 0, {}};
    }
    return read_content(take_cell(line), extended, remote, error, length, frame);
  }

  static TraceStep read_content(std::string_view data, bool extended, bool remote, bool error,
                                std::int64_t length, Frame& frame) {
    if (error) {
      // Some interfaces do not give the kind.
      frame.flags = FrameFlags::error;
      frame.id &= ~error_flag;
      if (frame.id == 0) {
        frame = trace_error_frame();
        return read;
      }
    } else {
      frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
    }
    if (!has_valid_id(frame)) return bad_record("the identifier has more bits than there are");
    if (remote && !error) {
      frame.flags = frame.flags | FrameFlags::remote;
      frame.length = static_cast<std::uint8_t>(length);
      return read;
    }
    if (!read_base64(data, frame.data, frame.length) || frame.length != length) {
      return bad_record("the data are no base64 of as many bytes as the length says");
    }
    return read;
  }
};

class SavvyCanParser final : public TraceLineParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::savvycan_csv; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& heard) override {
    if (line.empty()) return trace_note;
    if (line.starts_with(savvycan_header)) {
      has_direction_ = line.find(",Dir,") != std::string_view::npos;
      return trace_note;
    }
    std::int64_t microseconds = 0;
    if (!read_fixed(take_cell(line), 0, microseconds) || microseconds > cell_microseconds_max) {
      return bad_record("the time is no number");
    }
    heard.time = Time{Duration{microseconds}};
    heard.frame = {};
    if (!read_hex(take_cell(line), heard.frame.id)) {
      return bad_record("the identifier is no number");
    }
    bool extended = false;
    if (!read_flag(take_cell(line), extended)) return bad_record("extended is not true or false");
    heard.frame.flags = extended ? FrameFlags::extended : FrameFlags::none;
    if (!has_valid_id(heard.frame))
      return bad_record("the identifier has more bits than there are");
    heard.direction = TraceDirection::unknown;
    if (has_direction_) {
      const std::string_view direction = take_cell(line);
      if (direction == "Rx") heard.direction = TraceDirection::received;
      if (direction == "Tx") heard.direction = TraceDirection::sent;
    }
    std::int64_t bus = 0;
    if (!read_decimal(take_cell(line), bus)) return bad_record("the bus is no number");
    heard.channel = channel_.name(bus + 1);
    if (heard.channel.empty()) return bad_record("the bus is not 0 to 254");
    return read_data(line, heard);
  }

 private:
  static TraceStep read_data(std::string_view line, TraceFrame& heard) {
    Frame& frame = heard.frame;
    std::int64_t length = 0;
    if (!read_decimal(take_cell(line), length)) return bad_record("the length is no number");
    if (length > Frame::length_max) {
      heard.fd = {};
      std::uint32_t byte = 0;
      while (heard.fd.length < std::min<std::int64_t>(length, 64) &&
             read_hex(take_cell(line), byte) && byte <= 0xFF) {
        heard.fd.data.at(heard.fd.length++) = static_cast<std::uint8_t>(byte);
      }
      return {TraceItem::fd, 0, {}};
    }
    for (std::size_t at = 0; at < static_cast<std::size_t>(length); ++at) {
      std::uint32_t byte = 0;
      if (!read_hex(take_cell(line), byte) || byte > 0xFF) {
        return bad_record("there are fewer bytes than the length says, or they are no bytes");
      }
      frame.data.at(at) = static_cast<std::uint8_t>(byte);
    }
    frame.length = static_cast<std::uint8_t>(length);
    return read;
  }

  TraceChannel channel_;
  bool has_direction_ = true;
};

/// Writes like CSVWriter of python-can.
class PythonCanEncoder final : public TraceEncoder {
 public:
  void begin(std::string& bytes) override {
    bytes += python_can_header;
    bytes += '\n';
  }
  void append(std::string& bytes, const TraceFrame& heard, std::string_view) override {
    const Frame& frame = heard.frame;
    TraceLine line;
    time_.put(line, static_cast<std::uint64_t>(time_from(heard, Duration{}).count()));
    line.put(",0x");
    const std::size_t digits_at = line.length();
    line.put_hex(frame.id | (frame.is_error() ? error_flag : 0U), 1);
    line.lower_from(digits_at);
    for (const bool flag : {frame.is_extended(), frame.is_remote(), frame.is_error()}) {
      line.put(flag ? ",1" : ",0");
    }
    line.put(',');
    line.put(static_cast<char>('0' + frame.length));
    line.put(',');
    put_base64(line, frame.payload());
    line.put('\n');
    bytes += line.view();
  }

 private:
  static void put_base64(TraceLine& line, std::span<const std::uint8_t> bytes) {
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
      const std::size_t count = std::min<std::size_t>(bytes.size() - at, 3);
      std::uint32_t bits = 0;
      for (std::size_t byte = 0; byte < 3; ++byte) {
        bits = bits << 8 | (byte < count ? bytes[at + byte] : 0U);
      }
      for (std::size_t digit = 0; digit < 4; ++digit) {
        line.put(digit > count ? '=' : base64_characters[bits >> 6 * (3 - digit) & 0x3F]);
      }
    }
  }

  TraceSeconds time_{{}};
};

std::unique_ptr<TraceParser> recognize_python_can(const TraceHead& head) {
  if (!head.line.starts_with(python_can_header)) return nullptr;
  return std::make_unique<PythonCanParser>();
}

std::unique_ptr<TraceParser> recognize_savvycan(const TraceHead& head) {
  if (!head.line.starts_with(savvycan_header)) return nullptr;
  return std::make_unique<SavvyCanParser>();
}

}  // namespace

constinit const TraceFormat TraceFormat::python_can_csv{
    .name = "python-can CSV",
    .endings = ".csv",
    .lacks =
        trace_lack::direction | trace_lack::bus_names | trace_lack::buses | trace_lack::comments,
    .recognize = recognize_python_can,
    .encoder = [](std::optional<Time>) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<PythonCanEncoder>();
    },
};

constinit const TraceFormat TraceFormat::savvycan_csv{
    .name = "SavvyCAN CSV",
    .endings = ".csv",
    .recognize = recognize_savvycan,
};

}  // namespace canvoy::formats
