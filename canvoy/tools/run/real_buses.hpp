// The real buses that are parts of a simulated network, and how far the network may run because of
// them.
//
//     RealBuses real(world, options.real, *loop);
//     network.run_until(real.reach(loop->now()));  // each RealBuses::period
#pragma once

#include <deque>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/run/bus_bridge.hpp"
#include "canvoy/tools/run/player.hpp"

namespace canvoy::tools {

/// The network runs as fast as the clock. Behind a pause of this process it does not catch up in
/// one go, since who is out there would have no time to answer, but by steps; of a long pause, the
/// rest is left out.
class RealBuses {
 public:
  /// From one call of reach() to the next.
  static constexpr Duration period = 1ms;

  /// Throws Failure where a real bus cannot be opened. Troubles of one later on are lines on the
  /// standard error output.
  RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop);

  /// Up to which time of the network to run now.
  Time reach(Time clock);
  /// Of the clock, while the network stood still.
  Duration left_out() const { return left_out_; }

 private:
  std::deque<BusBridge> bridges_;
  Time looked_at_{};  ///< of the clock
  Time reached_{};    ///< of the network
  Duration late_{};
  Duration left_out_{};
};

}  // namespace canvoy::tools
