// ASAM MDF 4 (.mf4) with CAN frames as its bus logging has them: the reader merges the channel
// groups of a file by time; the writer puts all frames into one data group, so that it can be
// written from front to back.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_mf4_file.hpp"
#include "canvoy/formats/trace/trace_mf4_source.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

// Frames as records of an MDF 4 file, as ASAM's bus logging names them.

/// From there on a double of seconds does not tell microseconds apart any more.
constexpr Duration mf4_time_max{std::int64_t{1} << 52};

/// A channel of a record: all but the time are whole numbers, or bytes.
struct Channel {
  std::string_view name;
  std::uint32_t byte;
  std::uint32_t bits;
};

constexpr std::uint32_t time_size = 8;
constexpr std::array data_channels = {Channel{"BusChannel", 8, 8},  Channel{"ID", 9, 32},
                                      Channel{"IDE", 13, 8},        Channel{"DLC", 14, 8},
                                      Channel{"DataLength", 15, 8}, Channel{"DataBytes", 16, 64},
                                      Channel{"Dir", 24, 8}};
constexpr std::array remote_channels = {Channel{"BusChannel", 8, 8}, Channel{"ID", 9, 32},
                                        Channel{"IDE", 13, 8}, Channel{"DLC", 14, 8},
                                        Channel{"Dir", 15, 8}};

/// A kind of frames, each with records of its own.
struct Kind {
  std::string_view name;
  std::span<const Channel> channels;
  std::uint32_t size;
};

constexpr std::array mf4_kinds = {Kind{"CAN_DataFrame", data_channels, 25},
                                  Kind{"CAN_RemoteFrame", remote_channels, 16},
                                  Kind{"CAN_ErrorFrame", data_channels, 25}};
constexpr std::size_t data_kind = 0;
constexpr std::size_t remote_kind = 1;
constexpr std::size_t error_kind = 2;

/// The blocks before the data. Links are known when a block is begun, so a block stands behind
/// those that it leads to; only the header, which stands in front, is filled in at the end.
class Blocks {
 public:
  static constexpr std::size_t header_size = 104;

  explicit Blocks(std::string& bytes) : bytes_(bytes) {}

  std::uint64_t here() const { return bytes_.size(); }

  std::uint64_t add(std::string_view kind, std::initializer_list<std::uint64_t> links,
                    std::string_view data) {
    bytes_.append((8 - bytes_.size() % 8) % 8, '\0');
    const std::uint64_t at = here();
    bytes_ += "##";
    bytes_ += kind;
    append_little(bytes_, 0, 4);
    append_little(bytes_, mf4_block_head + 8 * links.size() + data.size(), 8);
    append_little(bytes_, links.size(), 8);
    for (const std::uint64_t link : links) append_little(bytes_, link, 8);
    bytes_ += data;
    return at;
  }

  std::uint64_t add_text(std::string_view text, std::string_view kind = "TX") {
    std::string padded(text);
    padded.append(8 - text.size() % 8, '\0');
    return add(kind, {}, padded);
  }

 private:
  std::string& bytes_;
};

class Mf4Encoder final : public TraceEncoder {
 public:
  explicit Mf4Encoder(std::optional<Time> begin) : start_(begin) {}

  void append(std::string& bytes, const TraceFrame& heard, std::string_view) override {
    if (!start_.is_known()) {
      start_.set(heard);
      bytes += head(false);
    }
    const Duration time = time_from(heard, start_.value(), start_.value() + mf4_time_max);
    const Frame& frame = heard.frame;
    const std::size_t kind = frame.is_error()    ? error_kind
                             : frame.is_remote() ? remote_kind
                                                 : data_kind;
    const double seconds = static_cast<double>((time - start_.value()).count()) / 1e6;
    std::array<char, 32> record{};
    char* at = record.data();
    const auto put = [&at](std::uint64_t value, unsigned size) {
      for (unsigned byte = 0; byte < size; ++byte) *at++ = static_cast<char>(value >> 8 * byte);
    };
    put(kind + 1, 1);
    put(std::bit_cast<std::uint64_t>(seconds), time_size);
    put(channels_[heard.channel] - 1, 1);
    put(frame.id, 4);
    put(frame.is_extended() ? 1 : 0, 1);
    put(frame.length, 1);
    if (kind != remote_kind) {
      put(frame.length, 1);
      for (const std::uint8_t byte : frame.data) *at++ = static_cast<char>(byte);
    }
    put(heard.direction == TraceDirection::sent ? 1 : 0, 1);
    bytes.append(record.data(), at);
    ++counts_.at(kind);
    data_size_ += static_cast<std::uint64_t>(at - record.data());
  }

  void end(std::string& bytes) override {
    if (start_.is_known()) return;
    start_.set({});
    bytes += head(false);
  }

  std::string final_header() const override { return head(true); }

 private:
  std::string head(bool is_finished) const;
  std::string file_mark(bool is_finished) const;
  std::string header_of(std::uint64_t group, std::uint64_t history) const;
  std::uint64_t add_history(Blocks& blocks) const;
  static std::uint64_t add_channel(Blocks& blocks, std::uint64_t next, std::uint64_t parts,
                                   std::string_view name, std::string_view data);
  static std::uint64_t add_channels(Blocks& blocks, const Kind& kind);

  TraceStart start_;
  TraceChannelNumbers channels_;
  std::array<std::uint64_t, mf4_kinds.size()> counts_{};
  std::uint64_t data_size_ = 0;
};

std::string Mf4Encoder::file_mark(bool is_finished) const {
  // What is missing: counts of records, and the length of the last block of data.
  constexpr std::uint16_t counts_and_length = 0x01 | 0x04;
  std::string bytes(is_finished ? mf4_mark : mf4_unfinished_mark);
  bytes += "4.10    canvoy  ";
  append_little(bytes, 0, 4);
  append_little(bytes, 410, 2);
  bytes.append(30, '\0');
  append_little(bytes, is_finished ? 0 : counts_and_length, 2);
  append_little(bytes, 0, 2);
  return bytes;
}

// Nanoseconds since 1970, in UTC: both offsets are there, and 0.
std::string Mf4Encoder::header_of(std::uint64_t group, std::uint64_t history) const {
  constexpr std::uint64_t has_offsets = 2;
  std::string bytes;
  Blocks blocks(bytes);
  std::string data;
  append_little(data, static_cast<std::uint64_t>(start_.value().count()) * 1000, 8);
  append_little(data, 0, 4);
  append_little(data, has_offsets, 1);
  data.append(19, '\0');
  blocks.add("HD", {group, history, 0, 0, 0, 0}, data);
  return bytes;
}

std::uint64_t Mf4Encoder::add_history(Blocks& blocks) const {
  const std::uint64_t comment = blocks.add_text(
      "<FHcomment><TX>CAN frames</TX><tool_id>canvoy</tool_id><tool_vendor>canvoy</tool_vendor>"
      "<tool_version>1</tool_version></FHcomment>",
      "MD");
  std::string data;
  append_little(data, static_cast<std::uint64_t>(start_.value().count()) * 1000, 8);
  data.append(8, '\0');
  return blocks.add("FH", {0, comment}, data);
}

std::uint64_t Mf4Encoder::add_channel(Blocks& blocks, std::uint64_t next, std::uint64_t parts,
                                      std::string_view name, std::string_view data) {
  const std::uint64_t text = blocks.add_text(name);
  return blocks.add("CN", {next, parts, text, 0, 0, 0, 0, 0}, data);
}

/// Kind, meaning, type of the data, bit, byte, number of bits, flags; limits, which are not given.
std::string channel_data(std::uint8_t kind, std::uint8_t type, const Channel& channel,
                         std::uint32_t flags) {
  std::string data;
  append_little(data, kind, 1);
  append_little(data, kind == 2 ? 1 : 0, 1);
  append_little(data, type, 1);
  append_little(data, 0, 1);
  append_little(data, channel.byte, 4);
  append_little(data, channel.bits, 4);
  append_little(data, flags, 4);
  data.append(56, '\0');
  return data;
}

std::uint64_t Mf4Encoder::add_channels(Blocks& blocks, const Kind& kind) {
  constexpr std::uint8_t fixed = 0;
  constexpr std::uint8_t master = 2;
  constexpr std::uint8_t whole = 0;
  constexpr std::uint8_t real = 4;
  constexpr std::uint8_t bytes = 10;
  constexpr std::uint32_t bus_event = 1U << 10;
  std::uint64_t next = 0;
  for (std::size_t at = kind.channels.size(); at-- > 0;) {
    const Channel& channel = kind.channels[at];
    const std::string name = std::string(kind.name) + "." + std::string(channel.name);
    const std::uint8_t type = channel.bits > 32 ? bytes : whole;
    next = add_channel(blocks, next, 0, name, channel_data(fixed, type, channel, bus_event));
  }
  const Channel all{"", time_size, 8 * (kind.size - time_size)};
  const std::uint64_t frame =
      add_channel(blocks, 0, next, kind.name, channel_data(fixed, bytes, all, bus_event));
  return add_channel(blocks, frame, 0, "Timestamp",
                     channel_data(master, real, {"", 0, 8 * time_size}, 0));
}

/// All that stands before the first record. It has the same size whenever it is made.
std::string Mf4Encoder::head(bool is_finished) const {
  constexpr std::uint64_t bus_events = 2 | 4;
  constexpr std::uint64_t separator = '.';
  std::string bytes = file_mark(is_finished);
  bytes.append(Blocks::header_size, '\0');
  Blocks blocks(bytes);
  const std::uint64_t history = add_history(blocks);
  const std::uint64_t source_name = blocks.add_text("CAN");
  const std::uint64_t source =
      blocks.add("SI", {source_name, 0, 0}, std::string_view("\2\2\0\0\0\0\0\0", 8));
  std::uint64_t next = 0;
  for (std::size_t kind = mf4_kinds.size(); kind-- > 0;) {
    const std::uint64_t channels = add_channels(blocks, mf4_kinds.at(kind));
    std::string data;
    append_little(data, kind + 1, 8);
    append_little(data, is_finished ? counts_.at(kind) : 0, 8);
    append_little(data, bus_events, 2);
    append_little(data, separator, 2);
    append_little(data, 0, 4);
    append_little(data, mf4_kinds.at(kind).size, 4);
    append_little(data, 0, 4);
    next = blocks.add("CG", {next, channels, source_name, source, 0, 0}, data);
  }
  constexpr std::uint64_t data_group_size = mf4_block_head + 4 * 8 + 8;
  const std::uint64_t group_at = blocks.here() + (8 - blocks.here() % 8) % 8;
  const std::uint64_t group = blocks.add("DG", {0, next, group_at + data_group_size, 0},
                                         std::string_view("\1\0\0\0\0\0\0\0", 8));
  blocks.add("DT", {}, {});
  // The length of the data.
  std::string length;
  append_little(length, mf4_block_head + (is_finished ? data_size_ : 0), 8);
  bytes.replace(bytes.size() - 16, 8, length);
  bytes.replace(mf4_header_at, Blocks::header_size, header_of(group, history));
  return bytes;
}

/// `begin`: the time of the earliest frame, where it is not the first.
std::unique_ptr<TraceEncoder> make_mf4_encoder(std::optional<Time> begin) {
  return std::make_unique<Mf4Encoder>(begin);
}

class Mf4Parser final : public TraceFileParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::mf4; }
  host::Result<void> open(TraceFile file, const std::string& name) override;
  TraceStep read(TraceFrame& frame) override;
  std::string where() const override { return "byte " + std::to_string(position_); }
  std::uint64_t position() const override { return progress_; }

 private:
  /// A data group, and its next frame.
  struct Merged {
    std::unique_ptr<Mf4Source> source;
    Mf4Frame head = {};
    bool has_head = false;
    bool is_over = false;
  };

  host::Result<void> find_frames(const std::string& name);
  Merged* earliest(TraceStep& step);

  std::optional<Mf4File> file_;
  Mf4Start start_;
  std::vector<Merged> merged_;
  TraceChannel channel_;
  std::uint64_t position_ = 0;
  std::uint64_t progress_ = 0;
};

host::Result<void> Mf4Parser::open(TraceFile file, const std::string& name) {
  std::array<char, mf4_header_at> head{};
  file.read(0, head);
  const std::string_view text(head.data(), head.size());
  file_.emplace(std::move(file));
  const std::string_view version = text.substr(8, 4);
  if (version[0] != '4') {
    return host::Error{name, "it is an MDF file of version " + plain_text(version),
                       "version 4 is read: save it as .mf4 with the tool that made it"};
  }
  const std::string_view program = text.substr(16, 8);
  start_.is_finished = text.starts_with(mf4_mark);
  start_.has_socketcan_errors = program.starts_with("canvoy") || program.starts_with("amdf");
  return find_frames(name);
}

host::Result<void> Mf4Parser::find_frames(const std::string& name) {
  constexpr std::size_t merged_max = 256;
  const std::optional<Mf4Block> header = file_->block(mf4_header_at, "HD");
  if (!header) return host::Error{name, "the MDF file ends within its header", ""};
  start_.time = Duration{static_cast<std::int64_t>(file_->number(*header, 0, 8) / 1000)};
  std::size_t groups = 0;
  std::uint64_t link = file_->link(*header, 0);
  while (const std::optional<Mf4Block> block = file_->block(link, "DG")) {
    auto source = std::make_unique<Mf4Source>(*file_, *block, start_);
    groups += source->groups();
    if (source->has_frames()) merged_.push_back({std::move(source)});
    if (merged_.size() > merged_max) {
      return host::Error{name, "its frames are in more than 256 data groups",
                         "let the tool that made it write them into few"};
    }
    link = file_->link(*block, 0);
  }
  if (!merged_.empty()) return {};
  return host::Error{name,
                     "the MDF file has no CAN frames (CAN_DataFrame), but " +
                         std::to_string(groups) + " groups of other signals",
                     "record the bus itself, not signals of it"};
}

/// The group whose next frame is the earliest; null where `step` is to be told before, or at the
/// end.
Mf4Parser::Merged* Mf4Parser::earliest(TraceStep& step) {
  Merged* first = nullptr;
  for (Merged& each : merged_) {
    if (!each.has_head && !each.is_over) {
      step = each.source->next(each.head);
      position_ = each.source->position();
      progress_ = std::max(progress_, position_);
      if (step.item == TraceItem::bad) return nullptr;
      each.is_over = step.item == TraceItem::end;
      each.has_head = !each.is_over;
    }
    const bool is_earlier =
        each.has_head && (first == nullptr || each.head.frame.time < first->head.frame.time);
    if (is_earlier) first = &each;
  }
  step = {TraceItem::end, 0, {}};
  return first;
}

TraceStep Mf4Parser::read(TraceFrame& frame) {
  TraceStep step;
  Merged* const first = earliest(step);
  if (first == nullptr) return step;
  frame = first->head.frame;
  frame.channel = channel_.name(first->head.bus + 1);
  first->has_head = false;
  return {first->head.item, 0, {}};
}

std::unique_ptr<TraceParser> recognize_mf4(const TraceHead& head) {
  const bool is_mf4 = head.rest.starts_with(mf4_mark) || head.rest.starts_with(mf4_unfinished_mark);
  if (!head.is_first || !is_mf4 || head.rest.size() < mf4_header_at) return nullptr;
  return std::make_unique<Mf4Parser>();
}

}  // namespace

constinit const TraceFormat TraceFormat::mf4{
    .name = "ASAM MDF 4",
    .endings = ".mf4 .mdf",
    .lacks = trace_lack::bus_names | trace_lack::comments,
    .recognize = recognize_mf4,
    .encoder = make_mf4_encoder,
};

}  // namespace canvoy::formats
