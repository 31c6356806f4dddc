// pcapng (draft-ietf-opsawg-pcapng) of CAN interfaces, as written by tshark and Wireshark.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::formats {

namespace {

// Numbers of the pcapng format (draft-ietf-opsawg-pcapng), for its reader and its writer.

inline constexpr std::uint32_t section_block = 0x0A0D0D0A;  ///< a file begins with it

inline constexpr std::uint32_t interface_block = 1;  ///< a bus

inline constexpr std::uint32_t packet_block = 6;  ///< a frame, with its time

inline constexpr std::uint16_t option_name = 2;  ///< of an interface

inline constexpr std::uint16_t option_flags = 2;  ///< of a packet

// Writes frames as packets of pcapng, little-endian, in microseconds; a channel is an interface,
// described before its first frame.

constexpr std::uint16_t option_comment = 1;
constexpr std::uint16_t option_application = 4;
constexpr std::size_t channels_max = 255;  // further ones share one interface

void pad(std::string& bytes) {
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
}

void append_option(std::string& bytes, std::uint16_t code, std::string_view value) {
  append_little(bytes, code, 2);
  append_little(bytes, value.size(), 2);
  bytes += value;
  pad(bytes);
}

void append_block(std::string& bytes, std::uint32_t type, std::string_view body) {
  const std::size_t size = body.size() + 12;
  append_little(bytes, type, 4);
  append_little(bytes, size, 4);
  bytes += body;
  append_little(bytes, size, 4);
}

// Cut at the boundary of a UTF-8 character.
std::string_view cut(std::string_view comment) {
  if (comment.size() <= TraceWriter::comment_length_max) return comment;
  std::size_t length = TraceWriter::comment_length_max;
  while (length > 0 && (static_cast<unsigned char>(comment[length]) & 0xC0U) == 0x80U) --length;
  return comment.substr(0, length);
}

class PcapngEncoder final : public TraceEncoder {
 public:
  void begin(std::string& bytes) override {
    body_.clear();
    append_little(body_, 0x1A2B3C4D, 4);
    append_little(body_, 1, 2);
    append_little(body_, 0, 2);
    append_little(body_, ~std::uint64_t{0}, 8);  // the length of the section is unknown
    append_option(body_, option_application, "canvoy");
    append_little(body_, 0, 4);
    append_block(bytes, section_block, body_);
  }

  void append(std::string& bytes, const TraceFrame& frame, std::string_view comment) override {
    const std::size_t interface = interface_of(frame.channel, bytes);
    const auto time = static_cast<std::uint64_t>(time_from(frame, Duration{}).count());
    packet_.clear();
    append_can_packet(packet_, frame.frame);
    body_.clear();
    append_little(body_, interface, 4);
    append_little(body_, time >> 32, 4);
    append_little(body_, time, 4);
    append_little(body_, packet_.size(), 4);
    append_little(body_, packet_.size(), 4);
    body_ += packet_;
    pad(body_);
    append_options(frame, comment);
    append_block(bytes, packet_block, body_);
  }

 private:
  void append_options(const TraceFrame& frame, std::string_view comment) {
    const bool directed = frame.direction != TraceDirection::unknown;
    if (!comment.empty()) append_option(body_, option_comment, cut(comment));
    if (directed) {
      append_little(body_, option_flags, 2);
      append_little(body_, 4, 2);
      append_little(body_, frame.direction == TraceDirection::received ? 1 : 2, 4);
    }
    if (directed || !comment.empty()) append_little(body_, 0, 4);
  }

  std::size_t interface_of(std::string_view channel, std::string& bytes) {
    if (channel.empty()) channel = "can0";
    const auto known = std::ranges::find(channels_, channel);
    if (known != channels_.end()) return static_cast<std::size_t>(known - channels_.begin());
    if (channels_.size() > channels_max) return channels_max;
    channels_.emplace_back(channels_.size() == channels_max ? "others" : channel.substr(0, 256));
    body_.clear();
    append_little(body_, link_type_can, 2);
    append_little(body_, 0, 2);
    append_little(body_, 0, 4);  // packets of any length
    append_option(body_, option_name, channels_.back());
    append_little(body_, 0, 4);
    append_block(bytes, interface_block, body_);
    return channels_.size() - 1;
  }

  std::vector<std::string> channels_;
  std::string body_;
  std::string packet_;
};

/// Makes an encoder.
std::unique_ptr<TraceEncoder> make_pcapng_encoder() {
  return std::make_unique<PcapngEncoder>();
}

constexpr std::uint32_t byte_order_magic = 0x1A2B3C4D;
constexpr std::uint16_t option_resolution = 9;
constexpr std::uint16_t option_offset = 14;
constexpr std::size_t block_size_min = 12;
constexpr std::size_t section_size_min = 28;
constexpr std::size_t interface_options_at = 16;
constexpr std::size_t packet_at = 28;
constexpr std::size_t interfaces_max = 256;
constexpr std::uint64_t whole_rest = std::numeric_limits<std::uint64_t>::max();
constexpr std::int64_t seconds_max = 1'000'000'000'000;

struct Interface {
  bool is_can = false;
  std::string name;
  std::uint8_t resolution = 6;  // number of decimal digits; with bit 7, of binary ones
  std::int64_t offset_seconds = 0;
};

// Converts the ticks of a time stamp to whole seconds and microseconds, without a number above 64
// bits.
bool read_ticks(std::uint64_t ticks, std::uint8_t resolution, Duration& time) {
  std::uint64_t seconds = 0;
  std::uint64_t fraction = 0;
  unsigned digits = resolution & 0x7FU;
  if ((resolution & 0x80U) != 0) {
    if (digits > 63) return false;
    seconds = ticks >> digits;
    fraction = ticks - (seconds << digits);
    for (; digits > 43; --digits) fraction >>= 1;
    fraction = fraction * 1'000'000 >> digits;
  } else {
    if (digits > 19) return false;
    std::uint64_t per_second = 1;
    for (unsigned digit = 0; digit < digits; ++digit) per_second *= 10;
    seconds = ticks / per_second;
    fraction = ticks % per_second;
    for (; digits > 6; --digits) fraction /= 10;
    for (; digits < 6; ++digits) fraction *= 10;
  }
  if (seconds > static_cast<std::uint64_t>(seconds_max)) return false;
  time = std::chrono::seconds{seconds} + Duration{fraction};
  return true;
}

class PcapngParser final : public TraceParser {
 public:
  const TraceFormat& format() const override { return TraceFormat::pcapng; }
  bool has_lines() const override { return false; }
  TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) override;

 private:
  TraceStep read_block(std::string_view block, TraceFrame& frame);
  TraceStep read_interface(std::string_view block);
  void make_name_unique(std::string& name) const;
  TraceStep read_packet(std::string_view block, TraceFrame& frame) const;
  template <class Use>
  void for_each_option(std::string_view options, const Use& use) const;

  FileNumbers numbers_;
  std::vector<Interface> interfaces_;
};

// After an impossible length, the next block cannot be found.
TraceStep PcapngParser::step(std::string_view bytes, bool last, TraceFrame& frame) {
  if (bytes.size() < block_size_min) {
    if (!last) return {};
    return {TraceItem::bad, bytes.size(), "the file ends within a block"};
  }
  if (numbers_.u32(bytes, 0) == section_block) {
    interfaces_.clear();
    numbers_.big_endian = FileNumbers{true}.u32(bytes, 8) == byte_order_magic;
    if (numbers_.u32(bytes, 8) != byte_order_magic)
      return {TraceItem::bad, whole_rest, "the section has no byte order; its rest is not read"};
  }
  const std::uint64_t size = numbers_.u32(bytes, 4);
  if (size < block_size_min || size % 4 != 0)
    return {TraceItem::bad, whole_rest, "the block has an impossible length; the rest is not read"};
  if (size > trace_record_max) {
    const bool packet = numbers_.u32(bytes, 0) == packet_block;
    return {packet ? TraceItem::bad : TraceItem::note, size, "the packet is no CAN frame"};
  }
  if (bytes.size() < size) {
    if (!last) return {};
    return {TraceItem::bad, bytes.size(), "the file ends within a block"};
  }
  TraceStep step = read_block(bytes.substr(0, static_cast<std::size_t>(size)), frame);
  step.taken = size;
  return step;
}

TraceStep PcapngParser::read_block(std::string_view block, TraceFrame& frame) {
  if (numbers_.u32(block, block.size() - 4) != block.size())
    return bad_record("the lengths at both ends of the block differ");
  const std::uint32_t type = numbers_.u32(block, 0);
  if (type == section_block && block.size() < section_size_min)
    return bad_record("the section's header is too short");
  if (type == interface_block) return read_interface(block);
  if (type == packet_block) return read_packet(block, frame);
  return trace_note;
}

template <class Use>
void PcapngParser::for_each_option(std::string_view options, const Use& use) const {
  while (options.size() >= 4) {
    const std::uint16_t code = numbers_.u16(options, 0);
    const std::size_t length = numbers_.u16(options, 2);
    const std::size_t padded = 4 + (length + 3) / 4 * 4;
    if (code == 0 || padded > options.size()) return;
    use(code, options.substr(4, length));
    options.remove_prefix(padded);
  }
}

TraceStep PcapngParser::read_interface(std::string_view block) {
  if (block.size() < interface_options_at + 4) return bad_record("the interface is too short");
  if (interfaces_.size() == interfaces_max) return bad_record("there are more than 256 interfaces");
  Interface made;
  made.is_can = numbers_.u16(block, 8) == link_type_can;
  made.name = "can" + std::to_string(interfaces_.size());
  const std::string_view options =
      block.substr(interface_options_at, block.size() - interface_options_at - 4);
  for_each_option(options, [&](std::uint16_t code, std::string_view value) {
    if (code == option_name && !value.empty()) made.name = value.substr(0, value.find('\0'));
    if (code == option_resolution && value.size() == 1)
      made.resolution = static_cast<std::uint8_t>(value[0]);
    if (code == option_offset && value.size() == 8)
      made.offset_seconds = static_cast<std::int64_t>(numbers_.u64(value, 0));
  });
  if (made.offset_seconds > seconds_max || made.offset_seconds < -seconds_max)
    made.offset_seconds = 0;
  make_name_unique(made.name);
  interfaces_.push_back(std::move(made));
  return trace_note;
}

// In merged captures of several machines, two buses may have the same name: they stay separate.
void PcapngParser::make_name_unique(std::string& name) const {
  const auto is_taken = [this](const std::string& wanted) {
    return std::ranges::find(interfaces_, wanted, &Interface::name) != interfaces_.end();
  };
  const std::string wanted = name;
  for (unsigned number = 2; is_taken(name); ++number) {
    name = wanted + "_" + std::to_string(number);
  }
}

TraceStep PcapngParser::read_packet(std::string_view block, TraceFrame& frame) const {
  if (block.size() < packet_at + 4) return bad_record("the packet's block is too short");
  const std::uint32_t number = numbers_.u32(block, 8);
  if (number >= interfaces_.size()) return bad_record("the packet is of no interface");
  const Interface& interface = interfaces_[number];
  if (!interface.is_can) return trace_note;
  const std::uint64_t size = numbers_.u32(block, 20);
  const std::string_view body = block.substr(packet_at, block.size() - packet_at - 4);
  if (size > body.size()) return bad_record("the packet is larger than its block");
  const std::uint64_t ticks =
      std::uint64_t{numbers_.u32(block, 12)} << 32 | numbers_.u32(block, 16);
  Duration time{};
  if (!read_ticks(ticks, interface.resolution, time)) return bad_record("the time is out of range");
  frame.time = Time{time + std::chrono::seconds{interface.offset_seconds}};
  frame.channel = interface.name;
  frame.direction = TraceDirection::unknown;
  const auto packet_size = static_cast<std::size_t>(size);
  const std::size_t padded = (packet_size + 3) / 4 * 4;
  for_each_option(body.substr(std::min(padded, body.size())),
                  [&](std::uint16_t code, std::string_view value) {
                    if (code != option_flags || value.size() != 4) return;
                    const std::uint32_t way = numbers_.u32(value, 0) & 3U;
                    if (way == 1) frame.direction = TraceDirection::received;
                    if (way == 2) frame.direction = TraceDirection::sent;
                  });
  return read_can_packet(body.substr(0, packet_size), frame);
}

std::unique_ptr<TraceParser> recognize_pcapng(const TraceHead& head) {
  if (!head.is_first || !head.rest.starts_with("\x0A\x0D\x0D\x0A")) return nullptr;
  return std::make_unique<PcapngParser>();
}

}  // namespace

constinit const TraceFormat TraceFormat::pcapng{
    .name = "pcapng",
    .endings = ".pcapng .ntar",
    .lacks = 0,
    .recognize = recognize_pcapng,
    .encoder = [](std::optional<Time>) { return make_pcapng_encoder(); },
};

}  // namespace canvoy::formats
