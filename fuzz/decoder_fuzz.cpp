// Any frames of several buses, of nodes of all profiles, and of a node recognized by a data sheet:
// nothing crashes, memory stays bounded, and the meaning of a frame is the same as with its bus
// alone.
#include <algorithm>
#include <memory>
#include <string>

#include "canvoy/decoder/bus_table.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"
#include "fuzz/input.hpp"

namespace {

using canvoy::decoder::Decoded;
using canvoy::decoder::DecodedValue;
using canvoy::decoder::Decoder;

constexpr std::size_t frame_bytes = 11;
constexpr std::size_t buses_max = 3;  // of four buses: some are dropped

const canvoy::decoder::DeviceSheet& sheet() {
  static const auto made = [] {
    canvoy::decoder::DeviceSheet sheet{.profile = &canvoy::base_profile()};
    sheet.identity.set(canvoy::LssAddress::vendor, 0x2F0);
    sheet.identity.set(canvoy::LssAddress::product, 0x1A3);
    sheet.parameters = {{0x1800, 1, 0x180, true}, {0x1A00, 1, 0x10010008}, {0x1A00, 0, 1}};
    return sheet;
  }();
  return made;
}

/// Has all knowledge that can be given in advance, which takes long to set up.
Decoder knowing() {
  Decoder decoder;
  decoder.network().add_sheet(sheet());
  canvoy::NodeId node = 100;
  for (const canvoy::Profile* profile : canvoy::all_profiles()) {
    decoder.network().set_profile(node++, *profile);
  }
  return decoder;
}

const Decoder& first() {
  static const Decoder made = knowing();
  return made;
}

bool is_same(const DecodedValue& a, const DecodedValue& b) {
  return a.index == b.index && a.sub == b.sub && a.entry == b.entry && a.profile == b.profile &&
         std::ranges::equal(a.bytes(), b.bytes());
}

void check(const Decoded& decoded) {
  for (const DecodedValue& value : decoded.values) {
    if (value.bytes().empty() && value.transferred.data() == nullptr) __builtin_trap();
    if (value.bytes().size() > canvoy::decoder::SdoFollower::bytes_max) __builtin_trap();
  }
}

void check_same(const Decoded& decoded, const Decoded& alone) {
  const bool is_same_frame = decoded.service == alone.service && decoded.node == alone.node &&
                             decoded.client == alone.client && decoded.message == alone.message &&
                             (decoded.transfer == nullptr) == (alone.transfer == nullptr) &&
                             std::ranges::equal(decoded.values, alone.values, is_same);
  if (!is_same_frame) __builtin_trap();
  for (const canvoy::decoder::Mark mark : canvoy::decoder::all_marks) {
    if (decoded.marks.has(mark) != alone.marks.has(mark)) __builtin_trap();
  }
}

/// All buses, and one of them alone, which only notes when it was dropped.
class Buses {
 public:
  void take(const std::string& bus, const canvoy::Frame& frame) {
    const auto make = [&] {
      if (bus == watched_) alone_ = std::make_unique<Decoder>(first());
      return std::make_unique<Decoder>(first());
    };
    const Decoded& decoded = table_.at(bus, make).decode(frame);
    check(decoded);
    if (bus == watched_) check_same(decoded, alone_->decode(frame));
  }

 private:
  const std::string watched_ = "can0";
  std::unique_ptr<Decoder> alone_;
  canvoy::decoder::BusTable<Decoder> table_{buses_max};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Buses buses;
  for (; size >= frame_bytes; data += frame_bytes, size -= frame_bytes) {
    const std::uint32_t id = (data[0] | std::uint32_t{data[1]} << 8) & 0x7FF;
    canvoy::Frame frame = canvoy::Frame::data_frame(id, std::span(data + 3, 8));
    frame.length = data[2] % 9;
    // Most inputs have one bus, like those found before.
    const unsigned bus = data[1] >> 3 & 3U;
    buses.take("can" + std::to_string(bus), frame);
  }
  return 0;
}
