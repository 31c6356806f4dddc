// A simulated network for `canvoy boot`, without hardware: some devices that boot, and one for each
// common reason of failure, from A to O.
//
//     BootSimulation simulation;
//     BootMaster master(BootSimulation::plan(), simulation.master_port());
//     simulation.begin(master.node());
//     simulation.run_for(10ms);
#pragma once

#include <array>
#include <cstdint>
#include <deque>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/program.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/tools/network/boot_plan.hpp"
#include "canvoy/tools/network/presets.hpp"

namespace canvoy::tools {

inline constexpr auto simulated_slave = describe(
    cia301::device_type(0x000F'0191), cia301::error_register_object,
    cia301::identity({.vendor_id = 0x123, .product_code = 7, .revision = 1}),
    cia301::guard_time_object, cia301::life_time_factor_object, cia301::heartbeat_producer(200));
inline constexpr auto simulated_slave_layout = lay_out_device<simulated_slave>();

/// A device without node guarding that accepts a configuration and a program.
inline constexpr auto simulated_programmable = describe(
    cia301::device_type(0x000F'0191), cia301::error_register_object,
    cia301::identity({.vendor_id = 0x123, .product_code = 8, .revision = 1}),
    cia301::heartbeat_producer(0), cia301::verify_configuration_object, cia302::programs(1));
inline constexpr auto simulated_programmable_layout = lay_out_device<simulated_programmable>();

class BootSimulation {
 public:
  BootSimulation();

  /// The existing slaves, and others.
  static BootPlan plan();

  Port master_port() { return world_.port(master_); }
  /// Powers the master; the slaves are powered already.
  void begin(Node& master);
  void run_for(Duration duration) { world_.run_for(duration); }
  Time now() const { return world_.now(); }

 private:
  struct Slave {
    Slave(const Port& port, NodeId id) : device(port, id), presets(device.node()) {}
    DeviceNode<simulated_slave_layout> device;
    Presets presets;
  };
  /// A flash in memory, until the command ends.
  struct MemoryFlash {
    static constexpr std::uint32_t size = 256;
    MemoryFlash();
    FlashState erase(std::uint32_t address);
    FlashState program(std::uint32_t address, std::span<const std::uint8_t> data);
    bool read(std::uint32_t address, std::span<std::uint8_t> data);
    std::array<std::uint8_t, size> bytes;
    Flash flash;
  };
  struct Programmable {
    Programmable(const Port& port, NodeId id, FlashError answer);
    FlashError check(std::uint8_t, const ProgramSlot&) { return answer; }
    FlashError answer;  ///< answer to each program
    MemoryFlash memory;
    std::array<ProgramSlot, 1> slots{{{.address = 0, .size = MemoryFlash::size}}};
    DeviceNode<simulated_programmable_layout> device;
    ProgramServer programs;
  };

  SlotIndex add(NodeId id, std::uint32_t vendor = 0x123);
  SlotIndex add_without_heartbeat(NodeId id);
  SlotIndex add_programmable(NodeId id, FlashError answer = FlashError::none);

  World world_;
  BusIndex bus_;
  SlotIndex master_;
  std::deque<Slave> slaves_;
  std::deque<Programmable> programmables_;
};

}  // namespace canvoy::tools
