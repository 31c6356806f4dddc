// A physical device of CiA 447: one or several virtual devices on one node, put together when the
// program runs, with what all of them owe the network: names, heartbeat, emergencies, SDO servers
// for 16 clients, pre-defined PDOs, sleep.
//
//     const CarUnit* units[] = {&car_unit<TaximeterKind>, &car_unit<PrinterKind>};
//     CarDevice device(units, port, 5, site);
//     device.node().start(now);
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "canvoy/canopen/heap_node.hpp"
#include "canvoy/devices/cia447/car_master.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/car_sleep.hpp"
#include "canvoy/devices/device.hpp"
#include "canvoy/devices/part_tables.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/profiles/virtual_device.hpp"

namespace canvoy::cia447 {

/// One virtual device of a physical one (car_kind.hpp makes it of a kind).
struct CarUnit {
  DeviceInfo info;
  const VirtualDeviceInfo* provides = nullptr;
  std::span<const ObjectInfo* const> consumes = {};
  std::span<const ObjectInfo* const> own = {};  ///< of the manufacturer's area
  std::size_t bytes = 0;                        ///< of memory that make() wants
  void (*make)(void* memory, CarNetwork& network, const Site& site) = nullptr;
  void (*end)(void* memory) = nullptr;
};

/// The objects of such a device, sorted: what a unit provides goes before what another consumes.
std::vector<Part> car_parts(std::span<const CarUnit* const> units,
                            Duration heartbeat = CarNetworkSettings{}.heartbeat);

class CarDevice : public FoundValues<CarDevice> {
 public:
  /// `port`'s context, and what `site` offers, must outlive this. The site may offer
  /// CarNetworkSettings and CarSleepSettings; for the gateway, which is the master of the network
  /// unless the site says otherwise, CarMemory and CarMasterSettings. It is told of the CarNetwork,
  /// and then of each unit.
  CarDevice(std::span<const CarUnit* const> units, const Port& port, NodeId node_id,
            const Site& site);
  ~CarDevice();
  CarDevice(const CarDevice&) = delete;
  CarDevice& operator=(const CarDevice&) = delete;

  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// What the units that it is made of leave it without: see HeapNode.
  MissingEntry missing() const { return device_.missing(); }
  CarNetwork& network() { return network_; }
  CarSleep& sleep() { return sleep_; }
  /// Null where it is not the gateway.
  CarMaster* master() { return master_ ? &*master_ : nullptr; }

 private:
  struct Made {
    const CarUnit* kind;
    std::unique_ptr<std::byte[]> memory;
  };

  /// Their timers may be armed to the end: the memory goes after the node.
  std::vector<Made> units_;
  MutedPort port_;
  PartTables tables_;
  HeapNode device_;
  CarNetwork network_;
  CarSleep sleep_;
  std::optional<CarMaster> master_;
};

}  // namespace canvoy::cia447
