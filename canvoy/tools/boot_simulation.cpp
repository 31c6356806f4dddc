#include "canvoy/tools/boot_simulation.hpp"

namespace canvoy::tools {

namespace {

constexpr NodeId display = 2;
constexpr NodeId pump = 3;
constexpr NodeId lamp = 5;
constexpr NodeId valve = 6;
constexpr NodeId fan = 7;
constexpr NodeId scale = 8;
constexpr NodeId stranger = 9;
constexpr NodeId motor = 10;

}  // namespace

BootPlan BootSimulation::plan() {
  BootPlan plan;
  for (const char* slave :
       {"2:mandatory,name=display,vendor=0x123,product=7,heartbeat=500ms",
        "3:name=pump,vendor=0x123,heartbeat=500ms", "4:name=door,heartbeat=500ms",
        "5:name=lamp,heartbeat=500ms", "6:mandatory,name=valve,device=0xF0191,heartbeat=500ms",
        "7:mandatory,keep-alive,name=fan,heartbeat=500ms", "8:mandatory,name=scale,guard=200ms*3",
        "10:mandatory,name=motor,heartbeat=500ms"}) {
    add_slave(plan, slave);
  }
  return plan;
}

BootSimulation::BootSimulation()
    : bus_(world_.add_bus({.bit_rate = 125'000})), master_(world_.add_slot(bus_)) {
  world_.start(add(display));
  world_.start(add(pump, 0x124));
  world_.start(add_without_heartbeat(lamp));
  world_.start(add(fan));
  world_.start(add_without_heartbeat(scale));
  const SlotIndex restarting = add(valve);
  world_.start(restarting);
  const SlotIndex late = add(motor);
  const SlotIndex unknown = add(stranger);
  world_.run_for(1s);
  // The fan has worked since before the master came.
  slaves_[3].device.node().command(NmtCommand::start);
  world_.at(Time(1100ms), [this, restarting](Time) {
    world_.stop(restarting);
    world_.start(restarting);
  });
  world_.at(Time(1500ms), [this, unknown](Time) { world_.start(unknown); });
  world_.at(Time(3700ms), [this, late](Time) { world_.start(late); });
}

SlotIndex BootSimulation::add(NodeId id, std::uint32_t vendor) {
  const SlotIndex slot = world_.add_slot(bus_);
  Slave& slave = slaves_.emplace_back(world_.port(slot), id);
  slave.presets.add(0x1018, 1, vendor);
  slave.presets.add(0x1018, 4, 1000U + id);
  world_.occupy(slot, slave.device.node());
  return slot;
}

SlotIndex BootSimulation::add_without_heartbeat(NodeId id) {
  const SlotIndex slot = add(id);
  slaves_.back().presets.add(0x1017, 0, 0);
  return slot;
}

void BootSimulation::begin(Node& master) {
  world_.occupy(master_, master);
  world_.start(master_);
}

}  // namespace canvoy::tools
