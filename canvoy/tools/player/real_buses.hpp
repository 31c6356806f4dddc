// The real buses that are part of a simulated network, and the pace that they set for it.
//
//     RealBuses real(world, options.real, *loop);
//     network.run_until(real.reach(loop->now()));  // each RealBuses::period
#pragma once

#include <deque>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/tools/player/bus_bridge.hpp"
#include "canvoy/tools/player/player.hpp"

namespace canvoy::tools {

/// The network runs at the speed of the clock. After a pause of this process it catches up in
/// steps, to give real nodes time to answer; the rest of a long pause is skipped.
class RealBuses {
 public:
  /// Interval between calls of reach().
  static constexpr Duration period = 1ms;

  /// Throws Failure if a real bus cannot be opened. Later errors are lines on standard error.
  RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop);

  /// Time of the network up to which to run now.
  Time reach(Time clock);
  /// Duration of skipped pauses.
  Duration left_out() const { return left_out_; }

 private:
  std::deque<BusBridge> bridges_;
  Time looked_at_{};  ///< by the clock
  Time reached_{};    ///< by the network
  Duration late_{};
  Duration left_out_{};
};

}  // namespace canvoy::tools
