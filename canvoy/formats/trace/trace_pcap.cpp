// pcap of one CAN interface (link type 227): microseconds or nanoseconds, either byte order.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace_encoder.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_parser.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t pcap_header_size = 24;
constexpr std::size_t packet_header_size = 16;
constexpr std::size_t link_type_at = 20;
/// Seconds have 32 bits.
constexpr Duration time_max = std::chrono::seconds{0xFFFF'FFFF} + Duration{999'999};
constexpr std::uint32_t link_type_mask = 0x0FFF'FFFF;

class PcapParser final : public TraceParser {
 public:
  PcapParser(bool big_endian, bool nanoseconds)
      : numbers_{big_endian}, fraction_per_us_(nanoseconds ? 1000 : 1) {}

  const TraceFormat& format() const override { return TraceFormat::pcap; }
  bool has_lines() const override { return false; }

  TraceStep step(std::string_view bytes, bool last, TraceFrame& frame) override {
    const std::size_t header = in_packets_ ? packet_header_size : pcap_header_size;
    if (bytes.size() < header) return want(bytes, last);
    if (in_packets_) return read_packet(bytes, last, frame);
    in_packets_ = true;
    is_can_ = (numbers_.u32(bytes, link_type_at) & link_type_mask) == link_type_can;
    return {TraceItem::note, pcap_header_size, {}};
  }

 private:
  static TraceStep want(std::string_view bytes, bool last) {
    if (!last) return {};
    return {TraceItem::bad, bytes.size(), "the file ends within a packet"};
  }

  TraceStep read_packet(std::string_view bytes, bool last, TraceFrame& frame) const {
    const std::uint64_t size = packet_header_size + std::uint64_t{numbers_.u32(bytes, 8)};
    if (size > trace_record_max) return {TraceItem::bad, size, "the packet is no CAN frame"};
    if (bytes.size() < size) return want(bytes, last);
    if (!is_can_) return {TraceItem::note, size, {}};
    const std::uint32_t fraction = numbers_.u32(bytes, 4) / fraction_per_us_;
    frame.time = Time{std::chrono::seconds{numbers_.u32(bytes, 0)} + Duration{fraction}};
    frame.channel = "can0";
    frame.direction = TraceDirection::unknown;
    const std::string_view packet = bytes.substr(0, static_cast<std::size_t>(size));
    TraceStep step = read_can_packet(packet.substr(packet_header_size), frame);
    step.taken = size;
    return step;
  }

  FileNumbers numbers_;
  std::uint32_t fraction_per_us_;
  bool in_packets_ = false;
  bool is_can_ = false;
};

std::unique_ptr<TraceParser> recognize_pcap(const TraceHead& head) {
  const auto begins = [&head](std::string_view magic) {
    return head.is_first && head.rest.starts_with(magic);
  };
  if (begins("\xD4\xC3\xB2\xA1")) return std::make_unique<PcapParser>(false, false);
  if (begins("\xA1\xB2\xC3\xD4")) return std::make_unique<PcapParser>(true, false);
  if (begins("\x4D\x3C\xB2\xA1")) return std::make_unique<PcapParser>(false, true);
  if (begins("\xA1\xB2\x3C\x4D")) return std::make_unique<PcapParser>(true, true);
  return nullptr;
}

class PcapEncoder final : public TraceEncoder {
 public:
  void begin(std::string& bytes) override {
    append_little(bytes, 0xA1B2C3D4, 4);
    append_little(bytes, 2, 2);  // version 2.4
    append_little(bytes, 4, 2);
    append_little(bytes, 0, 8);
    append_little(bytes, packet_max, 4);
    append_little(bytes, link_type_can, 4);
  }
  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    const auto time = static_cast<std::uint64_t>(time_from(frame, Duration{}, time_max).count());
    packet_.clear();
    append_can_packet(packet_, frame.frame);
    append_little(bytes, time / 1'000'000, 4);
    append_little(bytes, time % 1'000'000, 4);
    append_little(bytes, packet_.size(), 4);
    append_little(bytes, packet_.size(), 4);
    bytes += packet_;
  }

 private:
  static constexpr std::uint32_t packet_max = 65'535;

  std::string packet_;
};

}  // namespace

constinit const TraceFormat TraceFormat::pcap{
    .name = "pcap",
    .endings = ".pcap .cap",
    .lacks =
        trace_lack::direction | trace_lack::bus_names | trace_lack::buses | trace_lack::comments,
    .recognize = recognize_pcap,
    .encoder = [](std::optional<Time>) -> std::unique_ptr<TraceEncoder> {
      return std::make_unique<PcapEncoder>();
    },
};

}  // namespace canvoy::formats
