// A physical device of an excavator on the simulated bus.
//
//     MachineNode node(world, bus, {.name = "seat", .id = 10}, make);
//     node.power(true);
#pragma once

#include <functional>
#include <string_view>

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::excavator {

// A port that loses a share of the frames of a node, or delays each of them: for the node they
// count as sent.
//
//     FaultyPort port(world, world.port(slot), seed);
//     port.lose(Probability(0.05));
//     Node node(tables, memory, port.port(), 10);

class FaultyPort {
 public:
  /// `world` must outlive this object.
  FaultyPort(World& world, const Port& inner, std::uint64_t seed)
      : world_(world), inner_(inner), random_(seed) {}
  FaultyPort(const FaultyPort&) = delete;
  FaultyPort& operator=(const FaultyPort&) = delete;

  /// Sets the share of frames to lose; 0: none.
  void lose(Probability share) { lost_ = share; }
  /// Each frame leaves this much later; 0: at once.
  void delay(Duration delay) { delay_ = delay; }

  /// Port for the node; valid as long as this object.
  Port port() {
    return {.context = this,
            .send = [](void* self, const Frame& frame) -> bool {
              return static_cast<FaultyPort*>(self)->send(frame);
            },
            .accept =
                [](void* self, std::uint16_t id, bool wanted) {
                  const Port& inner = static_cast<FaultyPort*>(self)->inner_;
                  if (inner.accept != nullptr) inner.accept(inner.context, id, wanted);
                }};
  }

 private:
  bool send(const Frame& frame) {
    if (random_.happens(lost_)) return true;
    if (delay_ == Duration::zero() && world_.now() >= last_) {
      return inner_.send(inner_.context, frame);
    }
    // No frame overtakes another one.
    last_ = std::max(last_, world_.now() + delay_);
    world_.at(last_, [this, frame](Time) { inner_.send(inner_.context, frame); });
    return true;
  }

  World& world_;
  Port inner_;
  Random random_;
  Probability lost_;
  Duration delay_{};
  Time last_{};
};

class MachineNode {
 public:
  /// Which device it is.
  struct Place {
    std::string_view name;  ///< in files and logs
    NodeId id = 0;          ///< 1 to 127
    bool is_played = true;  ///< false: a real device has this node-ID
  };
  /// A device as Make returns it.
  struct Made {
    Node& node;                      ///< valid until it is made again
    RemoteAccess* access = nullptr;  ///< of a node with a network behind it: it receives the frames
                                     ///< of that bus

    /// A node without a network behind it.
    Made(Node& made) : node(made) {}  // NOLINT(google-explicit-constructor)
    /// A node with a network behind it.
    Made(Node& made, RemoteAccess& way_behind) : node(made), access(&way_behind) {}
  };
  /// Makes the device again at this port. The caller that supplies this function keeps the device.
  using Make = std::function<Made(const Port&)>;

  /// `world` must outlive this object. The device has no power yet.
  MachineNode(World& world, BusIndex bus, const Place& place, std::uint64_t seed, Make make)
      : world_(world),
        bus_(bus),
        slot_(world.add_slot(bus)),
        place_(place),
        port_(world, world.port(slot_), seed),
        make_(std::move(make)) {
    occupy();
  }
  MachineNode(const MachineNode&) = delete;
  MachineNode& operator=(const MachineNode&) = delete;

  /// Switches power; a device that gets power starts from its initial state. One that is not
  /// simulated here stays off.
  void power(bool is_on) {
    world_.stop(slot_);
    if (!is_on || !place_.is_played) return;
    ++starts_;
    occupy();
    world_.start(slot_);
  }

  /// As given.
  const Place& place() const { return place_; }
  /// Its bus.
  BusIndex bus() const { return bus_; }
  /// Its slot on that bus.
  SlotIndex slot() const { return slot_; }
  /// Call it after the node was called from outside of this bus, as from the one behind it.
  void touched() { world_.touched(slot_); }
  /// Its node; made again at each power-on, so keep no reference.
  Node& node() { return *node_; }
  /// Its port, which may lose and delay frames.
  FaultyPort& port() { return port_; }
  /// Its number on the bus.
  ControllerId controller() const { return world_.controller(slot_); }
  /// True while it runs.
  bool is_powered() const { return world_.is_running(slot_); }
  /// Number of times that it got power.
  unsigned starts() const { return starts_; }
  /// True if it runs, and is in the NMT state Operational.
  bool is_operational() const { return is_powered() && node_->state() == NmtState::operational; }
  /// Calls `act`, which changes the surroundings of the device: the device is brought up to the
  /// present before, and called again after it. Does nothing without power.
  template <class Act>
  void with(const Act& act) {
    if (!is_powered()) return;
    node_->advance(world_.now());
    act();
    world_.touched(slot_);
  }

 private:
  void occupy() {
    const Made made = make_(port_.port());
    node_ = &made.node;
    if (made.access != nullptr) return world_.occupy(slot_, *made.access);
    world_.occupy(slot_, *node_);
  }

  World& world_;
  BusIndex bus_;
  SlotIndex slot_;
  Place place_;
  FaultyPort port_;
  Make make_;
  Node* node_ = nullptr;
  unsigned starts_ = 0;
};

}  // namespace canvoy::excavator
