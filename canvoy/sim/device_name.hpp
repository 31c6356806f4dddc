// Name of a simulated device: its virtual devices, as the catalogue names them.
//
//     device_name<cia447::CarUnit>(units, no_virtual_device);  // `gps+navigation`
#pragma once

#include <span>
#include <string>

#include "canvoy/profiles/model/virtual_device.hpp"

namespace canvoy {

/// Joins the names of the units with `+`. Units that provide `application` have no name for others,
/// and are left out.
template <class Unit>
std::string device_name(std::span<const Unit* const> units, const VirtualDeviceInfo& application) {
  std::string name;
  for (const Unit* unit : units) {
    if (unit->provides == &application) continue;
    if (!name.empty()) name += '+';
    name += unit->info.name;
  }
  return name;
}

}  // namespace canvoy
