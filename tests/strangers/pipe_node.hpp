// A device of ours whose bus is a pair of pipes, for strangers to talk to: lines come in at the
// standard input and go out at the standard output, until the input ends.
//
//     605#4000100000000000    a frame, as candump -L has it, each way
//     until 1500              time goes on to 1500 ms after the start, and `now 1500` is answered
//     anything else           is for the device: Device::obey(line), at node().now()
//
// Time goes on when it is told to, and stands still otherwise: a busy machine changes nothing.
//
//     PipeNode<DeviceNode<layout>>(pipe_port, 5).run();
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

inline void print_line(std::string_view line) {
  std::printf("%.*s\n", static_cast<int>(line.size()), line.data());
  std::fflush(stdout);
}

inline bool print_frame(void*, const Frame& frame) {
  print_line(FrameText(frame).view());
  return true;
}
inline constexpr Port pipe_port = {nullptr, &print_frame, nullptr};

/// `Device` has node(), which is a Node or acts as one; obey(line) where it takes lines of its own.
template <class Device>
class PipeNode {
 public:
  template <class... Arguments>
  explicit PipeNode(Arguments&&... arguments) : device(std::forward<Arguments>(arguments)...) {
    device.node().start(now_);
    go_on_until(now_);
  }

  void run() {
    while (turn()) {
    }
  }
  /// Takes one line; false at the end of the input.
  bool turn() {
    if (!std::getline(std::cin, line_)) return false;
    take();
    return true;
  }

  Device device;

 private:
  void take() {
    if (line_.starts_with("until ")) {
      const long until_ms = std::strtol(line_.c_str() + 6, nullptr, 10);
      go_on_until(Time(std::chrono::milliseconds(until_ms)));
      return print_line("now " + std::to_string(until_ms));
    }
    if (const ParsedFrame parsed = parse_frame(line_); parsed) {
      device.node().receive(parsed.frame, now_);
    } else if constexpr (requires { device.obey(line_); }) {
      device.node().advance(now_);
      device.obey(line_);
    }
    go_on_until(now_);
  }
  void go_on_until(Time until) {
    while (device.node().deadline() <= until) {
      now_ = std::max(now_, device.node().deadline());
      device.node().advance(now_);
    }
    now_ = std::max(now_, until);
  }

  Time now_{};
  std::string line_;
};

}  // namespace canvoy
