// Nodes without node-ID for a stranger to find and name, on a bus that is a pair of pipes
// (pipe_node.hpp). The arguments are their serial numbers.
//
// Equal answers to one message are one frame, as on a bus where nodes answer in the same bit: the
// Fastscan of node-canopen takes a second one for the answer to its next message.
#include <algorithm>
#include <cstdlib>
#include <deque>
#include <span>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/remote/identity.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace {

using namespace canvoy;

// Revision and serial number are different, so that parts that are mixed up show.
constexpr auto layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1001, .entry_count = 1},
                              {.index = 0x1018, .entry_count = 5}}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned32},
         {},
         {.access = Access::const_, .initial = 4},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x2F0},
         {.sub_first = 2, .sub_last = 2, .type = DataType::unsigned32, .initial = 0x1A3},
         {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned32, .initial = 0x8001'0002},
         {.sub_first = 4, .sub_last = 4, .type = DataType::unsigned32}})));

/// Frames that were sent since the last one was received.
std::vector<Frame> bus;

class Peer {
 public:
  explicit Peer(std::uint32_t serial_number)
      : identity_(device_.node(), {.serial_number = serial_number}),
        lss_(device_.node(),
             {.configure_bit_timing = {},
              .activate_bit_timing = {},
              .store = Callback<void(NodeId, std::uint8_t)>::to<&Peer::store>(*this),
              .state_entered = {}}) {}

  Node& node() { return device_.node(); }

 private:
  static bool take(void*, const Frame& frame) {
    if (std::ranges::find(bus, frame) == bus.end()) bus.push_back(frame);
    return true;
  }
  void store(NodeId, std::uint8_t) { lss_.stored({}); }

  DeviceNode<layout, LssSlave::routes> device_{{this, &Peer::take, nullptr}, node_id_unconfigured};
  Identity identity_;
  LssSlave lss_;
};

/// All of them; they act as a node.
class Peers {
 public:
  explicit Peers(std::span<char*> serial_numbers) {
    for (const char* const number : serial_numbers) {
      peers_.emplace_back(static_cast<std::uint32_t>(std::strtoul(number, nullptr, 0)));
    }
  }

  Peers& node() { return *this; }
  void start(Time now) {
    for (Peer& peer : peers_) peer.node().start(now);
  }
  void receive(const Frame& frame, Time now) {
    for (Peer& peer : peers_) {
      peer.node().receive(frame, now);
      peer.node().advance(now);
    }
    deliver();
  }
  Time deadline() {
    Time next = Time::max();
    for (Peer& peer : peers_) next = std::min(next, peer.node().deadline());
    return next;
  }
  void advance(Time now) {
    for (Peer& peer : peers_) peer.node().advance(now);
    deliver();
  }

 private:
  static void deliver() {
    for (const Frame& frame : bus) print_frame(nullptr, frame);
    bus.clear();
  }

  std::deque<Peer> peers_;
};

}  // namespace

int main(int count, char** arguments) {
  PipeNode<Peers>(std::span(arguments + 1, static_cast<std::size_t>(count - 1))).run();
}
