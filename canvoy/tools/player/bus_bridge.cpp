#include "canvoy/tools/player/bus_bridge.hpp"

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

BusBridge::BusBridge(World& world, BusIndex bus, host::EventLoop& loop, std::string_view address)
    : world_(world),
      slot_(world.add_slot(bus, {.accept_all = true})),
      simulated_port_(world.port(slot_)),
      real_(value_or_throw(host::open_bus(loop, real_bus(address)))),
      attachment_(loop, *real_),
      real_port_(attachment_.port()) {
  world_.occupy(slot_, *this);
  attachment_.attach(real_end_);
}

void BusBridge::receive(const Frame& frame, Time) {
  pass(to_real_, real_port_, frame);
}

void BusBridge::heard(const Frame& frame) {
  pass(to_simulated_, simulated_port_, frame);
  world_.touched(slot_);
}

void BusBridge::pass(std::deque<Frame>& waiting, const Port& port, const Frame& frame) {
  flush(waiting, port);
  if (waiting.empty() && port.send(port.context, frame)) return;
  if (waiting.size() == waiting_max) {
    ++lost_;
    return;
  }
  waiting.push_back(frame);
}

void BusBridge::flush(std::deque<Frame>& waiting, const Port& port) {
  while (!waiting.empty() && port.send(port.context, waiting.front())) waiting.pop_front();
}

}  // namespace canvoy::tools
