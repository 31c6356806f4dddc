// Writes random frames as SocketCAN has them in memory, and beside it their length in bits as
// Canvoy has it.
//
//     write_frames 5000 frames.bin bits.txt
//
// Remote frames ask for no bytes: canbusload 2020.11 counts the data that a remote frame does not
// carry.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/random.hpp"

namespace {

using canvoy::Frame;
using canvoy::FrameFlags;
using canvoy::Random;

/// Long runs of equal bits are where stuffing goes wrong, so half of the bytes are all zeros, all
/// ones, or nearly.
std::uint8_t random_byte(Random& random) {
  constexpr std::array<std::uint8_t, 8> runs{0x00, 0xFF, 0x0F, 0xF0, 0x1F, 0x83, 0x7C, 0xE0};
  return random.below(2) == 0 ? runs[random.below(runs.size())]
                              : static_cast<std::uint8_t>(random.below(256));
}

Frame random_frame(Random& random) {
  Frame frame;
  const bool is_extended = random.below(2) == 1;
  frame.flags = is_extended ? FrameFlags::extended : FrameFlags::none;
  for (int i = 0; i < 4; ++i) frame.id = frame.id << 8 | random_byte(random);
  frame.id &= is_extended ? Frame::extended_id_max : Frame::id_max;
  if (random.below(16) == 0) {
    frame.flags = frame.flags | FrameFlags::remote;
    return frame;
  }
  frame.length = static_cast<std::uint8_t>(random.below(9));
  for (std::size_t i = 0; i < frame.length; ++i) frame.data[i] = random_byte(random);
  return frame;
}

/// struct can_frame of linux/can.h, in the byte order of the machine.
struct SocketCanFrame {
  std::uint32_t id;
  std::uint8_t length;
  std::array<std::uint8_t, 3> padding;
  std::array<std::uint8_t, 8> data;
};
static_assert(sizeof(SocketCanFrame) == 16);

SocketCanFrame to_socketcan(const Frame& frame) {
  const std::uint32_t extended = frame.is_extended() ? 1U << 31 : 0;
  const std::uint32_t remote = frame.is_remote() ? 1U << 30 : 0;
  return {frame.id | extended | remote, frame.length, {}, frame.data};
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: write_frames COUNT FRAMES BITS\n", stderr);
    return 2;
  }
  const File frames(std::fopen(argv[2], "wb"));
  const File bits(std::fopen(argv[3], "w"));
  if (frames == nullptr || bits == nullptr) {
    std::perror("write_frames: cannot write");
    return 1;
  }
  Random random(1);
  for (long left = std::strtol(argv[1], nullptr, 10); left > 0; --left) {
    const Frame frame = random_frame(random);
    const SocketCanFrame raw = to_socketcan(frame);
    std::fwrite(&raw, sizeof raw, 1, frames.get());
    std::fprintf(bits.get(), "%u\n", canvoy::frame_bits(frame) + canvoy::intermission_bits);
  }
  return 0;
}
