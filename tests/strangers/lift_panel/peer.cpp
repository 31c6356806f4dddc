// A landing panel of ours (node 22), or a call controller (node 1), on a bus that is a pair of
// pipes (pipe_node.hpp). Other lines are the buttons, lamps and the car:
//
//     canvoy_lift_panel_peer panel       # press 0, release 0 in; lamp 0 on 1 out
//     canvoy_lift_panel_peer controller  # arrive 3 in
#include <cstdlib>
#include <string>
#include <string_view>

#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/cia417/panel/lift_panel_device.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy::cia417 {
namespace {

/// Behind the word that a line begins with.
unsigned number_in(const std::string& line) {
  const std::size_t space = std::min(line.find(' '), line.size());
  return static_cast<unsigned>(std::strtoul(line.c_str() + space, nullptr, 10));
}

class Panel {
 public:
  Node& node() { return device_.node(); }
  void obey(const std::string& line) {
    device_.inputs().set_level(number_in(line), line.starts_with("press"), node().now());
  }

 private:
  static void show(void*, std::uint32_t output, const OutputView& view) {
    print_line("lamp " + std::to_string(output) + (view.on ? " on " : " off ") +
               std::to_string(view.sub_function));
  }
  LandingPanelDevice<> device_{pipe_port,
                               22,
                               {.show = {&show, nullptr}},
                               LandingPanel{.floor = 3, .highest_floor = 10, .fire_key = true}};
};

class Controller {
 public:
  Node& node() { return device_.node(); }
  void obey(const std::string& line) {
    const auto floor = static_cast<std::uint8_t>(number_in(line));
    CallController& calls = device_.calls();
    calls.display().floor = floor;
    calls.answered(floor, Direction::up);
    calls.show();
  }

 private:
  CallControllerDevice<> device_{pipe_port, 1, {.served = {FloorSet::between(1, 10)}}};
};

}  // namespace
}  // namespace canvoy::cia417

int main(int count, char** arguments) {
  using canvoy::PipeNode, canvoy::cia417::Controller, canvoy::cia417::Panel;
  const std::string_view role = count > 1 ? arguments[1] : "";
  if (role == "panel") {
    PipeNode<Panel>().run();
  } else if (role == "controller") {
    PipeNode<Controller>().run();
  } else {
    return 2;
  }
}
