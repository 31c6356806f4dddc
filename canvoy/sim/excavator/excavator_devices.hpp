// The devices of an excavator on their buses, each made anew when it gets power: the host, the seat
// with the module for the network behind it, the input and output module on the valves, and the
// armrest.
//
//     ExcavatorDevices devices(world, {bus, embedded}, options, panel, valves);
//     devices.start();
//     devices.hands_moved();
//     devices.node(seat_id).is_operational();
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/sim/excavator/excavator_options.hpp"
#include "canvoy/sim/excavator/machine_control.hpp"
#include "canvoy/sim/excavator/machine_node.hpp"
#include "canvoy/sim/excavator/seat_module.hpp"
#include "canvoy/sim/excavator/valves_hardware.hpp"

namespace canvoy::excavator {

/// As the options have the host.
HostSettings host_settings(const ExcavatorOptions& options);

struct ExcavatorBuses {
  BusIndex machine = 0;
  BusIndex embedded = 0;  ///< behind the seat
};

class ExcavatorDevices {
 public:
  /// All must outlive this.
  ExcavatorDevices(World& world, ExcavatorBuses buses, const ExcavatorOptions& options,
                   SeatPanel& panel, ValvesHardware& valves);
  ExcavatorDevices(const ExcavatorDevices&) = delete;
  ExcavatorDevices& operator=(const ExcavatorDevices&) = delete;

  /// Gives all power that are played here.
  void start();
  /// What has no power is dark, and its valves close.
  void power(MachineNode& node, bool is_on);

  /// Sticks, pedals, wheels, knob, buttons or the lever are others.
  void hands_moved();
  /// What the input and output module senses is another.
  void machine_moved();

  /// One that is there.
  MachineNode& node(NodeId id);
  /// In the order of their node-IDs along the cable, the armrest last.
  std::span<const std::unique_ptr<MachineNode>> nodes() const { return nodes_; }
  BusIndex bus_of(NodeId id) const { return id == armrest_id ? buses_.embedded : buses_.machine; }
  const MachineControl& host() const { return host_->control(); }
  /// Of the seat, on the bus behind it.
  ControllerId module_controller() const { return seat_module_.controller(); }

 private:
  void add_nodes();
  void add_armrest();
  void add_node(const DevicePlace& place, MachineNode::Make make);
  MachineNode::Made make_host(const Port& port);
  MachineNode::Made make_seat(const Port& port);
  MachineNode::Made make_valves(const Port& port);
  MachineNode::Made make_armrest(const Port& port);
  cia852::OperatorEnvironment elements() { return cia852::usual_elements; }
  cia852::OperatorHardware seat_hardware() { return panel_.hardware(); }
  cia852::OperatorSettings seat_settings();
  void is_seat(cia852::OperatorUnit& unit, Node&) { seat_unit_ = &unit; }
  cia401::IoHardware valves_hardware() { return valves_hardware_.hardware(); }
  cia401::IoSettings io_settings() { return {.sensing_period = Duration::zero()}; }
  void is_valves(cia401::IoUnit& unit, Node&) { valves_unit_ = &unit; }
  cia401::IoHardware armrest_hardware();
  void is_armrest(cia401::IoUnit& unit, Node&) { armrest_unit_ = &unit; }
  std::uint8_t sense_lever(unsigned group);

  World& world_;
  ExcavatorBuses buses_;
  const ExcavatorOptions& options_;
  SeatPanel& panel_;
  ValvesHardware& valves_hardware_;
  Site seat_site_;
  Site valves_site_;
  Site armrest_site_;
  std::unique_ptr<MachineHost> host_;
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
