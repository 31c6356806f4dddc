// CiA 852: the objects of an operator environment with the elements that its maker selects.
//
//     constexpr cia852::OperatorEnvironment elements = {.joysticks = 2, .indicator_clusters = 1};
//     constexpr auto seat = describe(
//         cia852::operator_environment<elements>(), cia301::identity({.vendor_id = 0x123}),
//         cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(1),
//         cia301::emergency_consumers(1));
#pragma once

#include "canvoy/profiles/cia852.hpp"
#include "canvoy/profiles/cia852/configuration.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy::cia852 {

/// Elements are numbered from 1 without gaps.
struct OperatorEnvironment {
  unsigned joysticks = 0;  ///< 0: none
  /// Joysticks have a button or hold their position. Their entries exist in any case, since TPDOs
  /// map them (errata 24): without these inputs they stay 0, like those of a missing axis.
  bool joystick_inputs = true;
  unsigned foot_pedals = 0;                             ///< 0: none
  unsigned encoders = 0;                                ///< 0: none
  unsigned wheels = 0;                                  ///< 0: none
  unsigned push_button_clusters = 0;                    ///< 0: none
  unsigned indicator_clusters = 0;                      ///< 0: none
  unsigned displays = 0;                                ///< 0: none
  unsigned display_parameters = parameters_of_display;  ///< of each display
  /// Displays also accept floating-point numbers (Table A 8).
  bool display_floats = false;
  /// A program can be downloaded over the network (11.7).
  bool program_download = false;
  /// Inputs and indicators can be configured over the network, as in CiA 401 (clause 15): polarity,
  /// filter, which changes are events, offset and scaling.
  bool configuration = false;

  friend constexpr bool operator==(const OperatorEnvironment&,
                                   const OperatorEnvironment&) = default;
};
/// True with joysticks, foot pedals or wheels.
constexpr bool has_analogue_inputs(const OperatorEnvironment& has) {
  return has.joysticks + has.foot_pedals + has.wheels > 0;
}
/// True if 6000h exists.
constexpr bool has_8_bit_inputs(const OperatorEnvironment& has) {
  return has.joysticks + has.foot_pedals + has.push_button_clusters > 0;
}
/// True with indicators or displays.
constexpr bool has_outputs(const OperatorEnvironment& has) {
  return has.indicator_clusters + has.displays > 0;
}

/// PDOs for so many elements.
constexpr unsigned pdos_for(unsigned elements, unsigned elements_of_pdo) {
  return (elements + elements_of_pdo - 1) / elements_of_pdo;
}
/// Functions that the elements give the device.
constexpr Functions functions_of(const OperatorEnvironment& has) {
  return {.joystick = has.joysticks > 0,
          .joystick_with_inputs = has.joysticks > 0 && has.joystick_inputs,
          .foot_pedal = has.foot_pedals > 0,
          .encoder = has.encoders > 0,
          .wheel = has.wheels > 0,
          .push_button_cluster = has.push_button_clusters > 0,
          .indicator_cluster = has.indicator_clusters > 0,
          .display = has.displays > 0};
}
/// Does not compile beyond the numbers of elements that the profile has room for.
constexpr void check_elements(const OperatorEnvironment& has) {
  using detail::description_is_wrong;
  const bool fits = has.joysticks <= joysticks_max && has.foot_pedals <= foot_pedals_max &&
                    has.encoders <= encoders_max && has.wheels <= wheels_max &&
                    has.push_button_clusters <= push_button_clusters_max &&
                    has.indicator_clusters <= indicator_clusters_max &&
                    has.displays <= displays_max;
  if (!fits) description_is_wrong("more elements than CiA 852 has room for");
  if (has.display_parameters == 0 || has.display_parameters > parameters_of_display) {
    description_is_wrong("a display has 1 to 12 parameters");
  }
}

/// True if an element has this sub-index of 6000h.
constexpr bool has_8_bit_input(const OperatorEnvironment& has, unsigned sub) {
  if (sub < foot_pedal_memory_sub(1)) return sub <= joystick_buttons_sub(has.joysticks);
  if (sub < push_buttons_sub(1, 1)) return sub <= foot_pedal_memory_sub(has.foot_pedals);
  return sub < push_buttons_sub(has.push_button_clusters + 1, 1);
}
/// True if an element has this sub-index of 6401h.
constexpr bool has_analogue_input(const OperatorEnvironment& has, unsigned sub) {
  if (sub < foot_pedal_position_sub(1)) return sub < joystick_axis_sub(has.joysticks + 1, 1);
  if (sub < wheel_position_sub(1)) return sub <= foot_pedal_position_sub(has.foot_pedals);
  return sub <= wheel_position_sub(has.wheels);
}
/// True if a display has this sub-index of 6411h.
constexpr bool has_display(const OperatorEnvironment& has, unsigned sub) {
  return (sub - 1) / display_pitch < has.displays &&
         (sub - 1) % display_pitch < has.display_parameters;
}
/// Sub-index 00h always exists.
constexpr bool has_entry(const OperatorEnvironment& has, unsigned index, unsigned sub) {
  if (sub == 0) return true;
  switch (index) {
    case read_input_8_bit_object.index:
      return has_8_bit_input(has, sub);
    case read_input_32_bit_object.index:
      return sub <= encoder_position_sub(has.encoders);
    case read_analogue_input_16_bit_object.index:
      return has_analogue_input(has, sub);
    case write_output_8_bit_object.index:
    case error_mode_output_8_bit_object.index:
    case error_value_output_8_bit_object.index:
      return sub < indicators_sub(has.indicator_clusters + 1, 1);
    default:
      return has_display(has, sub);
  }
}
/// Part of an object that the elements need.
constexpr Part part_of(const OperatorEnvironment& has, const ObjectInfo& object) {
  return Part(object).keeping([&](unsigned sub) { return has_entry(has, object.index, sub); });
}

/// A mapping without the missing elements.
constexpr Part fitted(const OperatorEnvironment& has, const ObjectInfo& mapping) {
  unsigned count = 0;
  const auto is_there = [&](unsigned sub) {
    const EntryInfo& entry = *find_entry(mapping, sub);
    const MappingValue value(static_cast<std::uint32_t>(entry.initial.number));
    return sub == 0 || has_entry(has, value.index, value.sub);
  };
  for (const EntryInfo& entry : mapping.entries()) {
    if (entry.sub_first > 0 && is_there(entry.sub_first)) ++count;
  }
  return Part(mapping).keeping(is_there).initial(0, count);
}

/// Adds the TPDOs of the inputs that it has.
template <class Parts>
constexpr void add_tpdos(Parts& parts, const OperatorEnvironment& has) {
  const auto add = [&](unsigned number) {
    parts.add_pdo(tpdo_parameter(number), fitted(has, tpdo_mapping(number)));
  };
  for (unsigned n = 1; n <= has.joysticks; ++n) add(joystick_tpdo(n));
  for (unsigned n = 1; n <= has.foot_pedals; n += foot_pedals_of_tpdo) add(foot_pedal_tpdo(n));
  for (unsigned n = 1; n <= has.encoders; n += encoders_of_tpdo) add(encoder_tpdo(n));
  for (unsigned n = 1; n <= has.wheels; n += wheels_of_tpdo) add(wheel_tpdo(n));
  for (unsigned n = 1; n <= has.push_button_clusters; ++n) add(push_button_tpdo(n));
}
/// Adds the RPDOs of the outputs that it has.
template <class Parts>
constexpr void add_rpdos(Parts& parts, const OperatorEnvironment& has) {
  const auto add = [&](unsigned number) {
    parts.add_pdo(rpdo_parameter(number), fitted(has, rpdo_mapping(number)));
  };
  for (unsigned n = 1; n <= has.indicator_clusters; ++n) add(indicator_rpdo(n));
  const unsigned of_display = pdos_for(has.display_parameters, parameters_of_rpdo);
  for (unsigned n = 1; n <= has.displays; ++n) {
    for (unsigned part = 1; part <= of_display; ++part) add(display_rpdo(n, part));
  }
}
/// Adds the objects of its inputs.
template <class Parts>
constexpr void add_inputs(Parts& parts, const OperatorEnvironment& has) {
  if (has_8_bit_inputs(has)) parts.add(part_of(has, read_input_8_bit_object));
  if (has.encoders > 0) parts.add(part_of(has, read_input_32_bit_object));
  if (!has_analogue_inputs(has)) return;
  parts.add(part_of(has, read_analogue_input_16_bit_object));
  parts.add(analogue_input_global_interrupt_enable_object);
}
/// Adds the objects of its outputs.
template <class Parts>
constexpr void add_outputs(Parts& parts, const OperatorEnvironment& has) {
  if (has.indicator_clusters > 0) {
    parts.add(part_of(has, write_output_8_bit_object));
    parts.add(part_of(has, error_mode_output_8_bit_object));
    parts.add(part_of(has, error_value_output_8_bit_object));
  }
  if (has.displays == 0) return;
  parts.add(part_of(has, write_analogue_output_16_bit_object));
  parts.add(part_of(has, analogue_output_error_mode_object));
  parts.add(part_of(has, analogue_output_error_value_integer_object));
  if (!has.display_floats) return;
  parts.add(part_of(has, write_analogue_output_float_object));
  parts.add(part_of(has, analogue_output_error_value_float_object));
}

/// Parameters of the existing elements.
template <class Parts>
constexpr void add_configuration(Parts& parts, const OperatorEnvironment& has) {
  const auto add = [&](Items<const ObjectInfo*> all, std::uint16_t index) {
    for (const ObjectInfo* object : all) {
      parts.add(Part(*object).keeping([&](unsigned sub) { return has_entry(has, index, sub); }));
    }
  };
  if (has_8_bit_inputs(has) || has.encoders > 0) {
    parts.add(cia401::global_interrupt_enable_digital_object);
  }
  if (has_8_bit_inputs(has)) {
    add(configuration::of_digital_inputs, read_input_8_bit_object.index);
  }
  if (has.encoders > 0) add(configuration::of_encoders, read_input_32_bit_object.index);
  if (has.indicator_clusters > 0) {
    add(configuration::of_indicators, write_output_8_bit_object.index);
  }
  if (!has_analogue_inputs(has)) return;
  add(configuration::of_analogue_inputs, read_analogue_input_16_bit_object.index);
  constexpr unsigned inputs_of_bank = 32;
  const unsigned highest = part_of(has, read_analogue_input_16_bit_object).highest_sub();
  parts.add(Part(cia401::analogue_input_interrupt_source_object)
                .up_to(pdos_for(highest, inputs_of_bank)));
}

/// Parts of such a device at most.
constexpr std::size_t capacity_for(const OperatorEnvironment& has) {
  const std::size_t others = 18 + (has.configuration ? 24 : 0);
  const std::size_t tpdos =
      has.joysticks + has.push_button_clusters + pdos_for(has.foot_pedals, foot_pedals_of_tpdo) +
      pdos_for(has.encoders, encoders_of_tpdo) + pdos_for(has.wheels, wheels_of_tpdo);
  const std::size_t rpdos =
      has.indicator_clusters + has.displays * pdos_for(has.display_parameters, parameters_of_rpdo);
  return others + 2 * (tpdos + rpdos);
}

/// Adds them to a DeviceDescription, or to a type like it.
template <class Parts>
constexpr void add_operator_environment(Parts& parts, const OperatorEnvironment& has) {
  parts.add(Part(device_type_object).initial(device_type(functions_of(has))));
  parts.add(error_register_object);
  parts.add(sync_cob_id_object);
  parts.add(emergency_cob_id_object);
  parts.add(emergency_inhibit_object);
  parts.add(Part(error_behavior_object).up_to(1));
  add_rpdos(parts, has);
  add_tpdos(parts, has);
  add_inputs(parts, has);
  add_outputs(parts, has);
  if (has.configuration) add_configuration(parts, has);
}

/// The objects that clause 12 and Annex A require of such a device, displays with integer values.
/// The maker adds identity and heartbeat producer, and for a device with outputs also consumers of
/// heartbeats and emergencies.
template <OperatorEnvironment has>
constexpr auto operator_environment() {
  check_elements(has);
  DeviceDescription<capacity_for(has)> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  add_operator_environment(parts, has);
  return parts;
}

}  // namespace canvoy::cia852
