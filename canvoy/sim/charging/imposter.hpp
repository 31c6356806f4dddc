// A second battery module that was given the node-ID of the first.
#pragma once

#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/sim/plants/battery.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

/// Half full, and nothing is connected to it: its values are not those of the battery that is
/// charged.
struct Imposter {
  static constexpr double state_of_charge = 0.5;

  Imposter(World& world, BusIndex bus, NodeId id, const BatteryDesign& design,
           const cia418::BatterySettings& settings, double ambience_celsius)
      : slot(world.add_slot(bus)),
        plant(design, state_of_charge, ambience_celsius),
        device(world.port(slot), id, plant.hardware(), settings) {
    world.occupy(slot, device.node());
  }

  SlotIndex slot;
  BatteryPlant plant;
  cia418::BatteryDevice<> device;
};

}  // namespace canvoy
