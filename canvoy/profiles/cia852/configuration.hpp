// Parameters of inputs and outputs that a network can configure as in CiA 401, for the elements of
// an operator environment (clause 15: optional). The sub-index is that of the input or output.
//
//     find_entry(cia852::configuration::delta_object, 0x41)->sub_last  // 48h: the wheels
#pragma once

#include "canvoy/profiles/cia852/inputs.hpp"
#include "canvoy/profiles/cia852/outputs.hpp"

namespace canvoy::cia852::configuration {

/// Sub-index 00h, and a row of entries for each kind of element.
template <std::size_t kinds>
using Rows = std::array<EntryInfo, kinds + 1>;

/// Entries of a kind of element in an object of CiA 401.
constexpr EntryInfo row(const ObjectInfo& generic, unsigned first, unsigned last,
                        std::string_view condition) {
  EntryInfo entry = *find_entry(generic, 1);
  entry.sub_first = static_cast<std::uint8_t>(first);
  entry.sub_last = static_cast<std::uint8_t>(last);
  // "#" in its name is the number of the element of the array.
  entry.first_number = static_cast<std::uint16_t>(first);
  entry.category = Category::conditional;
  entry.condition = condition;
  entry.clause = "15";
  return entry;
}
/// Joysticks, pedals and push-buttons.
constexpr Rows<3> rows_of_digital_inputs(const ObjectInfo& generic) {
  constexpr unsigned last_of_joysticks = joystick_buttons_sub(joysticks_max);
  constexpr unsigned last_of_buttons =
      push_buttons_sub(push_button_clusters_max, groups_of_cluster);
  return {{highest_sub_index, row(generic, 1, last_of_joysticks, if_joystick),
           row(generic, foot_pedal_memory_sub(1), foot_pedal_memory_sub(foot_pedals_max),
               if_foot_pedal),
           row(generic, push_buttons_sub(1, 1), last_of_buttons, if_push_buttons)}};
}
/// Joysticks, pedals and wheels.
constexpr Rows<3> rows_of_analogue_inputs(const ObjectInfo& generic) {
  constexpr unsigned last_of_joysticks = joystick_axis_sub(joysticks_max, joystick_axes);
  return {{highest_sub_index, row(generic, 1, last_of_joysticks, if_joystick),
           row(generic, foot_pedal_position_sub(1), foot_pedal_position_sub(foot_pedals_max),
               if_foot_pedal),
           row(generic, wheel_position_sub(1), wheel_position_sub(wheels_max), if_wheel)}};
}
/// Positions of encoders.
constexpr Rows<1> rows_of_encoders(const ObjectInfo& generic) {
  return {{highest_sub_index,
           row(generic, encoder_position_sub(1), encoder_position_sub(encoders_max), if_encoder)}};
}
/// Groups of indicators.
constexpr Rows<1> rows_of_indicators(const ObjectInfo& generic) {
  constexpr unsigned last = indicators_sub(indicator_clusters_max, groups_of_cluster);
  return {{highest_sub_index, row(generic, 1, last, if_indicators)}};
}

/// The object of CiA 401 with the entries of this profile.
constexpr ObjectInfo with(const ObjectInfo& generic, Items<EntryInfo> entries) {
  ObjectInfo object = generic;
  object.clause = "15";
  object.subs = entries;
  return object;
}

/// Objects of CiA 401, with the rows of inputs or outputs.
template <const ObjectInfo& generic>
inline constexpr auto digital_input_rows = rows_of_digital_inputs(generic);
template <const ObjectInfo& generic>
inline constexpr ObjectInfo digital_input = with(generic, digital_input_rows<generic>);
template <const ObjectInfo& generic>
inline constexpr auto analogue_input_rows = rows_of_analogue_inputs(generic);
template <const ObjectInfo& generic>
inline constexpr ObjectInfo analogue_input = with(generic, analogue_input_rows<generic>);
template <const ObjectInfo& generic>
inline constexpr auto encoder_rows = rows_of_encoders(generic);
template <const ObjectInfo& generic>
inline constexpr ObjectInfo encoder = with(generic, encoder_rows<generic>);
template <const ObjectInfo& generic>
inline constexpr auto indicator_rows = rows_of_indicators(generic);
template <const ObjectInfo& generic>
inline constexpr ObjectInfo indicator = with(generic, indicator_rows<generic>);

inline constexpr const ObjectInfo* of_digital_inputs[] = {
    &digital_input<cia401::polarity_input_8_bit_object>,
    &digital_input<cia401::filter_constant_input_8_bit_object>,
    &digital_input<cia401::interrupt_mask_any_change_8_bit_object>,
    &digital_input<cia401::interrupt_mask_low_to_high_8_bit_object>,
    &digital_input<cia401::interrupt_mask_high_to_low_8_bit_object>,
};
/// Encoders have no filter: their inputs change all the time.
inline constexpr const ObjectInfo* of_encoders[] = {
    &encoder<cia401::polarity_input_32_bit_object>,
    &encoder<cia401::interrupt_mask_any_change_32_bit_object>,
    &encoder<cia401::interrupt_mask_low_to_high_32_bit_object>,
    &encoder<cia401::interrupt_mask_high_to_low_32_bit_object>,
};
inline constexpr const ObjectInfo& delta_object =
    analogue_input<cia401::analogue_input_interrupt_delta_unsigned_object>;
inline constexpr const ObjectInfo* of_analogue_inputs[] = {
    &analogue_input<cia401::analogue_input_interrupt_trigger_selection_object>,
    &analogue_input<cia401::analogue_input_interrupt_upper_limit_integer_object>,
    &analogue_input<cia401::analogue_input_interrupt_lower_limit_integer_object>,
    &delta_object,
    &analogue_input<cia401::analogue_input_interrupt_negative_delta_unsigned_object>,
    &analogue_input<cia401::analogue_input_interrupt_positive_delta_unsigned_object>,
    &analogue_input<cia401::analogue_input_offset_integer_object>,
    &analogue_input<cia401::analogue_input_scaling_integer_object>,
};
inline constexpr const ObjectInfo* of_indicators[] = {
    &indicator<cia401::change_polarity_output_8_bit_object>,
    &indicator<cia401::filter_mask_output_8_bit_object>,
};

}  // namespace canvoy::cia852::configuration
