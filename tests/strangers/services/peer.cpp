// A node with TIME and emergencies for a stranger to talk to, through its standard input and
// output: a line a frame, as candump writes it, each way; and some lines that are for the
// application.
//
//     clock DAYS MILLISECONDS    sets its clock
//     tell                       sends TIME
//     raise CODE, clear CODE     an error with the temperature bit comes, or goes
//
// What it hears: `time DAYS MILLISECONDS`, `emergency NODE CODE REGISTER INFO`.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/device_node.hpp"

namespace {

using namespace canvoy;

constexpr EntryRow number(DataType type, std::int64_t initial) {
  return {.type = type, .access = Access::rw, .initial = initial};
}

// Node 5 consumes and produces TIME, and hears the emergencies of node 1.
constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                                          {.index = 0x1001, .entry_count = 1},
                                                          {.index = 0x1012, .entry_count = 1},
                                                          {.index = 0x1014, .entry_count = 1},
                                                          {.index = 0x1028, .entry_count = 2}}),
                                std::to_array<EntryRow>({number(DataType::unsigned32, 0),
                                                         number(DataType::unsigned8, 0),
                                                         number(DataType::unsigned32, 0xC000'0100),
                                                         number(DataType::unsigned32, 0x85),
                                                         number(DataType::unsigned8, 1),
                                                         {.sub_first = 1,
                                                          .sub_last = 1,
                                                          .type = DataType::unsigned32,
                                                          .access = Access::rw,
                                                          .initial = 0x81}}));

class Peer {
 public:
  Peer() {
    device_.time_stamp().on_time(
        Callback<void(const TimeOfDay&, Duration)>::to<&Peer::heard_time>(*this));
    device_.emergency_consumer().on_emergency(
        Callback<void(NodeId, const Emergency&)>::to<&Peer::heard_emergency>(*this));
    device_.node().start(Time{});
  }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    const Error error = {.code = code_in(line), .register_bits = error_register::temperature};
    if (line.find('#') != std::string::npos) {
      device_.node().receive(parse_frame(line).frame, Time{});
    } else if (verb == "clock") {
      TimeOfDay time;
      words >> time.days >> time.milliseconds;
      device_.time_stamp().set_clock(time);
    } else if (verb == "tell") {
      device_.time_stamp().send();
    } else if (verb == "raise") {
      device_.node().raise(error);
    } else if (verb == "clear") {
      device_.node().clear(error);
    }
    device_.node().advance(Time{});
  }

 private:
  static std::uint16_t code_in(const std::string& line) {
    const auto blank = line.rfind(' ');
    const bool given = blank != std::string::npos && line.find('#') == std::string::npos;
    return given ? static_cast<std::uint16_t>(std::strtoul(&line[blank], nullptr, 16))
                 : std::uint16_t{0};
  }
  static void print(const std::string& line) {
    std::puts(line.c_str());
    std::fflush(stdout);
  }
  static bool take(void*, const Frame& frame) {
    print(std::string(FrameText(frame).view()));
    return true;
  }
  void heard_time(const TimeOfDay& time, Duration) {
    print("time " + std::to_string(time.days) + " " + std::to_string(time.milliseconds));
  }
  void heard_emergency(NodeId node_id, const Emergency& emergency) {
    const auto& info = emergency.info;
    char text[64];
    std::snprintf(text, sizeof text, "emergency %u %04X %02X %02X%02X%02X%02X%02X", node_id,
                  emergency.code, emergency.register_bits, info[0], info[1], info[2], info[3],
                  info[4]);
    print(text);
  }

  DeviceNode<layout> device_{{this, &Peer::take, nullptr}, 5};
};

}  // namespace

int main() {
  Peer peer;
  std::string line;
  while (std::getline(std::cin, line)) peer.obey(line);
  return 0;
}
