// Any frames, of nodes of all profiles: nothing crashes, and memory stays bounded.
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"
#include "fuzz/input.hpp"

namespace {

constexpr std::size_t frame_bytes = 11;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::decoder::Decoder decoder;
  canvoy::NodeId node = 1;
  for (const canvoy::Profile* profile : canvoy::all_profiles()) {
    decoder.network().set_profile(node++, *profile);
  }
  for (; size >= frame_bytes; data += frame_bytes, size -= frame_bytes) {
    const std::uint32_t id = (data[0] | std::uint32_t{data[1]} << 8) & 0x7FF;
    canvoy::Frame frame = canvoy::Frame::data_frame(id, std::span(data + 3, 8));
    frame.length = data[2] % 9;
    const canvoy::decoder::Decoded& decoded = decoder.decode(frame);
    for (const canvoy::decoder::DecodedValue& value : decoded.values) {
      if (value.bytes().size() > canvoy::decoder::SdoFollower::bytes_max) __builtin_trap();
    }
  }
  return 0;
}
