// A physical device of CiA 407: one or several virtual devices on one node, composed at run time,
// with their common duties in the network: device types (1000h, 6000h, 67FFh), events, access for
// providers and consumers, the pre-defined PDOs of the minimum and the typical configuration
// (8.1.4.3), emergencies, heartbeat.
//
//     const BusUnit* units[] = {&bus_unit<TicketCancellerKind>, &bus_unit<AnnouncerKind>};
//     BusDevice device(units, port, 7, environment);
//     device.node().start(now);
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/devices/cia407/kit/file_shelf.hpp"
#include "canvoy/devices/cia407/kit/network_start.hpp"
#include "canvoy/devices/cia407/kit/virtual_devices.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/devices/kit/part_tables.hpp"
#include "canvoy/profiles/cia407/configuration.hpp"
#include "canvoy/profiles/model/device_values.hpp"

namespace canvoy::cia407 {

/// The descriptions of a PDO that a unit adds to those of the profile (8.1.5). TPDOs 1 to 4 get the
/// CAN-ID of the pre-defined connection set of their node. Others, and RPDOs, are invalid until the
/// network assigns one, unless the description has one (PdoInfo::cob_id).
struct OwnPdo {
  /// Segments of the network in which the unit has the PDO.
  enum class Where : std::uint8_t { everywhere, with_main_computer, without_main_computer };

  /// Mapping, direction and CAN-ID.
  const PdoInfo* info = nullptr;
  const ObjectInfo* parameter = nullptr;  ///< communication record
  const ObjectInfo* mapping = nullptr;    ///< mapping record
  Where where = Where::everywhere;        ///< segments of the network

  /// True if the unit has the PDO in a segment with, or without, a main on-board computer.
  constexpr bool is_in(bool has_main_computer) const {
    return where == Where::everywhere || (where == Where::with_main_computer) == has_main_computer;
  }
};
/// Both records of a PDO.
template <const PdoInfo& pdo, OwnPdo::Where where = OwnPdo::Where::everywhere>
inline constexpr OwnPdo own_pdo = {
    .info = &pdo,
    .parameter = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::parameter,
    .mapping = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::mapping,
    .where = where};

/// One virtual device of a physical one (bus_kind.hpp makes it of a kind).
struct BusUnit {
  DeviceInfo info;  ///< as in the catalogue
  /// The virtual device, with its objects and events; or `application`.
  const VirtualDeviceInfo* provides = nullptr;
  std::span<const OwnPdo> pdos = {};  ///< that the unit adds to those of the profile
  /// Numbers of entries of arrays, or of bytes in them, where they differ from the usual ones.
  std::span<const WantedObject> sizes = {};
  std::size_t routes = 0;  ///< CAN-IDs that it receives
  std::size_t bytes = 0;   ///< of memory for make()
  /// Constructs the unit.
  void (*make)(void* memory, VirtualDevice& device, const Environment& environment) = nullptr;
  void (*end)(void* memory) = nullptr;  ///< destroys it; the memory stays
};

/// For a unit that is the application of a virtual device, and provides nothing itself. It is
/// behind the virtual devices of its physical device.
inline constexpr VirtualDeviceInfo application = {.name = "application"};

/// Segment of the network, for the composition of a device (footnotes of 6.2, 6.3 and 6.10).
struct BusSegment {
  Configuration configuration = Configuration::typical;  ///< minimum or typical, 8.1.4.3
  bool has_main_computer = true;                         ///< or an identification device
  bool has_diagnostics = true;                           ///< a diagnostics device
  /// 6196h to 6198h are provided by the identification device instead of the main on-board
  /// computer.
  bool identification_provides_texts = false;
  /// A main on-board computer, or else a train bus gateway, is the NMT master of the segment and
  /// starts the others (8.1.4.3 leaves the choice open).
  bool is_started_by_first = false;
};

/// The objects of such a device, sorted. An object of a provider has priority over that of a
/// consumer.
std::vector<Part> bus_parts(std::span<const BusUnit* const> units, const BusSegment& segment = {});

class BusDevice : public FoundValues<BusDevice> {
 public:
  /// The context of `port`, and the offers of `environment`, must outlive this. The environment may
  /// offer a BusSegment. The VirtualDevices are offered to it, and then each unit.
  BusDevice(std::span<const BusUnit* const> units, const Port& port, NodeId node_id,
            const Environment& environment);
  ~BusDevice();
  BusDevice(const BusDevice&) = delete;
  BusDevice& operator=(const BusDevice&) = delete;

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
  struct Made {
    const BusUnit* kind;
    std::unique_ptr<std::byte[]> memory;
  };
  /// As large as in a diagnostics device, which has the longest file.
  struct TakenFile {
    TakenFile(VirtualDevice& device, std::uint16_t object) : index(object), file(device, object) {}
    std::uint16_t index;            ///< of the object
    FileShelfOf<1, 16384, 0> file;  ///< its last contents
  };

  void take_files(std::span<const Part> parts);
  void file_taken(const Entry& entry) { node().dictionary().announce(entry, Source::sdo); }

  /// Their timers may be armed until the end: the memory is released after the node.
  std::vector<Made> units_;
  PartTables tables_;
  std::unique_ptr<NetworkStart> start_;  ///< null: does not start other nodes
  HeapNode device_;
  VirtualDevices all_;
  std::deque<VirtualDevice> virtual_devices_;
  std::deque<TakenFile> taken_files_;
};

}  // namespace canvoy::cia407
