// A kind of virtual device of CiA 447, and the combination of several kinds to one physical device.
//
//     struct BlueLightKind : CarKind<BlueLight, SwitchedHardware, SwitchedSettings> {
//       static constexpr DeviceInfo info = {.name = "blue-light", ...};
//       static constexpr const VirtualDeviceInfo& provides = blue_light_flasher_module_device;
//       static constexpr const ObjectInfo* consumes[] = {&ignition_switch_status_object};
//     };
//
//     const DeviceKind all[] = {car_device_kind<BlueLightKind>()};   // for the catalogue
//     const CarUnit* units[] = {&car_unit<TaximeterKind>, &car_unit<PrinterKind>};
//     CarDevice device(units, port, 5, environment);
//
// A unit is constructed with a CarNetwork (its node, and the requesting client), its hardware and
// its settings. Hardware that is not offered at the environment is that of Kind::simulated(), or
// absent.
#pragma once

#include <array>
#include <string_view>

#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

template <class UnitType, class HardwareType, class SettingsType>
struct CarKind : UnitKind<UnitType, HardwareType, SettingsType> {
  /// Objects of other devices that it reads: rw, with the RPDOs of which all objects exist.
  static constexpr std::array<const ObjectInfo*, 0> consumes{};
  /// Objects of the manufacturer's area (2000h to 5FFFh) beside those of the profile.
  static constexpr std::array<const ObjectInfo*, 0> own{};
};

/// Row of a kind of virtual device.
template <class Kind>
inline constexpr CarUnit car_unit = {.info = Kind::info,
                                     .provides = &Kind::provides,
                                     .consumes = Kind::consumes,
                                     .own = Kind::own,
                                     .unit = unit_maker<Kind, CarNetwork>};

/// The same as a list of one.
template <class Kind>
inline constexpr const CarUnit* only_unit[1] = {&car_unit<Kind>};

/// Row of the catalogue for a device that is this virtual device alone.
template <class Kind>
constexpr DeviceKind car_device_kind() {
  static_assert(std::string_view(Kind::info.product).size() <= cia301::name_capacity,
                "1008h of a board has no room for the name of the product");
  return {.info = Kind::info,
          .profile = &profile,
          .forms = composed_form<CarDevice, only_unit<Kind>>,
          .car_unit = &car_unit<Kind>};
}

}  // namespace canvoy::cia447
