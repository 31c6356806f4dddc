// A real bus, shared by any number of nodes of this process: each receives the frames of the others
// and of the outside, never its own.
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
  Frame frame;  ///< data, remote or error frame
  /// Time stamp of the kernel; EventLoop::epoch() + time is the wall clock.
  Time time;
  Origin origin = Origin::elsewhere;  ///< this process or another one
};

/// Counters since the bus was opened.
struct BusCounters {
  std::uint64_t received = 0;  ///< from outside, after the filter
  std::uint64_t sent = 0;      ///< by this process, and seen on the bus
  /// See below.
  std::uint64_t refused =
      /// Sends with the result `false`: queue full or bus down. The node keeps the frame.
      0;
  /// Waiting or in transit when the bus went down, or without a route.
  std::uint64_t dropped = 0;
  /// See below.
  std::uint64_t unknown_echo =
      /// Own frames without a known sender; no member received them.
      0;
  CarrierCounters carrier;  ///< of the carrier below the bus
};

/// Callbacks of a node. Empty ones are allowed.
struct BusMember {
  /// Data and remote frames of other members and nodes.
  Callback<void(const Frame&, Time)> receive;
  /// Each change of the state of the controller; the state at attach() is not reported.
  Callback<void(BusState, Time)> bus_state;
  /// After a refused send: there is room again.
  Callback<void(Time)> tx_ready;
};

/// The bus. It owns the carrier. Frames go out in the order of send(), and reach the other members
/// and on_frame() when they come back from the bus, so that all of them, and candump, see one
/// order. Times passed to a member never go back and are never before the time that it was advanced
/// to; on_frame() gets the time stamp of the kernel. Frames that no member needs stay in the kernel
/// if it can filter, unless there is an on_frame(). Cost: linear in the members for each frame. Not
/// movable, since ports refer to it. Only for the thread of the loop.
class HostBus {
 public:
  class Endpoint;

  /// Makes the bus; open_bus() is the usual way. `loop` must outlive it.
  HostBus(EventLoop& loop, std::unique_ptr<Carrier> carrier);
  ~HostBus();
  HostBus(const HostBus&) = delete;
  HostBus& operator=(const HostBus&) = delete;

  /// Name in the notation of users: can0.
  std::string_view name() const { return carrier_->name(); }
  /// State of the controller, as far as the carrier reports one; otherwise error-active.
  BusState state() const { return state_; }
  /// Counters so far. By value, since they are collected from several parts.
  BusCounters counters() const;

  /// Adds a member; it receives nothing until attach(). Leaving is allowed at any time, also from a
  /// callback.
  Endpoint& join();
  /// Removes a member, which gets no further call; frames that it has sent still go out.
  void leave(Endpoint& endpoint);

  /// Sends a frame without a sender: all members receive it. False if it was refused.
  bool send(const Frame& frame) { return send_for(nullptr, frame); }

  /// Sets an observer for every frame on the bus, own and foreign, also error frames, in their
  /// order; it lives as long as the bus.
  void on_frame(std::function<void(const BusFrame&)> observer);
  /// Sets an observer for states of the controller; it lives as long as the bus.
  void on_state(std::function<void(BusState, Time)> observer);
  /// Sets an observer for trouble (the interface is down, there is no route): called once at its
  /// beginning.
  void on_trouble(std::function<void(const Error&)> observer);

 private:
  bool send_for(Endpoint* sender, const Frame& frame);
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
  void each_endpoint(Action action);
  Time member_time(Time stamp);
  void sweep();

  EventLoop& loop_;
  std::unique_ptr<Carrier> carrier_;
  std::vector<std::unique_ptr<Endpoint>> endpoints_;
  std::vector<std::function<void(const BusFrame&)>> frame_observers_;
  std::vector<std::function<void(BusState, Time)>> state_observers_;
  std::vector<std::function<void(const Error&)>> trouble_observers_;
  SendQueue queue_;
  EchoQueue echoes_;
  BusState state_ = BusState::error_active;
  Time member_time_{};
  int rounds_ = 0;
  bool seats_left_ = false;
  bool filters_ = false;  ///< the carrier passes accepted_ only
  AcceptedIds accepted_;
  AcceptedIds sent_;  ///< own frames pass the filter too
  EventLoop::Id filter_due_ = 0;
  BusCounters counters_;
};

/// Connection of a member to a HostBus.
class HostBus::Endpoint {
 public:
  /// Made by HostBus::join().
  explicit Endpoint(HostBus& bus) : bus_(&bus) {}
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;

  /// Port of the node. Without a call of `accept` it receives all 11-bit identifiers; after the
  /// first call, only those accepted. It always receives 29-bit frames.
  Port port();
  /// Sets the callbacks of the node; it receives from then on.
  void attach(const BusMember& member) { member_ = member; }

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

/// Opens the bus of an address from parse_bus_address(). `sim` is not a bus of the host: it is
/// refused with an explanation.
Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, const BusAddress& address);
/// Opens the bus of an address in the notation of users: see parse_bus_address().
Result<std::unique_ptr<HostBus>> open_bus(EventLoop& loop, std::string_view address);

}  // namespace canvoy::host
