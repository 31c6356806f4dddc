// Arbitrary text as a filter: it is refused with one line, or can be applied to each frame.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/filter/filter.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  static const tools::FilterNames names;
  tools::Filter filter;
  try {
    filter.add({reinterpret_cast<const char*>(data), size}, names);
  } catch (const tools::UsageError& error) {
    if (std::string_view(error.what()).empty() || !filter.empty()) std::abort();
    return 0;
  }
  static const decoder::Network network = [] {
    decoder::Network made;
    NodeId node = 1;
    for (const Profile* profile : all_profiles()) made.set_profile(node++, *profile);
    return made;
  }();
  text::FrameDecoder decoder;
  decoder.network() = network;
  Duration time{};
  for (const char* text :
       {"187#A00001", "201#0102030405060708", "600#", "585#43001000A2010000", "706#05", "000#0100",
        "20000088#0000190000000000", "00000187#01", "581#4F08100041000000", "080#",
        "586#4B00610101020000", "18A#0102030405060708"}) {
    const Frame frame = parse_frame(text).frame;
    filter.passes({time, time, "can0", frame, decoder.decode(frame)});
    time += 1s;
  }
  if (filter.passed() == 0 && filter.never_true().size() > 64) std::abort();
  return 0;
}
