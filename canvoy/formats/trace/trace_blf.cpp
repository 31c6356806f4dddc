// Vector BLF: objects in a file, most of them in containers compressed by zlib.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "canvoy/formats/trace/inflater.hpp"
#include "canvoy/formats/trace/trace_blf_encoder.hpp"
#include "canvoy/formats/trace/trace_blf_numbers.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t start_at = 40;  ///< eight numbers of 16 bits
constexpr std::size_t padding_max = 7;
constexpr std::uint64_t microseconds_max = 100'000'000'000'000'000;  // 3,000 years

constexpr FileNumbers numbers{};
constexpr TraceStep short_object = bad_record("the object is shorter than its kind");

std::uint8_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

std::uint32_t size_of(std::string_view object) {
  return numbers.u32(object, 8);
}

BlfKind kind_of(std::string_view object) {
  return BlfKind{numbers.u32(object, 12)};
}

/// Reads year, month, day of the week, day, hour, minute, second, millisecond; nothing if it is no
/// date.
Duration date_of(std::string_view header) {
  const auto number = [&](std::size_t place) { return numbers.u16(header, start_at + 2 * place); };
  const std::chrono::year_month_day date{
      std::chrono::year{number(0)}, std::chrono::month{number(1)}, std::chrono::day{number(3)}};
  if (!date.ok() || number(0) < 1970) return {};
  return std::chrono::sys_days{date}.time_since_epoch() + std::chrono::hours{number(4)} +
         std::chrono::minutes{number(5)} + std::chrono::seconds{number(6)} +
         std::chrono::milliseconds{number(7)};
}

class BlfParser final : public TraceParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::blf; }
  bool has_lines() const override { return false; }
  TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) override;

 private:
  enum class In : std::uint8_t { file_header, file, container };

  TraceStep read_file_header(std::string_view bytes, bool last);
  TraceStep read_outer(std::string_view bytes, bool last, TraceFrame& frame);
  TraceStep read_container(std::string_view bytes, bool last);
  bool read_inner(TraceFrame& frame, TraceStep& step);
  void drop(std::size_t count);
  TraceStep read_object(std::string_view object, TraceFrame& frame);
  TraceStep read_kind(BlfKind kind, std::string_view content, TraceFrame& frame);
  TraceStep read_message(std::string_view content, TraceFrame& frame);
  TraceStep read_error(BlfKind kind, std::string_view content, TraceFrame& frame);
  TraceStep read_fd_message(std::string_view content, TraceFrame& frame);
  TraceStep read_fd_message_64(std::string_view content, TraceFrame& frame);
  bool set_channel(unsigned number, bool sent, TraceFrame& frame);
  static bool set_identifier(std::uint32_t word, bool remote, Frame& frame);
  static TraceStep set_fd_data(TraceFdContent fd, std::string_view data, TraceFrame& frame);
  static TraceStep set_data(unsigned code, std::string_view data, Frame& frame);

  In in_ = In::file_header;
  Duration start_{};
  TraceChannel channel_;
  Inflater inflater_{Inflater::Of::zlib};
  bool is_compressed_ = false;
  bool is_damaged_ = false;       ///< the rest of the container is skipped
  bool has_more_ = false;         ///< of the inflater, for the data given
  std::size_t owed_ = 0;          ///< number of bytes used but not yet taken
  std::uint64_t left_ = 0;        ///< of the container
  std::uint64_t inner_pass_ = 0;  ///< of a long object that is ignored
  std::string inner_;             ///< content of the containers; from done_ on not yet read
  std::size_t done_ = 0;
};

TraceStep BlfParser::step(std::string_view bytes, bool last, TraceFrame& frame) {
  if (in_ == In::file_header) return read_file_header(bytes, last);
  TraceStep step;
  if (read_inner(frame, step)) return step;
  return in_ == In::container ? read_container(bytes, last) : read_outer(bytes, last, frame);
}

TraceStep BlfParser::read_file_header(std::string_view bytes, bool last) {
  if (bytes.size() < blf_header_size) {
    return last ? TraceStep{TraceItem::bad, bytes.size(), "the file ends within its header"}
                : TraceStep{};
  }
  in_ = In::file;
  start_ = date_of(bytes);
  return {TraceItem::note, std::max<std::uint64_t>(numbers.u32(bytes, 4), blf_header_size), {}};
}

TraceStep BlfParser::read_outer(std::string_view bytes, bool last, TraceFrame& frame) {
  const std::size_t at = bytes.find(blf_object_mark);
  if (at == std::string_view::npos) {
    if (!last && bytes.size() < trace_record_max) return {};
    const bool is_padding = last && bytes.size() <= padding_max;
    const TraceItem item = is_padding ? TraceItem::remainder : TraceItem::bad;
    return {item, bytes.size(), "no object begins there"};
  }
  if (at > padding_max) return {TraceItem::bad, at, "no object begins there"};
  if (at > 0) return {TraceItem::remainder, at, {}};
  const TraceStep cut{TraceItem::bad, bytes.size(), "the file ends within an object"};
  if (bytes.size() < blf_container_header_size) return last ? cut : TraceStep{};
  const std::uint64_t size = size_of(bytes);
  if (size < blf_object_header_size)
    return {TraceItem::bad, blf_base_size, "the object has no size"};
  if (kind_of(bytes) == BlfKind::container) {
    is_compressed_ = numbers.u16(bytes, blf_base_size) != 0;
    is_damaged_ = false;
    left_ = size - blf_container_header_size;
    in_ = left_ > 0 ? In::container : In::file;
    inflater_.begin_again();
    return {TraceItem::remainder, blf_container_header_size, {}};
  }
  if (size > trace_record_max) return {TraceItem::note, size, {}};
  if (bytes.size() < size) return last ? cut : TraceStep{};
  TraceStep step = read_object(bytes.substr(0, static_cast<std::size_t>(size)), frame);
  step.taken = size;
  return step;
}

// Reads a piece of the container, as much as fits. Its bytes are taken from the file after their
// content was read, since nothing is requested after the last byte of a file.
TraceStep BlfParser::read_container(std::string_view bytes, bool last) {
  const bool is_cut = last && left_ > bytes.size();
  bytes = bytes.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size())));
  if (owed_ > 0 && !has_more_) {
    const std::size_t taken = std::exchange(owed_, 0);
    left_ -= taken;
    if (left_ == 0) in_ = In::file;
    if (is_cut && taken == bytes.size())
      return {TraceItem::bad, taken, "the file ends within a container"};
    return {TraceItem::remainder, taken, {}};
  }
  if (is_damaged_ || !is_compressed_) {
    if (!is_damaged_) inner_ += bytes;
    owed_ = bytes.size();
    return {TraceItem::remainder, 0, {}};
  }
  const std::size_t before = inner_.size();
  inner_.resize(before + trace_record_max);
  const Inflater::Step step = inflater_.run(bytes.substr(owed_), std::span(inner_).subspan(before));
  inner_.resize(before + step.made);
  const bool is_stuck = owed_ == 0 && step.taken == 0 && step.made == 0;
  const bool goes_on = step.state == Inflater::State::goes_on && !is_stuck;
  has_more_ = goes_on && step.made == trace_record_max;
  is_damaged_ = !goes_on && step.state != Inflater::State::ended;
  owed_ = goes_on ? owed_ + step.taken : bytes.size();
  if (!is_damaged_) return {TraceItem::remainder, 0, {}};
  return bad_record("the compressed data of the container are damaged");
}

void BlfParser::drop(std::size_t count) {
  done_ += count;
  if (done_ < inner_.size() && done_ < trace_record_max) return;
  inner_.erase(0, done_);
  done_ = 0;
}

/// False if no complete object is left in the containers read so far.
bool BlfParser::read_inner(TraceFrame& frame, TraceStep& step) {
  while (true) {
    std::string_view rest = std::string_view(inner_).substr(done_);
    const std::uint64_t passed = std::min<std::uint64_t>(inner_pass_, rest.size());
    inner_pass_ -= passed;
    drop(static_cast<std::size_t>(passed));
    rest = std::string_view(inner_).substr(done_);
    if (rest.size() < blf_object_header_size) return false;
    const std::size_t at = rest.find(blf_object_mark);
    if (at > padding_max) {
      step = {TraceItem::bad, 0, "no object begins there"};
      drop(at == std::string_view::npos ? rest.size() - blf_object_mark.size() + 1 : at);
      return true;
    }
    if (at > 0) {
      drop(at);
      continue;
    }
    const std::uint64_t size = size_of(rest);
    if (size < blf_object_header_size) {
      step = {TraceItem::bad, 0, "the object has no size"};
      drop(blf_base_size);
      return true;
    }
    if (size > trace_record_max) {
      step = trace_note;
      inner_pass_ = size;
      return true;
    }
    if (rest.size() < size) return false;
    step = read_object(rest.substr(0, static_cast<std::size_t>(size)), frame);
    step.taken = 0;
    drop(static_cast<std::size_t>(size));
    return true;
  }
}

TraceStep BlfParser::read_object(std::string_view object, TraceFrame& frame) {
  constexpr std::uint32_t ten_microseconds = 1;
  const std::uint16_t own_size = numbers.u16(object, 4);
  const BlfKind kind = kind_of(object);
  if (own_size < blf_object_header_size || own_size > object.size()) return trace_note;
  const std::uint64_t count = numbers.u64(object, 24);
  const bool is_coarse = numbers.u32(object, blf_base_size) == ten_microseconds;
  const std::uint64_t microseconds = is_coarse ? count * 10 : (count / 100 + 5) / 10;
  if (is_coarse && count > microseconds_max / 10) {
    return bad_record("the time is beyond all");
  }
  frame.time = Time{start_ + Duration{static_cast<std::int64_t>(microseconds)}};
  frame.frame = {};
  return read_kind(kind, object.substr(own_size), frame);
}

TraceStep BlfParser::read_kind(BlfKind kind, std::string_view content, TraceFrame& frame) {
  switch (kind) {
    case BlfKind::message:
    case BlfKind::message_2:
      return read_message(content, frame);
    case BlfKind::error:
    case BlfKind::error_ext:
      return read_error(kind, content, frame);
    case BlfKind::fd_message:
      return read_fd_message(content, frame);
    case BlfKind::fd_message_64:
      return read_fd_message_64(content, frame);
    case BlfKind::container:
      break;
  }
  return trace_note;
}

bool BlfParser::set_channel(unsigned number, bool sent, TraceFrame& frame) {
  frame.channel = channel_.name(number);
  frame.direction = sent ? TraceDirection::sent : TraceDirection::received;
  return !frame.channel.empty();
}

bool BlfParser::set_identifier(std::uint32_t word, bool remote, Frame& frame) {
  const bool is_extended = (word & extended_flag) != 0;
  frame.id = word & ~extended_flag;
  frame.flags = is_extended ? FrameFlags::extended : FrameFlags::none;
  if (remote) frame.flags = frame.flags | FrameFlags::remote;
  return frame.id <= (is_extended ? Frame::extended_id_max : Frame::id_max);
}

TraceStep BlfParser::set_data(unsigned code, std::string_view data, Frame& frame) {
  frame.length = static_cast<std::uint8_t>(std::min<unsigned>(code, Frame::length_max));
  if (frame.is_remote()) return {TraceItem::frame, 0, {}};
  if (data.size() < frame.length) return short_object;
  for (std::size_t at = 0; at < frame.length; ++at) frame.data.at(at) = byte_at(data, at);
  return {TraceItem::frame, 0, {}};
}

/// Takes the existing bytes, up to the length.
TraceStep BlfParser::set_fd_data(TraceFdContent fd, std::string_view data, TraceFrame& frame) {
  fd.length =
      static_cast<std::uint8_t>(std::min<std::size_t>({fd.length, fd.data.size(), data.size()}));
  for (std::size_t at = 0; at < fd.length; ++at) fd.data.at(at) = byte_at(data, at);
  frame.fd = fd;
  return {TraceItem::fd, 0, {}};
}

constexpr TraceStep bad_channel = bad_record("the channel is not 1 to 255");
constexpr TraceStep bad_identifier = bad_record("the identifier has more bits than there are");

// Reads channel, flags, data length code, identifier, data.
TraceStep BlfParser::read_message(std::string_view content, TraceFrame& frame) {
  if (content.size() < 16) return short_object;
  const std::uint8_t flags = byte_at(content, 2);
  if (!set_channel(numbers.u16(content, 0), (flags & blf_sent_bit) != 0, frame)) return bad_channel;
  if (!set_identifier(numbers.u32(content, 4), (flags & blf_remote_bit) != 0, frame.frame)) {
    return bad_identifier;
  }
  return set_data(byte_at(content, 3), content.substr(8, Frame::length_max), frame.frame);
}

// Only the extended object has the register of the controller, after the flags that identify it.
TraceStep BlfParser::read_error(BlfKind kind, std::string_view content, TraceFrame& frame) {
  if (content.size() < (kind == BlfKind::error ? 4U : 32U)) return short_object;
  if (!set_channel(numbers.u16(content, 0), false, frame)) return bad_channel;
  frame.direction = TraceDirection::unknown;
  frame.frame = kind == BlfKind::error
                    ? trace_error_frame()
                    : trace_error_frame(vector_error(numbers.u32(content, 4), byte_at(content, 8)));
  return {TraceItem::frame, 0, {}};
}

TraceStep BlfParser::read_fd_message(std::string_view content, TraceFrame& frame) {
  constexpr std::uint8_t fd_flag = 0x01;
  constexpr std::size_t flags_at = 13;
  if (content.size() < 20) return short_object;
  const std::uint8_t flags = byte_at(content, 2);
  if (!set_channel(numbers.u16(content, 0), (flags & blf_sent_bit) != 0, frame)) return bad_channel;
  if (!set_identifier(numbers.u32(content, 4), (flags & blf_remote_bit) != 0, frame.frame)) {
    return bad_identifier;
  }
  const std::uint8_t fd_flags = byte_at(content, flags_at);
  if ((fd_flags & fd_flag) == 0) {
    return set_data(byte_at(content, 3), content.substr(20), frame.frame);
  }
  return set_fd_data({.flags = static_cast<std::uint8_t>(fd_flags >> 1 & 3U),
                      .length = byte_at(content, flags_at + 1)},
                     content.substr(20), frame);
}

TraceStep BlfParser::read_fd_message_64(std::string_view content, TraceFrame& frame) {
  constexpr std::uint32_t fd_flag = 0x1000;
  constexpr std::uint32_t remote_bit_64 = 0x10;
  if (content.size() < 40) return short_object;
  const std::uint32_t flags = numbers.u32(content, 12);
  if (!set_channel(byte_at(content, 0), byte_at(content, 34) != 0, frame)) return bad_channel;
  if (!set_identifier(numbers.u32(content, 4), (flags & remote_bit_64) != 0, frame.frame)) {
    return bad_identifier;
  }
  if ((flags & fd_flag) == 0) {
    return set_data(byte_at(content, 1), content.substr(40), frame.frame);
  }
  return set_fd_data(
      {.flags = static_cast<std::uint8_t>(flags >> 13 & 3U), .length = byte_at(content, 2)},
      content.substr(40), frame);
}

std::unique_ptr<TraceParser> recognize_blf(const TraceHead& head) {
  if (!head.is_first || !head.rest.starts_with(blf_file_mark)) return nullptr;
  return std::make_unique<BlfParser>();
}

}  // namespace

constinit const TraceFormat TraceFormat::blf{
    .name = "Vector BLF",
    .endings = ".blf",
    .lacks = trace_lack::bus_names | trace_lack::comments | trace_lack::errors,
    .recognize = recognize_blf,
    .encoder = make_blf_encoder,
};

}  // namespace canvoy::formats
