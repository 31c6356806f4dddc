// A physical device of CiA 447: one or several virtual devices on one node, composed at run time,
// with their common duties in the network: names, heartbeat, emergencies, SDO servers for 16
// clients, pre-defined PDOs, sleep.
//
//     const CarUnit* units[] = {&car_unit<TaximeterKind>, &car_unit<PrinterKind>};
//     CarDevice device(units, port, 5, environment);
//     device.node().start(now);
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/devices/cia447/kit/car_master.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/kit/car_parts.hpp"
#include "canvoy/devices/cia447/kit/car_sleep.hpp"
#include "canvoy/devices/kit/part_tables.hpp"

namespace canvoy::cia447 {

/// The objects of such a device, sorted. An object of a provider has priority over that of a
/// consumer.
std::vector<Part> car_parts(std::span<const CarUnit* const> units,
                            Duration heartbeat = CarNetworkSettings{}.heartbeat);

class CarDevice : public FoundValues<CarDevice> {
 public:
  /// The context of `port`, and the offers of `environment`, must outlive this. The environment may
  /// offer CarNetworkSettings and CarSleepSettings; for the gateway, which is the master of the
  /// network unless the environment says otherwise, CarMemory and CarMasterSettings. The CarNetwork
  /// is offered to it, and then each unit.
  CarDevice(std::span<const CarUnit* const> units, const Port& port, NodeId node_id,
            const Environment& environment);
  ~CarDevice() { units_.end(); }

  /// See car_parts(): with the default heartbeat.
  static std::vector<Part> parts_of(std::span<const CarUnit* const> units) {
    return car_parts(units);
  }
  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Entry that the units need and the device does not have: see HeapNode.
  MissingEntry missing() const { return device_.missing(); }
  /// Common duties in the network of the car.
  CarNetwork& network() { return network_; }
  /// Sleep and wake-up.
  CarSleep& sleep() { return sleep_; }
  /// The Kind::Unit of one of its kinds; null if it does not have that kind.
  void* unit(const CarUnit& kind) { return units_.find(kind); }
  /// Null if it is not the gateway.
  CarMaster* master() { return master_ ? &*master_ : nullptr; }

 private:
  UnitsOnHeap<CarUnit> units_;
  MutedPort port_;
  PartTables tables_;
  HeapNode device_;
  CarNetwork network_;
  CarSleep sleep_;
  std::optional<CarMaster> master_;
};

}  // namespace canvoy::cia447
