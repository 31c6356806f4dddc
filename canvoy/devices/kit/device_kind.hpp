// A kind of device as one row of the catalogue: its description, and how to build it. The templates
// of a device are instantiated only in the source that makes its row.
//
//     const DeviceKind light_barrier = {.info = cia417::LightBarrierKind<>::info,
//                                       .profile = &cia417::profile,
//                                       .forms = cia417::forms_of_doors<cia417::LightBarrierKind>};
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy {

/// A device constructed in the caller's memory.
struct MadeDevice {
  Node* node = nullptr;                      ///< valid as long as the memory
  EmergencyProducer* emergencies = nullptr;  ///< valid as long as the memory
};

/// One way to build a kind of device: a dictionary, and a type with that dictionary.
struct DeviceForm {
  std::span<const Part> (*parts)();  ///< its objects, sorted
  std::size_t bytes;                 ///< of memory for make(), aligned for any type
  /// The context of `port`, `environment` and its offers must outlive the device.
  MadeDevice (*make)(void* memory, const Port& port, NodeId node_id,
                     const Environment& environment);
  void (*end)(void* memory);  ///< destroys the device; the memory stays
};

namespace cia407 {
struct BusUnit;
}
namespace cia447 {
struct CarUnit;
}

struct DeviceKind {
  DeviceInfo info;                   ///< for users
  const Profile* profile = nullptr;  ///< null: none
  /// One form; or four, for doors 1 to 4.
  std::span<const DeviceForm> forms;
  /// Forms with the objects of storage; empty: it keeps nothing.
  std::span<const DeviceForm> keeping_forms = {};
  bool answers_lss = true;  ///< an LSS slave may be added
  /// For use as one of several virtual devices of one node; both null: it is alone on its node.
  const cia447::CarUnit* car_unit = nullptr;
  const cia407::BusUnit* bus_unit = nullptr;       ///< of CiA 407; see car_unit
  std::span<const NodeId> node_ids_of_doors = {};  ///< empty: the default for all

  /// The form for a door and for storage; the first one where there is no choice.
  const DeviceForm& form(const Environment& environment) const {
    const std::span<const DeviceForm> all = environment.keeps_parameters ? keeping_forms : forms;
    return all[environment.door <= all.size() ? environment.door - 1 : 0];
  }
  /// Default node-ID in this environment, by the door.
  NodeId node_id(const Environment& environment) const {
    const bool is_by_door = environment.door <= node_ids_of_doors.size();
    return is_by_door ? node_ids_of_doors[environment.door - 1] : info.node_id;
  }
};

/// Number of further CAN-IDs that the owner of a device of the catalogue may receive with its node.
inline constexpr std::size_t catalogue_routes = LssSlave::routes + 4;
/// Number of groups of kept parameters: all, those of communication, those of the application.
inline constexpr unsigned storage_groups = 3;

/// A device with the offers of its environment.
template <class Kind, const auto& layout = layout_of<Kind>>
class PlacedDevice {
 public:
  /// Makes the device with what the environment offers, and tells its watchers.
  PlacedDevice(const Port& port, NodeId node_id, const Environment& environment)
      : device_(made(port, node_id, environment)) {
    environment.made<typename Kind::Unit>(device_.unit(), device_.node());
  }
  /// The node of the device.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  using Made = Device<Kind, layout, catalogue_routes>;

  static Made made(const Port& port, NodeId node_id, const Environment& environment) {
    if constexpr (std::is_same_v<typename Kind::Hardware, NoHardware>) {
      return Made(port, node_id, settings(environment));
    } else {
      return Made(port, node_id, hardware(environment), settings(environment));
    }
  }
  /// A kind may combine several offers, and simulate missing hardware.
  static typename Kind::Hardware hardware(const Environment& environment) {
    if constexpr (requires { Kind::hardware(environment); }) {
      return Kind::hardware(environment);
    } else if constexpr (requires { Kind::simulated(); }) {
      return environment.get<typename Kind::Hardware>(Kind::simulated());
    } else {
      return environment.get<typename Kind::Hardware>();
    }
  }
  static typename Kind::Settings settings(const Environment& environment) {
    if constexpr (requires { Kind::settings(environment); }) {
      return Kind::settings(environment);
    } else {
      return environment.get<typename Kind::Settings>();
    }
  }

  Made device_;
};

/// The form of `Made`, which is constructed with a port, a node-ID and an environment.
template <class Made, const auto& description>
inline constexpr DeviceForm form_of = {
    .parts = [] { return std::span<const Part>(description.begin(), description.size()); },
    .bytes = sizeof(Made),
    .make = [](void* memory, const Port& port, NodeId node_id,
               const Environment& environment) -> MadeDevice {
      static_assert(alignof(Made) <= alignof(std::max_align_t));
      Made* const made = std::construct_at(static_cast<Made*>(memory), port, node_id, environment);
      return {&made->node(), &made->emergency_producer()};
    },
    .end = [](void* memory) { std::destroy_at(static_cast<Made*>(memory)); }};

/// A kind with the objects of storage.
template <class Kind>
struct WithStorage : Kind {
  /// The objects of the kind, and 1010h and 1011h.
  static constexpr auto description = describe(Kind::description, cia301::storage(storage_groups));
};

/// The forms of a kind of which there is one for all doors.
template <class Kind>
inline constexpr DeviceForm only_form[1] = {form_of<PlacedDevice<Kind>, Kind::description>};
/// The same with the objects of storage.
template <class Kind>
inline constexpr DeviceForm form_with_storage[1] = {
    form_of<PlacedDevice<WithStorage<Kind>>, WithStorage<Kind>::description>};

}  // namespace canvoy
