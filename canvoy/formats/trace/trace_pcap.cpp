#include "canvoy/formats/trace/trace_pcap.hpp"

#include <cstdint>
#include <memory>
#include <string_view>

#include "canvoy/formats/trace/trace_packet.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t pcap_header_size = 24;
constexpr std::size_t packet_header_size = 16;
constexpr std::size_t link_type_at = 20;
constexpr std::uint32_t link_type_mask = 0x0FFF'FFFF;

class PcapParser final : public TraceParser {
 public:
  PcapParser(bool big_endian, bool nanoseconds)
      : numbers_{big_endian}, fraction_per_us_(nanoseconds ? 1000 : 1) {}

  TraceFormat format() const override { return TraceFormat::pcap; }
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
    TraceStep step = read_can_packet(packet.substr(packet_header_size), frame.frame);
    step.taken = size;
    return step;
  }

  FileNumbers numbers_;
  std::uint32_t fraction_per_us_;
  bool in_packets_ = false;
  bool is_can_ = false;
};

}  // namespace

std::unique_ptr<TraceParser> make_pcap_parser(bool big_endian, bool nanoseconds) {
  return std::make_unique<PcapParser>(big_endian, nanoseconds);
}

}  // namespace canvoy::formats
