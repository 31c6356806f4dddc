// A car drive unit of ours (node 2) with a simulated car, whose bus is a pair of pipes: a frame a
// line, as candump -L has them. Lines that begin with `!` are the car:
//
//     canvoy_lift_drive_peer   # !where 0 in; !car 1234 closed out (millimetres, the brake)
//
// It ends with its input.
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/sim/lift/car_plant.hpp"

namespace canvoy::cia417 {
namespace {

class Peer {
 public:
  void run() {
    Node& node = device_.node();
    node.start(now());
    while (is_waiting_over()) {
      while (node.deadline() <= now()) node.advance(now());
    }
  }

 private:
  static Time now() {
    static const auto start = std::chrono::steady_clock::now();
    return Time(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start));
  }
  static bool put(void*, const Frame& frame) {
    const FrameText text(frame);
    std::printf("%.*s\n", static_cast<int>(text.view().size()), text.view().data());
    std::fflush(stdout);
    return true;
  }
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
      take(line_);
      line_.clear();
    }
    return true;
  }
  void take(const std::string& line) {
    if (line.starts_with('!')) return tell_car();
    const ParsedFrame parsed = parse_frame(line);
    if (parsed) device_.node().receive(parsed.frame, now());
  }
  void tell_car() {
    const lift::CarPlant::Truth car = plant_.truth();
    std::printf("!car %ld %s\n", std::lround(car.position_m * 1000),
                car.brake_is_closed ? "closed" : "open");
    std::fflush(stdout);
  }

  lift::CarPlant plant_{{}, {[](void*) { return now(); }, nullptr}};
  CarDriveDevice<> device_{{nullptr, &put, nullptr}, 2, plant_.drive_hardware()};
  std::string line_;
};

}  // namespace
}  // namespace canvoy::cia417

int main() {
  canvoy::cia417::Peer().run();
}
