#include "canvoy/formats/trace/trace_pcapng_encoder.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/trace/pcapng.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::formats {

namespace {

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

}  // namespace

std::unique_ptr<TraceEncoder> make_pcapng_encoder() {
  return std::make_unique<PcapngEncoder>();
}

}  // namespace canvoy::formats
