// CiA 852: the functional elements and the objects that each of them needs (clause 12, Annex A).
// The code of an element is its bit in 1000h (Table 8).
//
//     cia852::functional_elements[0].name  // "Joystick"
#pragma once

#include "canvoy/profiles/cia852/communication.hpp"
#include "canvoy/profiles/cia852/pdo_objects.hpp"

namespace canvoy::cia852 {

/// Parameter and mapping objects of consecutive PDOs.
constexpr DeviceObject first_pdo(const ObjectInfo& object) {
  return {.index = object.index};
}
/// The PDOs of further elements, from the first record to the last.
constexpr DeviceObject more_pdos(const ObjectInfo& first, const ObjectInfo& last,
                                 std::string_view condition) {
  return {.index = first.index,
          .category = Category::conditional,
          .condition = condition,
          .last = last.index};
}
/// An object that the element may have.
constexpr DeviceObject optional_object(const ObjectInfo& object) {
  return {.index = object.index, .category = Category::optional};
}
/// An object that the element has on its own condition.
constexpr DeviceObject conditional_object(const ObjectInfo& object) {
  return {.index = object.index, .category = Category::conditional, .condition = object.condition};
}
inline constexpr std::string_view for_more = "if there are as many of the elements";

inline constexpr DeviceObject joystick_objects[] = {
    first_pdo(tpdo_parameter(joystick_tpdo(1))),
    more_pdos(tpdo_parameter(joystick_tpdo(2)), tpdo_parameter(joystick_tpdo(joysticks_max)),
              for_more),
    first_pdo(tpdo_mapping(joystick_tpdo(1))),
    more_pdos(tpdo_mapping(joystick_tpdo(2)), tpdo_mapping(joystick_tpdo(joysticks_max)), for_more),
    optional_object(read_input_8_bit_object),
    optional_object(read_analogue_input_16_bit_object),
    optional_object(analogue_input_global_interrupt_enable_object),
};
inline constexpr DeviceObject foot_pedal_objects[] = {
    first_pdo(tpdo_parameter(foot_pedal_tpdo(1))),
    more_pdos(tpdo_parameter(foot_pedal_tpdo(3)), tpdo_parameter(foot_pedal_tpdo(foot_pedals_max)),
              for_more),
    first_pdo(tpdo_mapping(foot_pedal_tpdo(1))),
    more_pdos(tpdo_mapping(foot_pedal_tpdo(3)), tpdo_mapping(foot_pedal_tpdo(foot_pedals_max)),
              for_more),
    optional_object(read_input_8_bit_object),
    optional_object(read_analogue_input_16_bit_object),
    optional_object(analogue_input_global_interrupt_enable_object),
};
inline constexpr DeviceObject encoder_objects[] = {
    first_pdo(tpdo_parameter(encoder_tpdo(1))),
    more_pdos(tpdo_parameter(encoder_tpdo(3)), tpdo_parameter(encoder_tpdo(encoders_max)),
              for_more),
    first_pdo(tpdo_mapping(encoder_tpdo(1))),
    more_pdos(tpdo_mapping(encoder_tpdo(3)), tpdo_mapping(encoder_tpdo(encoders_max)), for_more),
    optional_object(read_input_32_bit_object),
};
inline constexpr DeviceObject wheel_objects[] = {
    first_pdo(tpdo_parameter(wheel_tpdo(1))),
    more_pdos(tpdo_parameter(wheel_tpdo(5)), tpdo_parameter(wheel_tpdo(wheels_max)), for_more),
    first_pdo(tpdo_mapping(wheel_tpdo(1))),
    more_pdos(tpdo_mapping(wheel_tpdo(5)), tpdo_mapping(wheel_tpdo(wheels_max)), for_more),
    optional_object(read_analogue_input_16_bit_object),
    optional_object(analogue_input_global_interrupt_enable_object),
};
inline constexpr DeviceObject push_button_objects[] = {
    first_pdo(tpdo_parameter(push_button_tpdo(1))),
    more_pdos(tpdo_parameter(push_button_tpdo(2)),
              tpdo_parameter(push_button_tpdo(push_button_clusters_max)), for_more),
    first_pdo(tpdo_mapping(push_button_tpdo(1))),
    more_pdos(tpdo_mapping(push_button_tpdo(2)),
              tpdo_mapping(push_button_tpdo(push_button_clusters_max)), for_more),
    optional_object(read_input_8_bit_object),
};
inline constexpr DeviceObject indicator_objects[] = {
    first_pdo(rpdo_parameter(indicator_rpdo(1))),
    more_pdos(rpdo_parameter(indicator_rpdo(2)),
              rpdo_parameter(indicator_rpdo(indicator_clusters_max)), for_more),
    first_pdo(rpdo_mapping(indicator_rpdo(1))),
    more_pdos(rpdo_mapping(indicator_rpdo(2)), rpdo_mapping(indicator_rpdo(indicator_clusters_max)),
              for_more),
    optional_object(write_output_8_bit_object),
    optional_object(error_mode_output_8_bit_object),
    conditional_object(error_value_output_8_bit_object),
};
inline constexpr std::string_view for_more_parameters =
    "if there are as many displays and parameters";
inline constexpr DeviceObject display_objects[] = {
    first_pdo(rpdo_parameter(display_rpdo(1, 1))),
    more_pdos(rpdo_parameter(display_rpdo(1, 2)), rpdo_parameter(display_rpdo(1, 2)),
              for_more_parameters),
    more_pdos(rpdo_parameter(display_rpdo(1, 3)),
              rpdo_parameter(display_rpdo(displays_max, rpdos_of_display)), for_more_parameters),
    first_pdo(rpdo_mapping(display_rpdo(1, 1))),
    more_pdos(rpdo_mapping(display_rpdo(1, 2)), rpdo_mapping(display_rpdo(1, 2)),
              for_more_parameters),
    more_pdos(rpdo_mapping(display_rpdo(1, 3)),
              rpdo_mapping(display_rpdo(displays_max, rpdos_of_display)), for_more_parameters),
    optional_object(write_analogue_output_16_bit_object),
    optional_object(write_analogue_output_float_object),
    optional_object(analogue_output_error_mode_object),
    conditional_object(analogue_output_error_value_integer_object),
    conditional_object(analogue_output_error_value_float_object),
};

/// A functional element, by its bit in 1000h.
constexpr VirtualDeviceInfo functional_element(std::uint8_t bit, std::string_view name,
                                               Items<DeviceObject> objects, std::string_view clause,
                                               std::string_view description) {
  constexpr unsigned specific_functionality = 24;
  return {.code = static_cast<std::uint8_t>(1U << (bit - specific_functionality)),
          .name = name,
          .objects = objects,
          .clause = clause,
          .description = description};
}
inline constexpr VirtualDeviceInfo functional_elements[] = {
    functional_element(joystick_bit, "Joystick", joystick_objects, "9.2",
                       "1 to 3 axes, up to 8 buttons, and a memory function; up to 16 of them."),
    functional_element(foot_pedal_bit, "Foot-pedal", foot_pedal_objects, "9.3",
                       "One axis and a memory function; up to 16 of them."),
    functional_element(encoder_bit, "Encoder", encoder_objects, "9.4",
                       "A position of 32 bits; up to 8 of them."),
    functional_element(wheel_bit, "Wheel", wheel_objects, "9.5",
                       "A handle-twist or thumbwheel: one axis; up to 8 of them."),
    functional_element(push_button_cluster_bit, "Push-button cluster", push_button_objects, "9.6",
                       "Up to 64 push-buttons; up to 8 of them."),
    functional_element(indicator_cluster_bit, "Indicator cluster", indicator_objects, "9.7",
                       "Up to 64 indicators; up to 8 of them."),
    functional_element(display_bit, "Display", display_objects, "9.8",
                       "A matrix display, bar graph or round meter with up to 12 parameters; up to "
                       "8 of them."),
};

}  // namespace canvoy::cia852
