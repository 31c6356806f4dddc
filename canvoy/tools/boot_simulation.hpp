// A network to show `canvoy boot`, without hardware: some devices that come up, and one for each of
// the usual reasons why one does not.
//
//     BootSimulation simulation;
//     MasterNode<layout> master(simulation.master_port(), 127);
//     simulation.begin(master.node());
//     simulation.run_for(10ms);
#pragma once

#include <deque>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/layout.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/boot_plan.hpp"
#include "canvoy/tools/presets.hpp"

namespace canvoy::tools {

inline constexpr auto simulated_slave = describe(
    cia301::device_type(0x000F'0191), cia301::error_register_object,
    cia301::identity({.vendor_id = 0x123, .product_code = 7, .revision = 1}),
    cia301::guard_time_object, cia301::life_time_factor_object, cia301::heartbeat_producer(200));
inline constexpr auto simulated_slave_layout = lay_out_device<simulated_slave>();

class BootSimulation {
 public:
  BootSimulation();

  /// The slaves that it has, and others.
  static BootPlan plan();

  Port master_port() { return world_.port(master_); }
  /// Gives the master power; the slaves have it already.
  void begin(Node& master);
  void run_for(Duration duration) { world_.run_for(duration); }
  Time now() const { return world_.now(); }

 private:
  struct Slave {
    Slave(const Port& port, NodeId id) : device(port, id), presets(device.node()) {}
    DeviceNode<simulated_slave_layout> device;
    Presets presets;
  };
  SlotIndex add(NodeId id, std::uint32_t vendor = 0x123);
  SlotIndex add_without_heartbeat(NodeId id);

  World world_;
  BusIndex bus_;
  SlotIndex master_;
  std::deque<Slave> slaves_;
};

}  // namespace canvoy::tools
