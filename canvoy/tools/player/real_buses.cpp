#include "canvoy/tools/player/real_buses.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/session/session.hpp"
#include "canvoy/tools/terminal/message.hpp"

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

namespace {

/// A late network advances by this time at each step, or by a quarter of its delay: time-outs of 5
/// ms do not expire at once, and the plant behind a real drive, which integrates over time, soon
/// catches up.
constexpr Duration step_min = 5ms;
constexpr int looks = 4;
/// Interval for lost frames.
constexpr Duration news_period = 1s;
/// Maximum delay.
constexpr Duration late_max = 500ms;

}  // namespace

RealBuses::RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop)
    : news_([](const std::string& line) { print_message(line); }),
      looked_at_(loop.now()),
      reached_(world.now()) {
  for (const RealBus& each : buses) {
    BusBridge& bridge = bridges_.emplace_back(world, each.bus, loop, each.address);
    news_.follow(bridge.real(), false);
    world.start(bridge.slot());
  }
}

std::uint64_t RealBuses::frames_lost() const {
  std::uint64_t lost = news_.frames_lost();
  for (const BusBridge& bridge : bridges_) lost += bridge.lost();
  return lost;
}

Time RealBuses::reach(Time clock) {
  if (clock >= next_news_) {
    news_.look(clock);
    next_news_ = clock + news_period;
  }
  late_ += clock - std::exchange(looked_at_, clock);
  const Duration too_late = std::max(late_ - late_max, Duration{});
  left_out_ += too_late;
  late_ -= too_late;
  const Duration step = std::min(late_, std::max(step_min, late_ / looks));
  late_ -= step;
  return reached_ += step;
}

}  // namespace canvoy::tools
