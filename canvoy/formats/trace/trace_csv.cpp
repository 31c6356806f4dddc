#include "canvoy/formats/trace/trace_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
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
    const auto [last, error] = std::from_chars(cell.data(), end, seconds);
    if (error != std::errc{} || last != end || !(seconds >= 0 && seconds < 1e12)) return false;
    microseconds = static_cast<std::int64_t>(seconds * 1e6 + 0.5);
  }
  time = Time{Duration{microseconds}};
  return microseconds <= cell_microseconds_max;
}

unsigned base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a') + 26;
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0') + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : 64;
}

/// Into the frame's data and length; false where it is no base64 of 0 to 8 bytes.
bool read_base64(std::string_view text, Frame& frame) {
  while (text.ends_with('=')) text.remove_suffix(1);
  unsigned bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    const unsigned digit = base64_digit(c);
    if (digit > 63) return false;
    bits = (bits << 6 | digit) & 0xFFFF;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    if (frame.length == Frame::length_max) return false;
    frame.data.at(frame.length++) = static_cast<std::uint8_t>(bits >> count);
  }
  return count < 6;
}

bool has_valid_id(const Frame& frame) {
  return frame.id <=
         (frame.is_extended() || frame.is_error() ? Frame::extended_id_max : Frame::id_max);
}

class PythonCanParser final : public TraceLineParser {
 public:
  TraceFormat format() const override { return TraceFormat::python_can_csv; }

 protected:
  TraceStep read_line(std::string_view line, TraceFrame& heard) override {
    if (line.empty() || line.starts_with(python_can_header)) return trace_note;
    if (!read_seconds(take_cell(line), heard.time)) return bad_record("the time is no number");
    heard.channel = "can0";
    heard.direction = TraceDirection::unknown;
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
    if (length > Frame::length_max) return {TraceItem::fd, 0, {}};
    return read_content(take_cell(line), extended, remote, error, length, frame);
  }

 private:
  static TraceStep read_content(std::string_view data, bool extended, bool remote, bool error,
                                std::int64_t length, Frame& frame) {
    if (error) {
      // Some interfaces leave out what kind it is.
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
    if (!read_base64(data, frame) || frame.length != length) {
      return bad_record("the data are no base64 of as many bytes as the length says");
    }
    return read;
  }
};

class SavvyCanParser final : public TraceLineParser {
 public:
  TraceFormat format() const override { return TraceFormat::savvycan_csv; }

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
    return read_data(line, heard.frame);
  }

 private:
  static TraceStep read_data(std::string_view line, Frame& frame) {
    std::int64_t length = 0;
    if (!read_decimal(take_cell(line), length)) return bad_record("the length is no number");
    if (length > Frame::length_max) return {TraceItem::fd, 0, {}};
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

}  // namespace

std::unique_ptr<TraceParser> make_csv_parser(std::string_view header) {
  if (header.starts_with(python_can_header)) return std::make_unique<PythonCanParser>();
  if (header.starts_with(savvycan_header)) return std::make_unique<SavvyCanParser>();
  return nullptr;
}

}  // namespace canvoy::formats
