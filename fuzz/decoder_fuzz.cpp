// Any frames, of nodes of all profiles, and of one that a data sheet recognizes: nothing crashes,
// and memory stays bounded.
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"
#include "fuzz/input.hpp"

namespace {

constexpr std::size_t frame_bytes = 11;

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

/// Who knows all that can be known beforehand: it takes long to tell.
canvoy::decoder::Decoder knowing() {
  canvoy::decoder::Decoder decoder;
  decoder.network().add_sheet(sheet());
  canvoy::NodeId node = 100;
  for (const canvoy::Profile* profile : canvoy::all_profiles()) {
    decoder.network().set_profile(node++, *profile);
  }
  return decoder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const canvoy::decoder::Decoder first = knowing();
  canvoy::decoder::Decoder decoder = first;
  for (; size >= frame_bytes; data += frame_bytes, size -= frame_bytes) {
    const std::uint32_t id = (data[0] | std::uint32_t{data[1]} << 8) & 0x7FF;
    canvoy::Frame frame = canvoy::Frame::data_frame(id, std::span(data + 3, 8));
    frame.length = data[2] % 9;
    const canvoy::decoder::Decoded& decoded = decoder.decode(frame);
    for (const canvoy::decoder::DecodedValue& value : decoded.values) {
      if (value.bytes().empty() && value.transferred.data() == nullptr) __builtin_trap();
      if (value.bytes().size() > canvoy::decoder::SdoFollower::bytes_max) __builtin_trap();
    }
  }
  return 0;
}
