// The devices that `canvoy device` runs and `canvoy eds export` describes, by the same names: those
// of the catalogue, and the bootloader.
//
//     const DeviceKind& kind = parse_device_kind("lift-load");
//     print_device_list(true);   // canvoy device --list --json
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/catalogue.hpp"

namespace canvoy::tools {

/// The kind with the description of Bootloader.
extern const DeviceKind bootloader_kind;

std::vector<const DeviceKind*> all_device_kinds();
/// The kind with this name; null: none.
const DeviceKind* find_any_device_kind(std::string_view name);
std::vector<std::string> all_device_names();

/// The virtual devices of one physical device, all of CiA 447 or all of CiA 407.
struct SharedNode {
  std::vector<const cia447::CarUnit*> car{};
  std::vector<const cia407::BusUnit*> bus{};

  bool empty() const { return car.empty() && bus.empty(); }
};
/// Reads `taximeter+printer`, `ticket-canceller+acoustic-announcer`. Empty if the name has no `+`;
/// throws UsageError if one of them cannot share a node with the first.
SharedNode parse_shared_node(std::string_view names);

/// Names of the virtual devices of the profile that the kind consists of.
std::vector<std::string_view> virtual_devices_of(const DeviceKind& kind);
/// Prints the catalogue: one line or one JSON object for each device.
void print_device_list(bool json);
/// The catalogue as a Markdown table, for docs/devices.md.
std::string device_table();

}  // namespace canvoy::tools
