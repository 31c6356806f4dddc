// The parts of a panel of a landing or a car: an input panel unit, an output panel unit, or both in
// one device (CiA 417-4, 4.2.1, 4.3 and 4.5).
//
//     constexpr auto my_panel = describe(panel<PanelOptions{.inputs = 2, .outputs = 4}>(),
//                                        cia301::identity({.vendor_id = 0x123}),
//                                        cia301::heartbeat_producer(1000));
//
// The PDOs are from public sources, as in cia417/pdos.hpp.
#pragma once

#include "canvoy/devices/cia417/kit/physical_description.hpp"

namespace canvoy::cia417 {

/// Size and PDOs of a panel.
struct PanelOptions {
  unsigned lift = 1;          ///< lift of its groups: 6100h and up is lift 1
  std::uint16_t inputs = 0;   ///< 254 in each group from the first on; 0: no input panel
  std::uint16_t outputs = 0;  ///< outputs, in the same way
  bool parameters = true;     ///< parameters 1 to 4 of each group
  /// PDO 1 of each direction instead of those of part 3, RPDO 257 and TPDO 130.
  bool low_pdo_numbers = false;
  /// True if the TPDO is valid after power-on. In part 3, a device that knows the node-ID makes it
  /// valid.
  bool valid_tpdo = true;
};

/// TPDO of 6010h, with the node-ID added to `cob_id`.
constexpr PdoInfo panel_tpdo(std::uint16_t number, std::uint32_t cob_id) {
  return {.direction = PdoInfo::Direction::transmit,
          .number = number,
          .cob_id = cob_id,
          .plus_node_id = true,
          .mapping = virtual_input_pdo,
          .clause = pdo_clause};
}
/// RPDO of 6011h.
constexpr PdoInfo panel_rpdo(std::uint16_t number) {
  return {.direction = PdoInfo::Direction::receive,
          .number = number,
          .cob_id = 0x400,
          .mapping = virtual_output_pdo,
          .clause = pdo_clause};
}
inline constexpr std::uint16_t panel_tpdo_number = number_of_rpdo(0x1481);  ///< TPDO in CiA 417-3
inline constexpr std::uint16_t panel_rpdo_number = number_of_rpdo(0x1500);  ///< RPDO in CiA 417-3
/// All PDOs that a panel may have; its options choose among them.
inline constexpr PdoInfo panel_pdos[] = {panel_tpdo(panel_tpdo_number, 0x480),
                                         panel_tpdo(panel_tpdo_number, invalid_pdo | 0x480),
                                         panel_tpdo(1, 0x480),
                                         panel_tpdo(1, invalid_pdo | 0x480),
                                         panel_rpdo(panel_rpdo_number),
                                         panel_rpdo(1)};
/// Holds panel_pdos only.
inline constexpr Profile panel_pdo_profile = {.number = profile_number, .pdos = panel_pdos};

/// True if a panel has this PDO.
template <PanelOptions options>
constexpr bool is_pdo_of_panel(const PdoInfo& pdo) {
  if ((pdo.number == 1) != options.low_pdo_numbers) return false;
  if (pdo.direction == PdoInfo::Direction::receive) return options.outputs != 0;
  return options.inputs != 0 && ((pdo.cob_id & invalid_pdo) == 0) == options.valid_tpdo;
}

/// Adds the groups from `first` on for `count` inputs or outputs, and their parameters.
template <VirtualDevice device, std::size_t capacity>
constexpr void add_groups(DeviceDescription<capacity>& own, std::uint16_t first, unsigned count,
                          bool parameters) {
  for (unsigned group = 0; count != 0; ++group) {
    const unsigned in_this = count < last_of_many ? count : last_of_many;
    count -= in_this;
    for (unsigned object = 0; object <= (parameters ? 4U : 0U); ++object) {
      const auto index = static_cast<std::uint16_t>(first + group + object * group_count);
      add_wanted_object(own, profile, info_of(device), {index, static_cast<std::uint8_t>(in_this)});
    }
  }
}
/// Adds the objects of both units, in their groups.
template <PanelOptions options, std::size_t capacity>
constexpr void add_units(DeviceDescription<capacity>& own) {
  constexpr VirtualDevice in = VirtualDevice::input_panel_unit;
  constexpr VirtualDevice out = VirtualDevice::output_panel_unit;
  if (options.inputs != 0) {
    add_virtual_device(own, profile, info_of(in), {0x6010});
    add_groups<in>(own, input_group_object.index, options.inputs, options.parameters);
  }
  if (options.outputs != 0) {
    add_virtual_device(own, profile, info_of(out), {0x6011});
    add_groups<out>(own, output_group_object.index, options.outputs, options.parameters);
  }
}

/// All parts of a panel except its identity.
template <PanelOptions options>
constexpr auto panel() {
  static_assert(options.lift >= 1 && options.lift <= lift_count, "there are 8 lifts");
  static_assert(options.inputs != 0 || options.outputs != 0, "a panel of nothing");
  static_assert(options.inputs <= 4 * last_of_many && options.outputs <= 4 * last_of_many,
                "more are for a description of the maker's own");
  DeviceDescription<48> own;
  add_units<options>(own);
  DeviceDescription<64> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  if constexpr (options.outputs == 0) {
    add_device_types<VirtualDevice::input_panel_unit>(parts);
  } else if constexpr (options.inputs == 0) {
    add_device_types<VirtualDevice::output_panel_unit>(parts);
  } else {
    add_device_types<VirtualDevice::input_panel_unit, VirtualDevice::output_panel_unit>(parts);
  }
  parts.add(cia301::error_register_object);
  for (const Part& part : own) {
    parts.add(is_of_lift(part.index()) ? part.moved((options.lift - 1) * block_pitch) : part);
  }
  constexpr auto is_mine = [](const PdoInfo& pdo) { return is_pdo_of_panel<options>(pdo); };
  parts.add(predefined_pdos<panel_pdo_profile, is_mine>());
  return parts;
}

}  // namespace canvoy::cia417
