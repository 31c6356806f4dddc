#include "canvoy/tools/network/boot_simulation.hpp"

#include <algorithm>
#include <string_view>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/tools/sheet/configuration_file.hpp"

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
constexpr NodeId horn = 11;
constexpr NodeId sensor = 12;
constexpr NodeId heater = 13;
constexpr NodeId cooler = 14;
constexpr NodeId mixer = 15;
constexpr NodeId brake = 16;
constexpr NodeId gripper = 17;
constexpr NodeId lift = 18;
constexpr NodeId drill = 19;
constexpr NodeId press = 20;
constexpr NodeId robot = 21;

constexpr std::string_view slaves[] = {
    "2:mandatory,name=display,vendor=0x123,product=7,heartbeat=500ms",
    "3:name=pump,vendor=0x123,heartbeat=500ms",
    "4:name=door,heartbeat=500ms",
    "5:name=lamp,heartbeat=500ms",
    "6:mandatory,name=valve,device=0xF0191,heartbeat=500ms",
    "7:mandatory,keep-alive,name=fan,heartbeat=500ms",
    "8:mandatory,name=scale,guard=200ms*3",
    "10:mandatory,name=motor,heartbeat=500ms",
    "11:name=horn,device=0x191",
    "12:name=sensor,product=8",
    "13:name=heater,revision=2",
    "14:name=cooler,serial=4711",
    "15:name=mixer,keep-alive,heartbeat=500ms",
    "16:name=brake,keep-alive,guard=200ms*3",
    "17:name=gripper,program-id=0xCBF43926",
    "18:name=lift,program-id=0xCBF43926",
    "19:name=drill,program-id=0xCBF43926,update",
    "20:name=press",
    "21:name=robot,program-id=0xCBF43926,update,configuration-date=2026-11-21 12:00:00",
};

/// Its CRC-32 is CBF43926h.
constexpr std::string_view program = "123456789";

SlavePlan& find(BootPlan& plan, NodeId id) {
  return *std::ranges::find(plan.slaves, id, &SlavePlan::id);
}

}  // namespace

BootPlan BootSimulation::plan() {
  BootPlan plan;
  for (const std::string_view slave : slaves) add_slave(plan, slave);
  const ConfigurationEntry heartbeat{object_index::heartbeat_producer, 0, {0x64, 0x00}};
  const ConfigurationEntry unknown{0x2000, 1, {0x01}};
  find(plan, press).concise_dcf = formats::concise_dcf_of({heartbeat, unknown});
  find(plan, robot).concise_dcf = formats::concise_dcf_of({heartbeat});
  find(plan, drill).program.assign(program.begin(), program.end());
  find(plan, robot).program.assign(program.begin(), program.end());
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
  for (const NodeId id : {horn, sensor, heater, cooler, gripper}) world_.start(add(id));
  world_.start(add_without_heartbeat(mixer));
  for (const NodeId id : {brake, lift, press, robot}) world_.start(add_programmable(id));
  world_.start(add_programmable(drill, FlashError::unknown_format));
  world_.run_for(1s);
  // The fan was operational before the master started.
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
  slave.presets.add(object_index::identity, 1, vendor);
  slave.presets.add(object_index::identity, 4, 1000U + id);
  world_.occupy(slot, slave.device.node());
  return slot;
}

SlotIndex BootSimulation::add_without_heartbeat(NodeId id) {
  const SlotIndex slot = add(id);
  slaves_.back().presets.add(object_index::heartbeat_producer, 0, 0);
  return slot;
}

SlotIndex BootSimulation::add_programmable(NodeId id, FlashError answer) {
  const SlotIndex slot = world_.add_slot(bus_);
  world_.occupy(slot, programmables_.emplace_back(world_.port(slot), id, answer).device.node());
  return slot;
}

void BootSimulation::begin(Node& master) {
  world_.occupy(master_, master);
  world_.start(master_);
}

BootSimulation::Programmable::Programmable(const Port& port, NodeId id, FlashError given)
    : answer(given),
      device(port, id),
      programs(device.node(), memory.flash, slots,
               {.control = {},
                .check = decltype(ProgramHooks::check)::to<&Programmable::check>(*this),
                .under_way = {}}) {}

BootSimulation::MemoryFlash::MemoryFlash()
    : flash{.sector_size = size,
            .erase = decltype(Flash::erase)::to<&MemoryFlash::erase>(*this),
            .program = decltype(Flash::program)::to<&MemoryFlash::program>(*this),
            .read = decltype(Flash::read)::to<&MemoryFlash::read>(*this),
            .poll = {},
            .sync = {}} {
  bytes.fill(0xFF);
}

FlashState BootSimulation::MemoryFlash::erase(std::uint32_t) {
  bytes.fill(0xFF);
  return FlashState::done;
}

FlashState BootSimulation::MemoryFlash::program(std::uint32_t address,
                                                std::span<const std::uint8_t> data) {
  std::ranges::copy(data, bytes.begin() + address);
  return FlashState::done;
}

bool BootSimulation::MemoryFlash::read(std::uint32_t address, std::span<std::uint8_t> data) {
  std::copy_n(bytes.begin() + address, data.size(), data.begin());
  return true;
}

}  // namespace canvoy::tools
