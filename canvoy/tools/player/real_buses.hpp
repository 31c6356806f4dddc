// The real buses that are part of a simulated network, and the pace that they set for it.
//
//     RealBuses real(world, options.real, *loop);
//     network.run_until(real.reach(loop->now()));  // each RealBuses::period
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
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
  RealBuses(const RealBuses&) = delete;
  RealBuses& operator=(const RealBuses&) = delete;
  ~RealBuses() = default;

  /// Time of the network up to which to run now.
  Time reach(Time clock);
  /// Errors of real buses that have not ended, in one line; empty: none.
  std::string trouble() const;
  /// Number of frames lost by the interfaces or by reading too late.
  std::uint64_t frames_lost();
  /// Duration of skipped pauses.
  Duration left_out() const { return left_out_; }

 private:
  std::deque<BusBridge> bridges_;
  std::map<std::string, std::string> troubles_;  ///< by the name of the bus
  Time looked_at_{};                             ///< by the clock
  Time reached_{};                               ///< by the network
  Duration late_{};
  Duration left_out_{};
};

}  // namespace canvoy::tools
