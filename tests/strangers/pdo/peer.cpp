// A node of ours whose bus is a pair of pipes: a frame a line, as candump -L has them, in at the
// standard input and out at the standard output. It ends with its input.
//
//     echo 000#0105 | canvoy_pdo_peer    # 705#00
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/device_node.hpp"
#include "canvoy/canopen/dictionary_layout.hpp"

namespace canvoy {
namespace {

constexpr Access process = Access::rw | Access::rpdo | Access::tpdo;

constexpr EntryRow parameter(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow mapped_objects = {
    .sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw};
constexpr EntryRow invalid = parameter(1, DataType::unsigned32, CobId::bit31);

/// Two PDOs in each direction that are to be configured, and process data of all sizes.
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1001, .entry_count = 1},
                                      {.index = 0x1005, .entry_count = 1},
                                      {.index = 0x1006, .entry_count = 1},
                                      {.index = 0x1007, .entry_count = 1},
                                      {.index = 0x1019, .entry_count = 1},
                                      {.index = 0x1400, .count = 2, .entry_count = 3},
                                      {.index = 0x1600, .count = 2, .entry_count = 2},
                                      {.index = 0x1800, .count = 2, .entry_count = 5},
                                      {.index = 0x1A00, .count = 2, .entry_count = 2},
                                      {.index = 0x2000, .entry_count = 1},
                                      {.index = 0x2001, .entry_count = 1},
                                      {.index = 0x2002, .entry_count = 1}}),
            std::to_array<EntryRow>({
                {.type = DataType::unsigned32},
                {.type = DataType::unsigned8},
                parameter(0, DataType::unsigned32, 0x80),
                parameter(0, DataType::unsigned32),
                parameter(0, DataType::unsigned32),
                parameter(0, DataType::unsigned8),
                invalid,
                parameter(2, DataType::unsigned8, 254),
                parameter(5, DataType::unsigned16),
                parameter(0, DataType::unsigned8),
                mapped_objects,
                invalid,
                parameter(2, DataType::unsigned8, 254),
                parameter(3, DataType::unsigned16),
                parameter(5, DataType::unsigned16),
                parameter(6, DataType::unsigned8),
                parameter(0, DataType::unsigned8),
                mapped_objects,
                {.type = DataType::unsigned16, .access = process},
                {.type = DataType::integer8, .access = process},
                {.type = DataType::unsigned32, .access = process},
            }));

Time now() {
  static const auto start = std::chrono::steady_clock::now();
  return Time(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start));
}

bool put(void*, const Frame& frame) {
  const FrameText text(frame);
  std::printf("%.*s\n", static_cast<int>(text.view().size()), text.view().data());
  std::fflush(stdout);
  return true;
}

class Peer {
 public:
  void run() {
    device_.node().start(now());
    while (is_waiting_over()) {
      Node& node = device_.node();
      while (node.deadline() <= now()) node.advance(now());
    }
  }

 private:
  /// A line came, or a deadline. False at the end of the input.
  bool is_waiting_over() {
    const Duration left = std::clamp<Duration>(device_.node().deadline() - now(), 0ms, 1s);
    const auto left_ms = std::chrono::ceil<std::chrono::milliseconds>(left);
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    return poll(&input, 1, static_cast<int>(left_ms.count())) == 0 || read_lines();
  }
  bool read_lines() {
    char bytes[4096];
    const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) return false;
    for (const char c : std::string_view(bytes, static_cast<std::size_t>(count))) {
      if (c != '\n') {
        line_ += c;
        continue;
      }
      const ParsedFrame parsed = parse_frame(line_);
      if (parsed) device_.node().receive(parsed.frame, now());
      line_.clear();
    }
    return true;
  }

  DeviceNode<layout> device_{{nullptr, &put, nullptr}, 5};
  std::string line_;
};

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::Peer().run();
}
