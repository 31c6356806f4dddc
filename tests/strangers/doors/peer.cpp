// A car door unit of ours with a simulated door, whose bus is a pair of pipes: a frame a line, as
// candump -L has them. A line "+" puts somebody into the way of the door, "-" takes him out again.
//
//     echo 000#0106 | canvoy_doors_peer    # 706#00, 201#11100000
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/devices/cia417/car_door_device.hpp"
#include "canvoy/sim/lift/door_plant.hpp"

namespace canvoy {
namespace {

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
  Peer() { plant_.on_change(Callback<void()>::to<&Peer::changed>(*this)); }

  void run() {
    door_.node().start(now());
    while (is_waiting_over()) {
      Node& node = door_.node();
      while (node.deadline() <= now()) node.advance(now());
    }
  }

 private:
  void changed() { door_.door().hardware_changed(); }
  /// A line came, or a deadline. False at the end of the input.
  bool is_waiting_over() {
    const Duration left = std::clamp<Duration>(door_.node().deadline() - now(), 0ms, 1s);
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
      take_line();
      line_.clear();
    }
    return true;
  }
  void take_line() {
    if (line_ == "+" || line_ == "-") return plant_.stand_in_way(now(), line_ == "+");
    const ParsedFrame parsed = parse_frame(line_);
    if (parsed) door_.node().receive(parsed.frame, now());
  }

  lift::DoorPlant plant_{{.open_time_s = 0.5, .close_time_s = 0.5, .has_light_barrier = true}};
  cia417::CarDoorDevice<> door_{{nullptr, &put, nullptr}, 6, {plant_.hardware()}};
  std::string line_;
};

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::Peer().run();
}
