// The real buses that are part of a simulated network, and the pace that they set for it.
//
//     RealBuses real(world, options.real, *loop);
//     network.run_until(real.reach(loop->now()));  // each RealBuses::period
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/player/player.hpp"
#include "canvoy/tools/session/bus_news.hpp"

namespace canvoy::tools {

// Joins a simulated bus and a real one: frames of either are received on both. A real device thus
// takes part in a simulated network, which must run at the speed of the clock.
//
//     BusBridge bridge(world, bus, *loop, "can0");
//     world.start(bridge.slot());

/// A controller on the simulated bus that receives all frames, and a member of the real bus.
class BusBridge {
 public:
  /// Maximum number of waiting frames on either side; further ones are lost and counted.
  static constexpr std::size_t waiting_max = 1000;

  /// Throws Failure if the real bus cannot be opened.
  BusBridge(World& world, BusIndex bus, host::EventLoop& loop, std::string_view address);
  BusBridge(const BusBridge&) = delete;
  BusBridge& operator=(const BusBridge&) = delete;

  SlotIndex slot() const { return slot_; }
  host::HostBus& real() { return *real_; }
  std::uint64_t lost() const { return lost_; }

  // Interface of a node in World.
  void start(Time) { to_real_.clear(), to_simulated_.clear(); }
  void receive(const Frame& frame, Time);
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) { flush(to_simulated_, simulated_port_); }
  void overrun(Time) { ++lost_; }

 private:
  /// Listener on the real bus.
  struct RealEnd {
    BusBridge& bridge;
    void receive(const Frame& frame, Time) const { bridge.heard(frame); }
    void tx_ready(Time) const { bridge.flush(bridge.to_real_, bridge.real_port_); }
  };

  void heard(const Frame& frame);
  void pass(std::deque<Frame>& waiting, const Port& port, const Frame& frame);
  static void flush(std::deque<Frame>& waiting, const Port& port);

  World& world_;
  SlotIndex slot_;
  Port simulated_port_;
  std::unique_ptr<host::HostBus> real_;
  host::Attachment attachment_;
  Port real_port_;
  RealEnd real_end_{*this};
  std::deque<Frame> to_real_;
  std::deque<Frame> to_simulated_;
  std::uint64_t lost_ = 0;
};

/// The network runs at the speed of the clock. After a pause of this process it catches up in
/// steps, to give real nodes time to answer; the rest of a long pause is skipped.
class RealBuses {
 public:
  /// Interval between calls of reach().
  static constexpr Duration period = 1ms;

  /// Throws Failure if a real bus cannot be opened. Later changes of a bus, and lost frames, are
  /// lines on standard error.
  RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop);
  RealBuses(const RealBuses&) = delete;
  RealBuses& operator=(const RealBuses&) = delete;
  ~RealBuses() = default;

  /// Time of the network up to which to run now.
  Time reach(Time clock);
  /// Errors of real buses that have not ended, in one line; empty: none.
  std::string trouble() const { return news_.trouble(); }
  /// Number of frames lost by the interfaces, by reading too late, or for lack of room on either
  /// side.
  std::uint64_t frames_lost() const;
  /// Duration of skipped pauses.
  Duration left_out() const { return left_out_; }

 private:
  std::deque<BusBridge> bridges_;
  BusNews news_;
  Time next_news_{};
  Time looked_at_{};  ///< by the clock
  Time reached_{};    ///< by the network
  Duration late_{};
  Duration left_out_{};
};

}  // namespace canvoy::tools
