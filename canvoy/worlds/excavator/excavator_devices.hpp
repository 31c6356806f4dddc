// The devices of an excavator on their buses, each made again when it gets power: the host, the
// seat with the module for the network behind it, the input and output module on the valves, and
// the armrest.
//
//     ExcavatorDevices devices(world, {bus, embedded}, options, panel, trainer, valves);
//     devices.start();
//     devices.hands_moved();
//     devices.node(seat_id).is_operational();
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/cia852/two_channel_axes.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/excavator/armrest_watch.hpp"
#include "canvoy/worlds/excavator/excavator_options.hpp"
#include "canvoy/worlds/excavator/machine_control.hpp"
#include "canvoy/worlds/excavator/valves_hardware.hpp"

namespace canvoy::excavator {

// A physical device of an excavator on the simulated bus.
//
//     MachineNode node(world, bus, {.name = "seat", .id = 10}, make);
//     node.power(true);

/// A port that loses a share of the frames of a node, or delays each of them: for the node they
/// count as sent.
///
///     FaultyPort port(world, world.port(slot), seed);
///     port.lose(Probability(0.05));
///     Node node(tables, memory, port.port(), 10);
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

/// A physical device of an excavator on the simulated bus.
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

/// The module of a seat between two buses: its node on the bus of the host, and behind it a network
/// of its own, with devices that hosts reach through it (CiA 852, 8.4).
///
///     SeatModule module(world, embedded_bus);
///     module.connect(seat.node());           // each time that the seat is made again
///     world.occupy(slot, module.access());   // in place of the node
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

/// Settings of the host, by the options.
HostSettings host_settings(const ExcavatorOptions& options);

/// The two buses of the machine.
struct ExcavatorBuses {
  BusIndex machine = 0;   ///< of host, seat and valves
  BusIndex embedded = 0;  ///< behind the seat
};

class ExcavatorDevices {
 public:
  /// All must outlive this object.
  ExcavatorDevices(World& world, ExcavatorBuses buses, const ExcavatorOptions& options,
                   SeatPanel& panel, SeatPanel& trainer, ValvesHardware& valves);
  ExcavatorDevices(const ExcavatorDevices&) = delete;
  ExcavatorDevices& operator=(const ExcavatorDevices&) = delete;

  /// Switches on all devices that are simulated here.
  void start();
  /// Switches power: a device without power is dark, and its valves close.
  void power(MachineNode& node, bool is_on);

  /// Call it when sticks, pedals, wheels, knob, buttons or contacts of the armrest have moved.
  void hands_moved();
  /// Call it when the inputs of the input and output module have changed.
  void machine_moved();

  /// Returns a device that must exist.
  MachineNode& node(NodeId id);
  /// In the order of their node-IDs along the cable, the armrest last.
  std::span<const std::unique_ptr<MachineNode>> nodes() const { return nodes_; }
  /// The bus behind the seat for the armrest, else that of the machine.
  BusIndex bus_of(NodeId id) const { return id == armrest_id ? buses_.embedded : buses_.machine; }
  /// The host, as its referee reads it.
  const MachineControl& host() const { return host_->control(); }
  /// Controller of the seat on the bus behind it.
  ControllerId module_controller() const { return seat_module_.controller(); }

 private:
  void add_nodes();
  void add_armrest();
  void add_node(const DevicePlace& place, MachineNode::Make make);
  MachineNode::Made make_host(const Port& port);
  MachineNode::Made make_seat(const Port& port);
  MachineNode::Made make_valves(const Port& port);
  MachineNode::Made make_armrest(const Port& port);
  cia852::OperatorEnvironment elements();
  // Joysticks 3 and 4 are those of the trainer.
  SeatPanel& seat_of(unsigned joystick) { return joystick <= 2 ? panel_ : trainer_; }
  static unsigned of_seat(unsigned joystick) { return joystick <= 2 ? joystick : joystick - 2; }
  std::int16_t first_axis(unsigned joystick, unsigned axis);
  std::int16_t second_axis(unsigned joystick, unsigned axis);
  std::uint8_t joystick_buttons(unsigned joystick);
  cia852::OperatorHardware seat_hardware();
  cia852::OperatorSettings seat_settings();
  void is_seat(cia852::OperatorUnit& unit, Node& node);
  cia401::IoHardware valves_hardware() { return valves_hardware_.hardware(); }
  cia401::IoSettings io_settings() { return {.sensing_period = Duration::zero()}; }
  cia401::IoHardware armrest_hardware();
  std::uint8_t sense_contacts(unsigned group);

  World& world_;
  ExcavatorBuses buses_;
  const ExcavatorOptions& options_;
  SeatPanel& panel_;
  SeatPanel& trainer_;
  ValvesHardware& valves_hardware_;
  Environment seat_site_;
  Environment valves_site_;
  Environment armrest_site_;
  std::unique_ptr<MachineHost> host_;
  std::optional<cia852::TwoChannelAxes> axes_;  ///< of the seat
  std::unique_ptr<CatalogueDevice> seat_;
  std::unique_ptr<CatalogueDevice> valves_;
  std::unique_ptr<CatalogueDevice> armrest_;
  SeatModule seat_module_;
  cia852::OperatorUnit* seat_unit_ = nullptr;
  cia401::IoUnit* valves_unit_ = nullptr;
  cia401::IoUnit* armrest_unit_ = nullptr;
  std::vector<std::unique_ptr<MachineNode>> nodes_;
};

}  // namespace canvoy::excavator
