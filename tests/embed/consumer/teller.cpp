// Ends with 0 if the library tells a frame in words.
#include <iostream>

#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/version.hpp"

#if CANVOY_VERSION_MAJOR != 0 || CANVOY_VERSION < 100
#error "the version's macros are those of another library"
#endif

int main() {
  canvoy::text::FrameDecoder decoder;
  // CiA 301, 7.2.8.3.1: command 128 for all nodes.
  const auto& words = decoder.decode(canvoy::Frame::data_frame(0x000, {0x80, 0}));
  std::cout << words.service << ": " << words.text << '\n';
  return words.service == "NMT" ? 0 : 1;
}
