// Devices of CiA 447-3, put together from virtual devices: all objects of those, and what they
// consume of others. Part 2, which says what may be left out, is not at hand: who wants less names
// the objects (canvoy/profiles/virtual_device.hpp).
//
//     constexpr auto my_taximeter = describe(
//         cia447::device_with(cia447::taximeter_device, cia447::printer_device),
//         cia447::consumed(cia447::wheel_rpm_object, cia447::wheel_pulse_counter_object),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

/// Device type, error register, and all objects of these virtual devices.
template <class... Device>
consteval auto device_with(const Device&... devices) {
  constexpr std::size_t capacity = objects.size() + 2;
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
  return parts;
}

/// Objects of other devices, as those have them who consume them: rw.
template <class... Object>
consteval auto consumed(const Object&... of_others) {
  DeviceDescription<sizeof...(Object)> parts;
  (parts.add(Part(of_others).consumed()), ...);
  return parts;
}

}  // namespace canvoy::cia447
