// A seat in an operator cabin on a CAN interface: a joystick, and a lamp that the network switches.
// Replace stick and lamp to adapt it (CiA 852).
//
//     cabin can0 10
//     canvoy write can0 10 1800:1 0x18A  # the network wants the joystick: TPDO 1 is valid now
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/profiles/cia852/handles.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/profiles/model/layout.hpp"

using namespace canvoy;

constexpr cia852::OperatorEnvironment elements = {.joysticks = 1, .indicator_clusters = 1};
constexpr auto seat =
    describe(cia852::operator_environment<elements>(), cia301::identity({.vendor_id = 0x123}),
             cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(1),
             cia301::emergency_consumers(1));
constexpr auto seat_layout = lay_out_device<seat>();

/// The hardware behind the node: here a simulated stick, and a lamp that prints its state.
struct Panel {
  Values values;
  Time next{};
  bool is_lit = false;

  Time deadline() const { return next; }
  void advance(Time now) {
    constexpr auto period = std::chrono::milliseconds(50);
    const double seconds = std::chrono::duration<double>(now.time_since_epoch()).count();
    values[cia852::joystick_x(1)] = static_cast<std::int64_t>(32'000 * std::sin(seconds));
    const bool is_on = values[cia852::indicator<1>(1)].is(cia852::Switch::on);
    if (is_on != is_lit) std::puts(is_on ? "lamp on" : "lamp off");
    is_lit = is_on;
    next = now + period;
  }
};

int main(int count, char** arguments) {
  if (count != 3) return std::puts("usage: cabin INTERFACE NODE-ID"), 2;
  auto loop = host::EventLoop::create();
  if (!loop) return std::puts(loop.error().line().c_str()), 1;
  auto bus = host::open_bus(**loop, arguments[1]);
  if (!bus) return std::puts(bus.error().line().c_str()), 1;

  host::Attachment attachment(**loop, **bus);
  DeviceNode<seat_layout> node(attachment.port(), static_cast<NodeId>(std::atoi(arguments[2])));
  attachment.attach(node.node());
  Panel panel{Values(node.node().dictionary())};
  (*loop)->add({.deadline = Callback<Time()>::to<&Panel::deadline>(panel),
                .advance = Callback<void(Time)>::to<&Panel::advance>(panel)});
  node.node().start((*loop)->now());
  (*loop)->run();
}
