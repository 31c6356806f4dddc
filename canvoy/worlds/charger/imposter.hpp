// A second battery module at the same battery, with the node-ID of the first: a spare part that was
// put in without removing the old one.
#pragma once

#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::charger {

/// On the cable from the start, without power until World::start(slot).
struct Imposter {
  /// Puts it on the bus.
  Imposter(World& world, BusIndex bus, NodeId id, const cia418::BatteryHardware& hardware,
           const cia418::BatterySettings& settings)
      : slot(world.add_slot(bus)), device(world.port(slot), id, hardware, settings) {
    world.occupy(slot, device.node());
  }

  SlotIndex slot;                  ///< on the bus
  cia418::BatteryDevice<> device;  ///< the module
};

}  // namespace canvoy::charger
