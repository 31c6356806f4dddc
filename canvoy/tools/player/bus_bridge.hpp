// Joins a simulated bus and a real one: frames of either are received on both. A real device thus
// takes part in a simulated network, which must run at the speed of the clock.
//
//     BusBridge bridge(world, bus, *loop, "can0");
//     world.start(bridge.slot());
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string_view>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::tools {

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

}  // namespace canvoy::tools
