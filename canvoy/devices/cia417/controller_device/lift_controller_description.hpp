// The parts of a lift controller: call controller, car door controller and car drive controller in
// one device, with the objects and pre-defined PDOs of all three (CiA 417-4, 4.2.1).
//
//     constexpr auto mine = describe(lift_controller<LiftControllerOptions{.lift = 2}>(),
//                                    cia301::identity({.vendor_id = 0x123}));
#pragma once

#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/devices/cia417/virtual_io/multiplexed_panels.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_input_rpdos.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// What a lift controller has room for.
struct LiftControllerOptions {
  unsigned lift = 1;      ///< 1 to 8
  unsigned panels = 127;  ///< virtual inputs of node-IDs up to this one are received
  /// Number of outputs of panels that are listed from 6200h on, six bytes each; 0: none.
  unsigned outputs = 254;
  /// Panels are also received by multiplexed PDOs, in this mode by default: two KiB.
  /// MpdoMode::none: they are not.
  MpdoMode multiplexed = MpdoMode::destination;
};

namespace detail {

inline constexpr VirtualDevice controllers[] = {VirtualDevice::call_controller,
                                                VirtualDevice::car_door_controller,
                                                VirtualDevice::car_drive_controller};

template <unsigned lift>
constexpr bool is_pdo_of_controller(const PdoInfo& pdo) {
  constexpr LiftDeviceOptions options{.lift = lift};
  return is_pdo_of<VirtualDevice::call_controller, options>(pdo) ||
         is_pdo_of<VirtualDevice::car_door_controller, options>(pdo) ||
         is_pdo_of<VirtualDevice::car_drive_controller, options>(pdo);
}

template <std::size_t capacity>
constexpr void add_controllers(DeviceDescription<capacity>& own, unsigned outputs) {
  add_virtual_device(own, profile, info_of(VirtualDevice::call_controller),
                     {0x6010, 0x6011, 0x6482});
  add_groups<VirtualDevice::call_controller>(own, output_group_object.index, outputs, false);
  add_virtual_device(own, profile, info_of(VirtualDevice::car_door_controller),
                     {0x6300, 0x6301, 0x6302, 0x6310});
  add_virtual_device(
      own, profile, info_of(VirtualDevice::car_drive_controller),
      {0x6383, 0x6400, 0x6401, 0x6403, 0x6404, 0x6406, 0x6420, 0x6430, 0x6431, 0x6432, 0x6433});
}

constexpr EntryInfo controller_type(std::uint8_t number) {
  EntryInfo entry = at(number, virtual_device_type);
  entry.initial = device_type(controllers[number - 1]) >> 16;
  return entry;
}
inline constexpr EntryInfo controller_type_entries[] = {supported_virtual_device_types_entries[0],
                                                        controller_type(1), controller_type(2),
                                                        controller_type(3)};
/// 6000h names all three.
inline constexpr ObjectInfo controller_types_object =
    with_subs(supported_virtual_device_types_object, controller_type_entries);

}  // namespace detail

/// All parts of the controller except its identity; the objects are those of lift `options.lift`.
template <LiftControllerOptions options = LiftControllerOptions{}>
constexpr auto lift_controller() {
  static_assert(options.lift >= 1 && options.lift <= lift_count, "there are 8 lifts");
  static_assert(options.outputs <= group_count * last_of_many, "32 groups of 254 outputs");
  DeviceDescription<80> own;
  detail::add_controllers(own, options.outputs);
  DeviceDescription<152> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type(VirtualDevice::several)));
  parts.add(cia301::error_register_object);
  parts.add(detail::controller_types_object);
  for (const Part& part : own) {
    if (part.index() == lift_number_object.index) {
      parts.add(part.initial(1U << (options.lift - 1)));
    } else {
      parts.add(is_of_lift(part.index()) ? part.moved((options.lift - 1) * block_pitch) : part);
    }
  }
  constexpr auto is_mine = [](const PdoInfo& pdo) {
    return detail::is_pdo_of_controller<options.lift>(pdo);
  };
  parts.add(predefined_pdos<profile, is_mine>());
  parts.add(virtual_input_rpdos<options.panels>());
  if constexpr (options.multiplexed != MpdoMode::none) {
    parts.add(multiplexed_panels<options.multiplexed, options.panels>());
  }
  return parts;
}

}  // namespace canvoy::cia417
