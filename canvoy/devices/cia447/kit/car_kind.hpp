// A kind of virtual device of CiA 447, and the combination of several kinds to one physical device.
//
//     struct BlueLightKind : CarKind<BlueLight, SwitchedHardware, SwitchedSettings> {
//       static constexpr DeviceInfo info = {.name = "blue-light", ...};
//       static constexpr const VirtualDeviceInfo& provides = blue_light_flasher_module_device;
//       static constexpr const ObjectInfo* consumes[] = {&ignition_switch_status_object};
//     };
//     const DeviceKind blue_light_kind = car_device_kind<BlueLightKind>();   // for the catalogue
//
//     const CarUnit* units[] = {&car_unit<TaximeterKind>, &car_unit<PrinterKind>};
//     CarDevice device(units, port, 5, environment);
//
// A unit is constructed with a CarNetwork (its node, and the requesting client), its hardware and
// its settings. Hardware that is not offered at the environment is that of Kind::simulated(), or
// absent.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/devices/kit/device_kind.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

template <class UnitType, class HardwareType, class SettingsType>
struct CarKind {
  using Unit = UnitType;          ///< behaviour of the virtual device
  using Hardware = HardwareType;  ///< what the unit senses and drives
  using Settings = SettingsType;  ///< what no object of the dictionary sets
  /// Objects of other devices that it reads: rw, with the RPDOs of which all objects exist.
  static constexpr std::array<const ObjectInfo*, 0> consumes{};
  /// Objects of the manufacturer's area (2000h to 5FFFh) beside those of the profile.
  static constexpr std::array<const ObjectInfo*, 0> own{};
};

/// Constructs a unit with what its environment offers.
template <class Kind>
void make_car_unit(void* memory, CarNetwork& network, const Environment& environment) {
  using Unit = typename Kind::Unit;
  using Hardware = typename Kind::Hardware;
  static_assert(alignof(Unit) <= alignof(std::max_align_t));
  Hardware otherwise{};
  if constexpr (requires { Kind::simulated(); }) otherwise = Kind::simulated();
  Unit* const unit =
      std::construct_at(static_cast<Unit*>(memory), network, environment.get<Hardware>(otherwise),
                        environment.get<typename Kind::Settings>());
  environment.made<Unit>(*unit, network.node());
}

/// Row of a kind of virtual device.
template <class Kind>
inline constexpr CarUnit car_unit = {
    .info = Kind::info,
    .provides = &Kind::provides,
    .consumes = Kind::consumes,
    .own = Kind::own,
    .bytes = sizeof(typename Kind::Unit),
    .make = make_car_unit<Kind>,
    .end = [](void* memory) { std::destroy_at(static_cast<typename Kind::Unit*>(memory)); }};

/// The same as a list of one.
template <class Kind>
inline constexpr const CarUnit* only_unit[1] = {&car_unit<Kind>};

/// A physical device of one virtual device, in the catalogue.
template <class Kind>
inline constexpr DeviceForm car_form[1] = {
    {.parts =
         [] {
           // They live as long as the program.
           static const auto& parts = *new std::vector<Part>(car_parts(only_unit<Kind>));
           return std::span<const Part>(parts);
         },
     .bytes = sizeof(CarDevice),
     .make = [](void* memory, const Port& port, NodeId node_id,
                const Environment& environment) -> MadeDevice {
       auto* const made = std::construct_at(static_cast<CarDevice*>(memory), only_unit<Kind>, port,
                                            node_id, environment);
       return {&made->node(), &made->emergency_producer()};
     },
     .end = [](void* memory) { std::destroy_at(static_cast<CarDevice*>(memory)); }}};

/// Row of the catalogue for a device that is this virtual device alone.
template <class Kind>
constexpr DeviceKind car_device_kind() {
  return {.info = Kind::info,
          .profile = &profile,
          .forms = car_form<Kind>,
          .car_unit = &car_unit<Kind>};
}

}  // namespace canvoy::cia447
