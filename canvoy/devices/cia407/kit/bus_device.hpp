// A physical device of CiA 407: one or several virtual devices on one node, composed at run time,
// with their common duties in the network: device types (1000h, 6000h, 67FFh), events, access for
// providers and consumers, the pre-defined PDOs of the minimum and the typical configuration
// (8.1.4.3), emergencies, heartbeat.
//
//     const BusUnit* units[] = {&bus_unit<TicketCancellerKind>, &bus_unit<AnnouncerKind>};
//     BusDevice device(units, port, 7, environment);
//     device.node().start(now);
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/devices/cia407/kit/bus_parts.hpp"
#include "canvoy/devices/cia407/kit/file_shelf.hpp"
#include "canvoy/devices/cia407/kit/network_start.hpp"
#include "canvoy/devices/cia407/kit/virtual_devices.hpp"
#include "canvoy/devices/kit/composed_device.hpp"
#include "canvoy/devices/kit/part_tables.hpp"
#include "canvoy/profiles/cia407/configuration.hpp"
#include "canvoy/profiles/model/device_values.hpp"

namespace canvoy::cia407 {

/// The objects of such a device, sorted. An object of a provider has priority over that of a
/// consumer.
std::vector<Part> bus_parts(std::span<const BusUnit* const> units, const BusSegment& segment = {});

class BusDevice : public FoundValues<BusDevice> {
 public:
  /// The context of `port`, and the offers of `environment`, must outlive this. The environment may
  /// offer a BusSegment. The VirtualDevices are offered to it, and then each unit.
  BusDevice(std::span<const BusUnit* const> units, const Port& port, NodeId node_id,
            const Environment& environment);
  ~BusDevice() { units_.end(); }

  /// See bus_parts(): in the usual segment.
  static std::vector<Part> parts_of(std::span<const BusUnit* const> units) {
    return bus_parts(units);
  }
  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Entry that the units need and the device does not have: see HeapNode.
  MissingEntry missing() const { return device_.missing(); }
  /// `number` counts from 1.
  VirtualDevice& virtual_device(unsigned number) { return virtual_devices_[number - 1]; }
  /// The last contents that other devices wrote to a file that the units do not use (6720h, 6741h);
  /// empty if there are none. Valid until the next write. Units are notified as for other objects.
  std::span<const std::uint8_t> taken_file(std::uint16_t index);

 private:
  /// As large as in a diagnostics device, which has the longest file.
  struct TakenFile {
    TakenFile(VirtualDevice& device, std::uint16_t object) : index(object), file(device, object) {}
    std::uint16_t index;            ///< of the object
    FileShelfOf<1, 16384, 0> file;  ///< its last contents
  };

  void take_files(std::span<const Part> parts);
  void file_taken(const Entry& entry) { node().dictionary().announce(entry, Source::sdo); }

  UnitsOnHeap<BusUnit> units_;
  PartTables tables_;
  std::unique_ptr<NetworkStart> start_;  ///< null: does not start other nodes
  HeapNode device_;
  VirtualDevices all_;
  std::deque<VirtualDevice> virtual_devices_;
  std::deque<TakenFile> taken_files_;
};

}  // namespace canvoy::cia407
