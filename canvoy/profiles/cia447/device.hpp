// Devices of CiA 447-3, composed of virtual devices: all objects that these provide, and those that
// they consume. Part 2, which defines the optional objects, is not at hand. For a device with fewer
// objects, name the objects (canvoy/profiles/model/virtual_device.hpp).
//
//     constexpr auto my_taximeter = describe(
//         cia447::device_with(cia447::taximeter_device, cia447::printer_device),
//         cia447::consumed(cia447::actual_engine_revolutions_object, cia447::wheel_rpm_object,
//                          cia447::wheel_pulse_counter_object),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
//
// The devices have the pre-defined PDOs of their objects. The CAN-IDs of these are not known: a PDO
// is invalid until its COB-ID is set.
#pragma once

#include <algorithm>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia301/predefined_pdo.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

/// True if part 3 lets PDOs carry all entries that this one maps: not with lamps 9 to 16 (errata
/// Z40).
constexpr bool can_be_mapped(const PdoInfo& pdo) {
  for (const std::uint32_t raw : pdo.mapping) {
    const MappingValue mapped(raw);
    const EntryInfo* entry = find_entry(*find_object(profile, mapped.index), mapped.sub);
    if (entry == nullptr || entry->mapping == Mapping::no) return false;
  }
  return true;
}
/// Adds the PDOs of which all objects exist.
template <PdoInfo::Direction direction, std::size_t capacity>
constexpr void add_pdos(DeviceDescription<capacity>& parts) {
  constexpr auto is_possible = [](const PdoInfo& pdo) {
    return pdo.direction == direction && can_be_mapped(pdo);
  };
  constexpr bool sends = direction == PdoInfo::Direction::transmit;
  const auto candidates = predefined_pdos<profile, is_possible>();
  for (const PdoInfo& pdo : pdos) {
    const auto is_there = [&parts](std::uint32_t raw) {
      return parts.find(MappingValue(raw).index) != nullptr;
    };
    if (!is_possible(pdo) || !std::ranges::all_of(pdo.mapping, is_there)) continue;
    const unsigned parameter = (sends ? 0x1800U : 0x1400U) + pdo.number - 1;
    parts.add_pdo(*candidates.find(parameter), *candidates.find(parameter + 0x200));
  }
}

/// Device type, error register, all objects of these virtual devices, and their TPDOs.
template <class... Device>
constexpr auto device_with(const Device&... devices) {
  constexpr std::size_t capacity = objects.size() + pdos.size() + 2;
  DeviceDescription<capacity> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type));
  parts.add(cia301::error_register_object);
  const auto append = [&parts](const VirtualDeviceInfo& device) {
    for (const DeviceObject& object : device.objects) {
      parts.add(Part(*find_object(profile, object.index)));
    }
  };
  (append(devices), ...);
  add_pdos<PdoInfo::Direction::transmit>(parts);
  return parts;
}

/// Objects of other devices, as their consumers have them: rw; with the RPDOs of which all objects
/// are among them.
template <class... Object>
constexpr auto consumed(const Object&... of_others) {
  DeviceDescription<sizeof...(Object) + pdos.size()> parts;
  (parts.add(Part(of_others).consumed()), ...);
  add_pdos<PdoInfo::Direction::receive>(parts);
  return parts;
}

}  // namespace canvoy::cia447
