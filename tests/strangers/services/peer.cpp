// A node with TIME and emergencies for a stranger to talk to, on a bus that is a pair of pipes
// (pipe_node.hpp). Other lines are for the application:
//
//     clock DAYS MILLISECONDS    sets its clock
//     tell                       sends TIME
//     raise CODE, clear CODE     an error with the temperature bit comes, or goes
//
// What it hears: `time DAYS MILLISECONDS`, `emergency NODE CODE REGISTER INFO`.
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "canvoy/canopen/device/device_node.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace {

using namespace canvoy;

constexpr EntryRow number(DataType type, std::int64_t initial) {
  return {.type = type, .access = Access::rw, .initial = initial};
}

// Node 5 consumes and produces TIME, and hears the emergencies of node 1.
constexpr auto layout =
    partial(lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
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
                                              .initial = 0x81}})));

class Peer {
 public:
  Peer() {
    device_.time_stamp().on_time(
        Callback<void(const TimeOfDay&, Duration)>::to<&Peer::heard_time>(*this));
    device_.emergency_consumer().on_emergency(
        Callback<void(NodeId, const Emergency&)>::to<&Peer::heard_emergency>(*this));
  }

  Node& node() { return device_.node(); }
  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    const Error error = {.code = code_in(line), .register_bits = error_register::temperature};
    if (verb == "clock") {
      TimeOfDay time;
      words >> time.days >> time.milliseconds;
      device_.time_stamp().set_clock(time);
    } else if (verb == "tell") {
      device_.time_stamp().send();
    } else if (verb == "raise") {
      node().raise(error);
    } else if (verb == "clear") {
      node().clear(error);
    }
  }

 private:
  static std::uint16_t code_in(const std::string& line) {
    const auto blank = line.rfind(' ');
    if (blank == std::string::npos) return 0;
    return static_cast<std::uint16_t>(std::strtoul(&line[blank], nullptr, 16));
  }
  void heard_time(const TimeOfDay& time, Duration) {
    print_line("time " + std::to_string(time.days) + " " + std::to_string(time.milliseconds));
  }
  void heard_emergency(NodeId node_id, const Emergency& emergency) {
    const auto& info = emergency.info;
    char text[64];
    std::snprintf(text, sizeof text, "emergency %u %04X %02X %02X%02X%02X%02X%02X", node_id,
                  emergency.code, emergency.register_bits, info[0], info[1], info[2], info[3],
                  info[4]);
    print_line(text);
  }

  DeviceNode<layout> device_{pipe_port, 5};
};

}  // namespace

int main() {
  canvoy::PipeNode<Peer>().run();
}
