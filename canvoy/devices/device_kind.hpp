// A kind of device as one row of the catalogue: what is known of it, and how one is built. The
// templates of a device are instantiated where its row is made, in one source, and nowhere else.
//
//     const DeviceKind light_barrier = {.info = LightBarrierKind<>::info, .profile = &profile,
//                                       .forms = forms_of_doors<LightBarrierKind>};
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/device.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy {

/// A device that was made in somebody's memory.
struct MadeDevice {
  Node* node = nullptr;
  EmergencyProducer* emergencies = nullptr;
};

/// One way to build a kind of device: a dictionary, and a type that has it.
struct DeviceForm {
  std::span<const Part> (*parts)();  ///< its objects, sorted
  std::size_t bytes;                 ///< of memory that make() wants, aligned for any type
  /// `port`'s context, `site` and what it offers must outlive the device.
  MadeDevice (*make)(void* memory, const Port& port, NodeId node_id, const Site& site);
  void (*end)(void* memory);
};

namespace cia407 {
struct BusUnit;
}
namespace cia447 {
struct CarUnit;
}

struct DeviceKind {
  DeviceInfo info;
  const Profile* profile = nullptr;
  /// One; or four, for doors 1 to 4.
  std::span<const DeviceForm> forms;
  /// The same with the objects of storage; empty: it keeps nothing.
  std::span<const DeviceForm> keeping_forms = {};
  bool answers_lss = true;
  /// As one of several virtual devices of one node; both null: it is alone on its node.
  const cia447::CarUnit* car_unit = nullptr;
  const cia407::BusUnit* bus_unit = nullptr;
  std::span<const NodeId> node_ids_of_doors = {};  ///< empty: the usual one for all

  const DeviceForm& form(const Site& site) const {
    const std::span<const DeviceForm> all = site.keeps_parameters ? keeping_forms : forms;
    return all[site.door <= all.size() ? site.door - 1 : 0];
  }
  NodeId node_id(const Site& site) const {
    const bool is_by_door = site.door <= node_ids_of_doors.size();
    return is_by_door ? node_ids_of_doors[site.door - 1] : info.node_id;
  }
};

/// CAN-IDs that who puts a device of the catalogue on a bus may listen to with its node.
inline constexpr std::size_t catalogue_routes = LssSlave::routes + 4;
/// Of the objects by which it keeps its parameters: all, those of communication, those of the
/// application.
inline constexpr unsigned storage_groups = 3;

/// A device with what its site offers.
template <class Kind, const auto& layout = layout_of<Kind>>
class SitedDevice {
 public:
  SitedDevice(const Port& port, NodeId node_id, const Site& site)
      : device_(made(port, node_id, site)) {
    site.made<typename Kind::Unit>(device_.unit(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  using Made = Device<Kind, layout, catalogue_routes>;

  static Made made(const Port& port, NodeId node_id, const Site& site) {
    if constexpr (std::is_same_v<typename Kind::Hardware, NoHardware>) {
      return Made(port, node_id, settings(site));
    } else {
      return Made(port, node_id, hardware(site), settings(site));
    }
  }
  /// A kind may take it from several offers, and simulate it where nobody offers any.
  static typename Kind::Hardware hardware(const Site& site) {
    if constexpr (requires { Kind::hardware(site); }) {
      return Kind::hardware(site);
    } else if constexpr (requires { Kind::simulated(); }) {
      return site.find<typename Kind::Hardware>(Kind::simulated());
    } else {
      return site.find<typename Kind::Hardware>();
    }
  }
  static typename Kind::Settings settings(const Site& site) {
    if constexpr (requires { Kind::settings(site); }) {
      return Kind::settings(site);
    } else {
      return site.find<typename Kind::Settings>();
    }
  }

  Made device_;
};

/// The form of `Made`, which is constructed of a port, a node-ID and a site.
template <class Made, const auto& description>
inline constexpr DeviceForm form_of = {
    .parts = [] { return std::span<const Part>(description.begin(), description.size()); },
    .bytes = sizeof(Made),
    .make = [](void* memory, const Port& port, NodeId node_id, const Site& site) -> MadeDevice {
      static_assert(alignof(Made) <= alignof(std::max_align_t));
      Made* const made = std::construct_at(static_cast<Made*>(memory), port, node_id, site);
      return {&made->node(), &made->emergency_producer()};
    },
    .end = [](void* memory) { std::destroy_at(static_cast<Made*>(memory)); }};

/// A kind with the objects of storage.
template <class Kind>
struct Keeping : Kind {
  static constexpr auto description = describe(Kind::description, cia301::storage(storage_groups));
};

template <class Kind>
inline constexpr DeviceForm only_form[1] = {form_of<SitedDevice<Kind>, Kind::description>};
template <class Kind>
inline constexpr DeviceForm keeping_form[1] = {
    form_of<SitedDevice<Keeping<Kind>>, Keeping<Kind>::description>};

}  // namespace canvoy
