// The parts of a device that is one virtual device of a lift: its objects in that lift, and the
// pre-defined PDOs for them.
//
//     constexpr auto my_door = describe(
//         lift_device<VirtualDevice::car_door_unit, LiftDeviceOptions{.lift = 2, .doors = 1}>(
//             {0x6300, 0x6301, 0x6302, 0x6304}),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(500));
//
// PDOs with COB-IDs that depend on node-IDs (virtual inputs and sensors) exist in the sender and
// are invalid until they get a COB-ID (CiA 417-3). The maker adds their RPDOs, and multiplexed
// PDOs, for the nodes in the system.
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia301/predefined_pdo.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"

namespace canvoy::cia417 {

/// Selection of the objects of a lift device.
struct LiftDeviceOptions {
  unsigned lift = 1;        ///< 1 to 8
  unsigned doors = 0b1111;  ///< doors that it moves or watches: bit 0 is door 1
  std::size_t parts = 96;   ///< maximum number of objects
};

/// Description of a virtual device.
constexpr const VirtualDeviceInfo& info_of(VirtualDevice device) {
  for (const VirtualDeviceInfo& info : virtual_devices) {
    if (info.code == code_of(device)) return info;
  }
  canvoy::detail::description_is_wrong("CiA 417-4 has no objects of this device");
  return virtual_devices[0];
}

/// True if the object belongs to one lift, not to the device (4.2; errata B32).
constexpr bool is_of_lift(unsigned index) {
  return index >= input_group_object.index;
}

/// The door that a PDO gives the state of; 0: none.
constexpr unsigned door_of(const PdoInfo& pdo) {
  const MappingValue mapped(pdo.mapping[0]);
  const unsigned index = mapped.index - (mapped.index - 0x6000U) / block_pitch * block_pitch;
  const bool is_state =
      index == door_statusword_object.index || index == light_barrier_status_object.index;
  return is_state ? mapped.sub : 0;
}

/// True if a device has a PDO by default: where the PDO belongs to its lift and its doors.
template <VirtualDevice device, LiftDeviceOptions options>
constexpr bool is_pdo_of(const PdoInfo& pdo) {
  if (pdo.number == 0 || pdo.last_number != 0 || pdo.multiplexed != MpdoKind::no) return false;
  const unsigned index = MappingValue(pdo.mapping[0]).index;
  if (is_of_lift(index) && (index - 0x6000U) / block_pitch != options.lift - 1) return false;
  const unsigned door = door_of(pdo);
  const bool sends = pdo.direction == PdoInfo::Direction::transmit;
  if (sends && door != 0 && (options.doors >> (door - 1) & 1) == 0) return false;
  for (const std::uint8_t code : pdo.devices) {
    if (code == code_of(device)) return true;
  }
  return false;
}

/// True if `parts` has all objects that a PDO maps.
template <std::size_t capacity>
constexpr bool has_mapped(const DeviceDescription<capacity>& parts, const PdoInfo& pdo) {
  for (const std::uint32_t raw : pdo.mapping) {
    const MappingValue mapped(raw);
    const Part* part = parts.find(mapped.index);
    if (part == nullptr || mapped.sub > part->highest_sub()) return false;
  }
  return true;
}

/// Adds the pre-defined PDOs of the device of which all mapped objects exist.
template <VirtualDevice device, LiftDeviceOptions options, std::size_t capacity>
constexpr void add_pdos(DeviceDescription<capacity>& parts) {
  constexpr auto is_mine = [](const PdoInfo& pdo) { return is_pdo_of<device, options>(pdo); };
  const auto candidates = predefined_pdos<profile, is_mine>();
  for (const PdoInfo& pdo : profile.pdos) {
    if (!is_mine(pdo) || !has_mapped(parts, pdo)) continue;
    const bool sends = pdo.direction == PdoInfo::Direction::transmit;
    const unsigned parameter = (sends ? 0x1800U : 0x1400U) + pdo.number - 1;
    parts.add_pdo(*candidates.find(parameter), *candidates.find(parameter + 0x200));
  }
}

/// Adds those optional objects of part 4 that are `wanted`, by their indices in lift 1.
template <VirtualDevice device, LiftDeviceOptions options = LiftDeviceOptions{}>
constexpr auto lift_device(const WantedObjects& wanted) {
  static_assert(options.lift >= 1 && options.lift <= lift_count, "there are 8 lifts");
  DeviceDescription<options.parts> own;
  add_virtual_device(own, profile, info_of(device), wanted);
  DeviceDescription<options.parts> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type(device)));
  parts.add(cia301::error_register_object);
  for (const Part& part : own) {
    if (part.index() == lift_number_object.index) {
      parts.add(part.initial(1U << (options.lift - 1)));
    } else {
      parts.add(is_of_lift(part.index()) ? part.moved((options.lift - 1) * block_pitch) : part);
    }
  }
  add_pdos<device, options>(parts);
  return parts;
}

}  // namespace canvoy::cia417
