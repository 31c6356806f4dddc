// Arbitrary text as a frame: an accepted frame is written and read back unchanged.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "canvoy/can/frame_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const canvoy::ParsedFrame parsed =
      canvoy::parse_frame({reinterpret_cast<const char*>(data), size});
  if (!parsed) {
    if (parsed.frame != canvoy::Frame{} || describe(parsed.error).empty()) std::abort();
    return 0;
  }
  if (canvoy::parse_frame(canvoy::FrameText(parsed.frame).view()).frame != parsed.frame)
    std::abort();
  return 0;
}
