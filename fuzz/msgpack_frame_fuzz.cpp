// Arbitrary datagrams: an accepted frame is encoded and decoded unchanged.
#include <cstdint>
#include <cstdlib>

#include "canvoy/can/host/msgpack_frame.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy::host;
  const DecodedFrame decoded = decode_msgpack_frame({data, size});
  if (decoded.kind != FrameKind::classic) return 0;
  const MsgpackFrame encoded(decoded.frame, 0);
  const DecodedFrame again = decode_msgpack_frame(encoded.bytes());
  if (again.kind != FrameKind::classic || again.frame != decoded.frame) std::abort();
  return 0;
}
