// A real bus, shared by any number of nodes of this process: each hears the others and the world,
// never itself.
//
//     Result<std::unique_ptr<HostBus>> bus = open_bus(*loop, "can0");
//     if (!bus) return fail(bus.error().line());
//     (*bus)->on_frame([](const BusFrame& heard) { print(heard); });
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/host/bus_address.hpp"
#include "canvoy/can/host/carrier.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/can/host/send_queue.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::host {

/// A frame that was on the bus.
struct BusFrame {
  Frame frame;
  Time time;  ///< as the kernel stamped it; EventLoop::epoch() + time is the wall clock
  Origin origin = Origin::elsewhere;
};

/// Counted from the opening of the bus.
struct BusCounters {
  std::uint64_t received = 0;  ///< from elsewhere, and let through by the filter
  std::uint64_t sent = 0;      ///< of this process, and seen on the bus
  std::uint64_t refused =
      0;  ///< sends answered by `false`: queue full or bus down. The node keeps the frame.
  std::uint64_t dropped = 0;  ///< waiting or under way when the bus went down, or without a route
  std::uint64_t unknown_echo =
      0;  ///< own frames of which the sender was no longer known; no member got them
  CarrierCounters carrier;
};

/// What a node wants to hear. Empty callbacks are allowed.
struct BusMember {
  Callback<void(const Frame&, Time)> receive;  ///< data and remote frames of others
  Callback<void(BusState, Time)> bus_state;
  Callback<void(Time)> tx_ready;  ///< after a refused send: there is room again
};

/// Owns the carrier. A frame goes out in the order of send(), and reaches the other members and
/// on_frame() when it comes back from the bus, so that all of them, and candump, see one order.
/// Times that members get never go back and are never before what they were advanced to; on_frame()
/// gets the kernel's own time stamp. Frames that no member wants stay in the kernel where it can
/// filter, unless there is an on_frame(). Cost: linear in the members for each frame. Not movable:
/// ports point to it. Loop thread only.
class HostBus {
 public:
  class Seat;

  HostBus(EventLoop& loop, std::unique_ptr<Carrier> carrier);
  ~HostBus();
  HostBus(const HostBus&) = delete;
  HostBus& operator=(const HostBus&) = delete;

  std::string_view name() const { return carrier_->name(); }
  BusState state() const { return state_; }
  BusCounters counters() const;

  /// A place on the bus; it gets nothing until serve(). Leaving is allowed at any time, also from a
  /// callback.
  Seat& join();
  void leave(Seat& seat);

  /// Sends for nobody in particular: all members hear it. False where it was refused.
  bool send(const Frame& frame) { return send_for(nullptr, frame); }

  /// Called for every frame on the bus, own and foreign, also error frames, in their order; as long
  /// as the bus lives.
  void on_frame(std::function<void(const BusFrame&)> observer);
  void on_state(std::function<void(BusState, Time)> observer);
  /// The interface went down, there is no route ...: one line when it begins.
  void on_trouble(std::function<void(const Error&)> observer);

 private:
  bool send_for(Seat* sender, const Frame& frame);
  bool transmit(const SentFrame& sent);
  SendResult give(const Frame& frame);
  bool wants_all() const;
  void filter();
  void filter_later();
  void wants(std::uint16_t id);
  void flush();
  void offer_room();
  void frame_arrived(const Frame& frame, Time time, Origin origin);
  void state_changed(BusState state, Time time);
  void trouble(const Error& error);
  void deliver(const Frame& frame, Time time, const void* sender);
  template <class Action>
  void each_seat(Action action);
  Time member_time(Time stamp);
  void sweep();

  EventLoop& loop_;
  std::unique_ptr<Carrier> carrier_;
  std::vector<std::unique_ptr<Seat>> seats_;
  std::vector<std::function<void(const BusFrame&)>> frame_observers_;
  std::vector<std::function<void(BusState, Time)>> state_observers_;
  std::vector<std::function<void(const Error&)>> trouble_observers_;
  SendQueue queue_;
  EchoQueue echoes_;
  BusState state_ = BusState::error_active;
  Time member_time_{};
  int rounds_ = 0;
  bool seats_left_ = false;
  bool filters_ = false;  ///< the carrier hands on accepted_ only
  AcceptedIds accepted_;
  AcceptedIds sent_;  ///< own frames come back through the filter
  EventLoop::Id filter_due_ = 0;
  BusCounters counters_;
};

/// A member's place on a HostBus.
class HostBus::Seat {
 public:
  explicit Seat(HostBus& bus) : bus_(&bus) {}
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  /// The node's way to the bus. Without a call of `accept` it hears all 11-bit identifiers; after
  /// the first, those that it wants. 29-bit frames it hears always.
  Port port();
  void serve(const BusMember& member) { member_ = member; }

 private:
  friend class HostBus;

  bool wants(const Frame& frame) const {
    return !filtering_ || frame.is_extended() || wanted_[frame.id & Frame::id_max];
  }

  HostBus* bus_;
  BusMember member_;
  AcceptedIds wanted_;
  bool filtering_ = false;
  bool refused_ = false;
  bool left_ = false;
};

/// Opens what parse_bus_address() understands. `sim` is no bus of the host: it is refused with a
/// line that says so.
Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, const BusAddress& address);
Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, std::string_view address);

}  // namespace canvoy::host
