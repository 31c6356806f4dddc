// The module of a seat between two buses: its node on the bus of the host, and behind it a network
// of its own, with devices that hosts reach through it (CiA 852, 8.4).
//
//     SeatModule module(world, embedded_bus);
//     module.connect(seat.node());           // each time that the seat is made again
//     world.occupy(slot, module.access());   // in place of the node
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/excavator/armrest_watch.hpp"

namespace canvoy::excavator {

class SeatModule {
 public:
  /// `world` must outlive this object. `touched` is called when a frame from behind was passed on
  /// to the node.
  SeatModule(World& world, BusIndex embedded, std::function<void()> touched)
      : world_(world),
        slot_(world.add_slot(embedded, {.accept_all = true})),
        touched_(std::move(touched)) {
    world.occupy(slot_, ear_);
  }
  SeatModule(const SeatModule&) = delete;
  SeatModule& operator=(const SeatModule&) = delete;

  /// Connects a new node, which has not started yet, and discards the state of the one before.
  RemoteAccess& connect(Node& node) {
    access_.reset();
    channels_.emplace();
    return access_.emplace(node, world_.port(slot_), *channels_, armrest_access);
  }
  /// Call it before the node is destroyed.
  void disconnect() { access_.reset(); }
  /// Controller of the module on the bus behind it.
  ControllerId controller() const { return world_.controller(slot_); }
  /// Switches power of its controller on the bus behind it.
  void power(bool is_on) {
    world_.stop(slot_);
    if (is_on) world_.start(slot_);
  }

 private:
  /// Listener on the bus behind.
  struct Ear {
    SeatModule& module;
    void start(Time) {}
    void receive(const Frame& frame, Time now) {
      if (!module.access_) return;
      module.access_->receive_embedded(frame, now);
      module.touched_();
    }
    void advance(Time) {}
    Time deadline() const { return never; }
    void bus_state(BusState, Time) {}
    void tx_ready(Time) {}
    void overrun(Time) {}
  };

  World& world_;
  SlotIndex slot_;
  std::function<void()> touched_;
  std::optional<std::array<RemoteChannel, 1>> channels_;
  std::optional<RemoteAccess> access_;
  Ear ear_{*this};
};

}  // namespace canvoy::excavator
