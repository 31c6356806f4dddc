// A landing panel of ours (node 22), or a call controller (node 1), whose bus is a pair of pipes: a
// frame a line, as candump -L has them. Lines that begin with `!` are the buttons and lamps:
//
//     canvoy_lift_panel_peer panel       # !press 0, !release 0 in; !lamp 0 on 1 out
//     canvoy_lift_panel_peer controller  # !arrive 3 in
//
// It ends with its input.
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/devices/cia417/call_controller_device.hpp"
#include "canvoy/devices/cia417/lift_panel_device.hpp"

namespace canvoy::cia417 {
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
constexpr Port pipe_port = {nullptr, &put, nullptr};

void show(std::uint32_t output, const OutputView& view) {
  std::printf("!lamp %u %s %u\n", output, view.on ? "on" : "off", view.sub_function);
  std::fflush(stdout);
}

class Panel {
 public:
  Node& node() { return device_.node(); }
  void obey(std::string_view what, unsigned number) {
    device_.inputs().set_level(number, what == "press", now());
  }

 private:
  static void show_output(void*, std::uint32_t output, const OutputView& view) {
    show(output, view);
  }
  LandingPanelDevice<> device_{pipe_port,
                               22,
                               {.show = {&show_output, nullptr}},
                               LandingPanel{.floor = 3, .highest_floor = 10, .fire_key = true}};
};

class Controller {
 public:
  Node& node() { return device_.node(); }
  void obey(std::string_view, unsigned floor) {
    node().advance(now());
    CallController& calls = device_.calls();
    calls.display().floor = static_cast<std::uint8_t>(floor);
    calls.answered(static_cast<std::uint8_t>(floor), Direction::up);
    calls.show();
  }

 private:
  CallControllerDevice<> device_{pipe_port, 1, {.served = {FloorSet::between(1, 10)}}};
};

template <class Part>
class Peer {
 public:
  void run() {
    Node& node = part_.node();
    node.start(now());
    while (is_waiting_over()) {
      while (node.deadline() <= now()) node.advance(now());
    }
  }

 private:
  /// A line came, or a deadline. False at the end of the input.
  bool is_waiting_over() {
    const Duration left = std::clamp<Duration>(part_.node().deadline() - now(), 0ms, 1s);
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
    const std::size_t space = line.find(' ');
    if (line.starts_with('!') && space != std::string::npos) {
      const auto number = std::strtoul(line.c_str() + space, nullptr, 10);
      return part_.obey(std::string_view(line).substr(1, space - 1), static_cast<unsigned>(number));
    }
    const ParsedFrame parsed = parse_frame(line);
    if (parsed) part_.node().receive(parsed.frame, now());
  }

  Part part_;
  std::string line_;
};

}  // namespace
}  // namespace canvoy::cia417

int main(int count, char** arguments) {
  using canvoy::cia417::Controller, canvoy::cia417::Panel, canvoy::cia417::Peer;
  const std::string_view role = count > 1 ? arguments[1] : "";
  if (role == "panel") {
    Peer<Panel>().run();
  } else if (role == "controller") {
    Peer<Controller>().run();
  } else {
    return 2;
  }
}
