// A physical device of CiA 407: one or several virtual devices on one node, put together when the
// program runs, with what all of them owe the network: device types (1000h, 6000h, 67FFh), events,
// access by what each provides and consumes, the pre-defined PDOs of the minimum and the typical
// configuration (8.1.4.3), emergencies, heartbeat.
//
//     const BusUnit* units[] = {&bus_unit<TicketCancellerKind>, &bus_unit<AnnouncerKind>};
//     BusDevice device(units, port, 7, site);
//     device.node().start(now);
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/canopen/heap_node.hpp"
#include "canvoy/devices/cia407/file_shelf.hpp"
#include "canvoy/devices/cia407/virtual_devices.hpp"
#include "canvoy/devices/device.hpp"
#include "canvoy/devices/part_tables.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/profiles/cia407/configuration.hpp"
#include "canvoy/profiles/device_values.hpp"

namespace canvoy::cia407 {

/// The descriptions of a PDO that a unit adds to those of the profile (8.1.5). TPDOs 1 to 4 get the
/// CAN-ID of the pre-defined connection set of their node; others, and RPDOs, are not valid until
/// the network gives them one, but where the description has one (PdoInfo::cob_id).
struct OwnPdo {
  /// Segments of the network in which the unit has it.
  enum class Where : std::uint8_t { everywhere, with_main_computer, without_main_computer };

  const PdoInfo* info = nullptr;
  const ObjectInfo* parameter = nullptr;
  const ObjectInfo* mapping = nullptr;
  Where where = Where::everywhere;

  constexpr bool is_in(bool has_main_computer) const {
    return where == Where::everywhere || (where == Where::with_main_computer) == has_main_computer;
  }
};
template <const PdoInfo& pdo, OwnPdo::Where where = OwnPdo::Where::everywhere>
inline constexpr OwnPdo own_pdo = {
    .info = &pdo,
    .parameter = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::parameter,
    .mapping = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::mapping,
    .where = where};

/// One virtual device of a physical one (bus_kind.hpp makes it of a kind).
struct BusUnit {
  DeviceInfo info;
  const VirtualDeviceInfo* provides = nullptr;
  std::span<const OwnPdo> pdos = {};
  /// Of arrays, where it has another number of entries, or of bytes in them, than usual.
  std::span<const WantedObject> sizes = {};
  std::size_t routes = 0;  ///< CAN-IDs that it listens to
  std::size_t bytes = 0;   ///< of memory that make() wants
  void (*make)(void* memory, VirtualDevice& device, const Site& site) = nullptr;
  void (*end)(void* memory) = nullptr;
};

/// What a unit provides that is no virtual device but the application of one: nothing. It comes
/// behind the virtual devices of its physical one.
inline constexpr VirtualDeviceInfo application = {.name = "application"};

/// What a device is to know of its segment of the network when it is put together (footnotes of
/// 6.2, 6.3 and 6.10).
struct BusSegment {
  Configuration configuration = Configuration::typical;
  bool has_main_computer = true;  ///< or an identification device
  bool has_diagnostics = true;
  /// 6196h to 6198h: provided by the identification device, and not by the main on-board computer.
  bool identification_provides_texts = false;
};

/// The objects of such a device, sorted: what a unit provides goes before what another consumes.
std::vector<Part> bus_parts(std::span<const BusUnit* const> units, const BusSegment& segment = {});

class BusDevice : public FoundValues<BusDevice> {
 public:
  /// `port`'s context, and what `site` offers, must outlive this. The site may offer a BusSegment.
  /// It is told of the VirtualDevices, and then of each unit.
  BusDevice(std::span<const BusUnit* const> units, const Port& port, NodeId node_id,
            const Site& site);
  ~BusDevice();
  BusDevice(const BusDevice&) = delete;
  BusDevice& operator=(const BusDevice&) = delete;

  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// What the units that it is made of leave it without: see HeapNode.
  MissingEntry missing() const { return device_.missing(); }
  /// `number` counts from 1 on.
  VirtualDevice& virtual_device(unsigned number) { return virtual_devices_[number - 1]; }
  /// What others wrote last to a file of which the units do nothing (6720h, 6741h): nobody has, and
  /// it is empty. It holds until it is written. Units learn of it as of other objects.
  std::span<const std::uint8_t> taken_file(std::uint16_t index);

 private:
  struct Made {
    const BusUnit* kind;
    std::unique_ptr<std::byte[]> memory;
  };
  /// As much as a diagnostics device has, whose file is the longest.
  struct TakenFile {
    TakenFile(VirtualDevice& device, std::uint16_t object) : index(object), file(device, object) {}
    std::uint16_t index;            ///< of the object
    FileShelfOf<1, 16384, 0> file;  ///< what was written to it last
  };

  void take_files(std::span<const Part> parts);
  void file_taken(const Entry& entry) { node().dictionary().announce(entry, Source::sdo); }

  /// Their timers may be armed to the end: the memory goes after the node.
  std::vector<Made> units_;
  PartTables tables_;
  HeapNode device_;
  VirtualDevices all_;
  std::deque<VirtualDevice> virtual_devices_;
  std::deque<TakenFile> taken_files_;
};

}  // namespace canvoy::cia407
