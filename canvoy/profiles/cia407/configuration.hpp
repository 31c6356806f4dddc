// CiA 407: the devices of the minimum and the typical configuration, with their pre-defined PDOs
// (8.1.4).
//
//     using cia407::Configuration;
//     constexpr auto my_printer = describe(
//         cia407::device<cia407::ticket_printer, Configuration::typical>({{0x6112, 4}}),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia301/predefined_pdo.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"

namespace canvoy::cia407 {

/// Pre-defined PDOs that a device has (8.1.4).
enum class Configuration : std::uint8_t {
  none,     ///< only PDOs that the maker adds
  minimum,  ///< 8.1.4.1
  typical,  ///< 8.1.4.2
};

/// True if a virtual device has this PDO of the profile in a configuration.
constexpr bool has_pdo(const VirtualDeviceInfo& device, Configuration configuration,
                       const PdoInfo& pdo) {
  const bool has_device = std::ranges::find(pdo.devices, device.code) != pdo.devices.end();
  if (!has_device || configuration == Configuration::none) return false;
  const bool is_minimum =
      pdo.condition == minimum_configuration || pdo.condition == minimum_destination;
  if (configuration == Configuration::minimum && !is_minimum) return false;
  if (device.code != code_of(DeviceCode::passenger_information)) return true;
  const auto of_class = [&](InformationClass which) {
    return device.device_class == static_cast<std::uint8_t>(which);
  };
  return pdo.condition == typical_next_stop ? of_class(InformationClass::next_stop)
                                            : of_class(InformationClass::destination);
}

/// Adds the precision of a measured value, which is mandatory where the value exists (errata 104).
/// It is at the next index.
template <std::size_t capacity>
constexpr void add_precisions(DeviceDescription<capacity>& parts, const VirtualDeviceInfo& device) {
  for (const DeviceObject& object : device.objects) {
    const bool is_due = object.category == Category::conditional &&
                        parts.find(object.index - 1U) != nullptr &&
                        parts.find(object.index) == nullptr;
    if (is_due) add_virtual_device(parts, profile, device, {object.index});
  }
}

/// Device type, error register, PDOs and the objects that they map, the mandatory objects of the
/// virtual device, and the wanted ones.
template <const VirtualDeviceInfo& virtual_device,
          Configuration configuration = Configuration::none>
constexpr auto device(const WantedObjects& wanted = {}) {
  constexpr auto has = [](const PdoInfo& pdo) {
    return has_pdo(virtual_device, configuration, pdo);
  };
  DeviceDescription<96> parts;
  parts.add(profile);
  parts.add(cia301::device_type(device_type(virtual_device)));
  parts.add(error_register_object);
  parts.add(predefined_pdos<profile, has>());
  add_virtual_device(parts, profile, virtual_device, wanted);
  add_precisions(parts, virtual_device);
  // The device passes on what it receives: the third message has to map it (errata 96).
  if (virtual_device.code == code_of(DeviceCode::main_on_board_computer)) {
    parts = parts.with(parts.find(events_from_virtual_devices_object.index)->access(1, Access::rw));
  }
  return parts;
}

}  // namespace canvoy::cia407
