#include "canvoy/tools/player/real_buses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
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
/// Maximum delay.
constexpr Duration late_max = 500ms;

}  // namespace

RealBuses::RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop)
    : looked_at_(loop.now()), reached_(world.now()) {
  for (const RealBus& each : buses) {
    BusBridge& bridge = bridges_.emplace_back(world, each.bus, loop, each.address);
    const std::string name(bridge.real().name());
    bridge.real().on_state([this, name](BusState state, Time) {
      if (state == BusState::error_active) {
        troubles_.erase(name);
      } else {
        troubles_.try_emplace(name, fmt::format("{} is {}", name, text::bus_state_text(state)));
      }
    });
    bridge.real().on_trouble([this, name](const host::Error& error) {
      troubles_[name] = error.line();
      print_message(fmt::format("canvoy: {}", error.line()));
    });
    world.start(bridge.slot());
  }
}

std::string RealBuses::trouble() const {
  std::string all;
  for (const auto& [name, text] : troubles_) all += (all.empty() ? "" : "; ") + text;
  return all;
}

std::uint64_t RealBuses::frames_lost() {
  std::uint64_t lost = 0;
  for (BusBridge& bridge : bridges_) lost += bridge.real().counters().carrier.overrun;
  return lost;
}

Time RealBuses::reach(Time clock) {
  late_ += clock - std::exchange(looked_at_, clock);
  const Duration too_late = std::max(late_ - late_max, Duration{});
  left_out_ += too_late;
  late_ -= too_late;
  const Duration step = std::min(late_, std::max(step_min, late_ / looks));
  late_ -= step;
  return reached_ += step;
}

}  // namespace canvoy::tools
