// All devices of the project, each with the simulated hardware of its kind, for tests of rules that
// apply to every device.
//
//     for (const DeviceKind* kind : every_device_kind()) {
//       Cable cable;
//       DeviceOfKind device(cable.port(0), *kind);
//       cable.connect(0, device.node());
//     }
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy {

/// The devices of the catalogue, and the half of a lift controller on the bus of its group.
inline std::vector<const DeviceKind*> every_device_kind() {
  std::vector<const DeviceKind*> all(device_catalogue().begin(), device_catalogue().end());
  all.push_back(&cia417::group_member_kind);
  return all;
}

/// Its name, in the form that GoogleTest requires of a parameter.
inline std::string test_name(const DeviceKind& kind) {
  std::string name(kind.info.name);
  std::ranges::replace(name, '-', '_');
  return name;
}

/// A device with its default node-ID, in a lift of four floors.
class DeviceOfKind {
 public:
  DeviceOfKind(const Port& port, const DeviceKind& kind)
      : device_(kind, port, kind.node_id(environment_), environment_) {}
  Node& node() { return device_.node(); }

 private:
  struct FourFloors : Environment {
    FourFloors() { floors = 4; }
  };

  FourFloors environment_;
  CatalogueDevice device_;
};

}  // namespace canvoy
