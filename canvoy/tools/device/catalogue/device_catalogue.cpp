#include "canvoy/tools/device/catalogue/device_catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/catalogue/bootloader.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint16_t device_types_index = 0x6000;

constexpr DeviceForm bootloader_forms[] = {{.parts =
                                                [] {
                                                  return std::span<const Part>(
                                                      bootloader_description.begin(),
                                                      bootloader_description.size());
                                                },
                                            .bytes = 0,
                                            .make = nullptr,
                                            .end = nullptr}};

const Part* find_part(const DeviceKind& kind, std::uint16_t index) {
  const std::span<const Part> parts = kind.forms.front().parts();
  const auto found = std::ranges::find(parts, index, [](const Part& part) { return part.index(); });
  return found == parts.end() ? nullptr : &*found;
}

std::uint32_t initial_value(const Part& part, const EntryInfo& entry) {
  return static_cast<std::uint32_t>(canvoy::detail::initial_of(part, entry).number);
}

/// Values of 1000h of the device; for several virtual devices those of 6000h, which has the high
/// words.
std::vector<std::uint32_t> device_types(const DeviceKind& kind) {
  std::vector<std::uint32_t> types;
  const Part* own = find_part(kind, object_index::device_type);
  if (own == nullptr) return types;
  types.push_back(initial_value(*own, own->object().entry));
  const Part* several = find_part(kind, device_types_index);
  if (several == nullptr || kind.profile->device_type_of == nullptr) return types;
  for (const EntryInfo& entry : several->object().entries()) {
    if (entry.sub_first == 0 || !several->has(entry)) continue;
    types.push_back(initial_value(*several, entry) << 16 | kind.profile->number);
  }
  return types;
}

}  // namespace

const DeviceKind bootloader_kind = {.info = {.name = "bootloader",
                                             .title = "takes a program, and does nothing else",
                                             .product = "Canvoy bootloader",
                                             .product_code = 302,
                                             .node_id = 20,
                                             .hardware = "a flash memory for the program"},
                                    .profile = &cia301::profile,
                                    .forms = bootloader_forms,
                                    .keeping_forms = bootloader_forms,
                                    .answers_lss = false};

std::vector<const DeviceKind*> all_device_kinds() {
  const std::span<const DeviceKind* const> catalogue = device_catalogue();
  std::vector<const DeviceKind*> all(catalogue.begin(), catalogue.end());
  all.push_back(&bootloader_kind);
  return all;
}

const DeviceKind* find_any_device_kind(std::string_view name) {
  return name == bootloader_kind.info.name ? &bootloader_kind : find_device_kind(name);
}

std::vector<std::string> all_device_names() {
  std::vector<std::string> names;
  for (const DeviceKind* kind : all_device_kinds()) names.emplace_back(kind->info.name);
  return names;
}

namespace {

/// Adds one more, which must differ from all others.
template <class Unit>
void add_unit(std::vector<const Unit*>& units, const Unit* unit, std::string_view profile,
              std::string_view names, std::string_view name) {
  if (unit == nullptr) {
    throw UsageError(fmt::format("'{}': '{}' is no virtual device of {}", names, name, profile));
  }
  if (std::ranges::find(units, unit) != units.end()) {
    throw UsageError(fmt::format("'{}' has {} twice", names, name));
  }
  units.push_back(unit);
}

/// Assignments are exchanged between physical devices by messages (CiA 407, 8.1.4.3).
void check_apart(const std::vector<const cia407::BusUnit*>& units, std::string_view names) {
  const auto has = [&](cia407::DeviceCode code) {
    return std::ranges::any_of(units, [code](const cia407::BusUnit* unit) {
      return unit->provides->code == cia407::code_of(code);
    });
  };
  if (!has(cia407::DeviceCode::main_on_board_computer) ||
      !has(cia407::DeviceCode::identification)) {
    return;
  }
  throw UsageError(
      fmt::format("'{}': a main on-board computer and an identification are different physical "
                  "devices (CiA 407, 8.1.4.3): give them with a space between them",
                  names));
}

}  // namespace

SharedNode parse_shared_node(std::string_view names) {
  SharedNode shared;
  if (names.find('+') == std::string_view::npos) return shared;
  const DeviceKind none{};
  const DeviceKind* const first = find_device_kind(names.substr(0, names.find('+')));
  const bool is_bus = first != nullptr && first->bus_unit != nullptr;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find('+', begin), names.size());
    const std::string_view name = names.substr(begin, end - begin);
    begin = end + 1;
    const DeviceKind* const found = find_device_kind(name);
    const DeviceKind& kind = found == nullptr ? none : *found;
    if (is_bus) {
      add_unit(shared.bus, kind.bus_unit, cia407::profile.name, names, name);
    } else {
      const bool is_first = shared.car.empty();
      add_unit(shared.car, kind.car_unit, is_first ? "CiA 407 or CiA 447" : "CiA 447", names, name);
    }
  }
  check_apart(shared.bus, names);
  return shared;
}

std::vector<std::string_view> virtual_devices_of(const DeviceKind& kind) {
  std::vector<std::string_view> names;
  // Their codes are in CiA 447-2, which is not available.
  if (kind.car_unit != nullptr) names.push_back(kind.car_unit->provides->name);
  if (kind.profile->device_type_of == nullptr) return names;
  // A device may have several functional elements (CiA 852): each is some bits of the type.
  const bool are_bits = kind.profile->device_types.mask != 0;
  for (const std::uint32_t type : device_types(kind)) {
    for (const VirtualDeviceInfo& device : kind.profile->virtual_devices) {
      const std::uint32_t own = kind.profile->device_type_of(device);
      const bool is_it = device.code != 0 && (are_bits ? (own & type) == own : own == type);
      if (is_it && std::ranges::find(names, device.name) == names.end()) {
        names.push_back(device.name);
      }
    }
  }
  return names;
}

void print_device_list(bool json) {
  for (const DeviceKind* kind : all_device_kinds()) {
    const DeviceInfo& info = kind->info;
    if (json) {
      const nlohmann::ordered_json line = {{"name", info.name},
                                           {"title", info.title},
                                           {"profile", short_name(*kind->profile)},
                                           {"virtual_devices", virtual_devices_of(*kind)},
                                           {"node_id", info.node_id}};
      fmt::print("{}\n", line.dump());
    } else {
      fmt::print("{:<22} {:<10} node {:>3}  {}\n", info.name, kind->profile->name, info.node_id,
                 info.title);
    }
  }
}

std::string device_table() {
  std::string text =
      "| name | what it is | profile | virtual devices | node-ID | hardware | keeps parameters |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const DeviceKind* kind : all_device_kinds()) {
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", kind->info.name,
                        kind->info.title, kind->profile->name,
                        fmt::join(virtual_devices_of(*kind), ", "), kind->info.node_id,
                        kind->info.hardware, kind->keeping_forms.empty() ? "" : "yes");
  }
  return text;
}

}  // namespace canvoy::tools
