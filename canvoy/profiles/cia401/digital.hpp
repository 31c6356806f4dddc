// Digital inputs and outputs of CiA 401, as public sources agree (indices, types, defaults). The
// text of CiA 401 is not at hand: there are no clauses, and no ranges but those of the types.
//
//     cia401::read_input_8_bit_object.index  // 6000h
#pragma once

#include "canvoy/profiles/cia401/values.hpp"

namespace canvoy::cia401 {

// Inputs.

inline constexpr auto read_input_8_bit_entries =
    channels(by_default(input(DataType::unsigned8, "Read input 8-bit #")));
inline constexpr auto read_input_8_bit_object = array(
    0x6000, "Read input 8-bit", read_input_8_bit_entries, "The states of 8 digital inputs each.");
inline constexpr auto polarity_input_8_bit_object =
    parameters<0x6002, "Polarity input 8-bit", unsigned8, 0, mask>("Which inputs are inverted.");
inline constexpr auto filter_constant_input_8_bit_object =
    parameters<0x6003, "Filter constant input 8-bit", unsigned8, 0, mask>(
        "Which inputs are filtered.");
inline constexpr auto global_interrupt_enable_digital_object = var_object(
    0x6005, "Global interrupt enable digital", "", "Whether digital inputs cause events at all.",
    entry(boolean, rw, no, 1, enabled_names), {.category = Category::optional});
inline constexpr auto interrupt_mask_any_change_8_bit_object =
    parameters<0x6006, "Interrupt mask any change 8-bit", unsigned8, 0xFF, mask>(
        "Which inputs cause an event when they change.");
inline constexpr auto interrupt_mask_low_to_high_8_bit_object =
    parameters<0x6007, "Interrupt mask low-to-high 8-bit", unsigned8, 0, mask>(
        "Which inputs cause an event when they are switched on.");
inline constexpr auto interrupt_mask_high_to_low_8_bit_object =
    parameters<0x6008, "Interrupt mask high-to-low 8-bit", unsigned8, 0, mask>(
        "Which inputs cause an event when they are switched off.");
inline constexpr auto read_input_bit_entries =
    channels(input(DataType::boolean, "Read input bit #"), 128);
inline constexpr auto read_input_bit_object =
    array_object(0x6020, "Read input bit, group #", "",
                 "The states of digital inputs one by one, 128 in each object.",
                 read_input_bit_entries, {.count = 8, .category = Category::optional});
inline constexpr auto read_input_16_bit_object =
    inputs<0x6100, "Read input 16-bit", unsigned16>("The states of 16 digital inputs each.");
inline constexpr auto polarity_input_16_bit_object =
    parameters<0x6102, "Polarity input 16-bit", unsigned16, 0, mask>("Which inputs are inverted.");
inline constexpr auto filter_constant_input_16_bit_object =
    parameters<0x6103, "Filter constant input 16-bit", unsigned16, 0, mask>(
        "Which inputs are filtered.");
inline constexpr auto interrupt_mask_any_change_16_bit_object =
    parameters<0x6106, "Interrupt mask any change 16-bit", unsigned16, 0xFFFF, mask>(
        "Which inputs cause an event when they change.");
inline constexpr auto interrupt_mask_low_to_high_16_bit_object =
    parameters<0x6107, "Interrupt mask low-to-high 16-bit", unsigned16, 0, mask>(
        "Which inputs cause an event when they are switched on.");
inline constexpr auto interrupt_mask_high_to_low_16_bit_object =
    parameters<0x6108, "Interrupt mask high-to-low 16-bit", unsigned16, 0, mask>(
        "Which inputs cause an event when they are switched off.");
inline constexpr auto read_input_32_bit_entries =
    channels(input(DataType::unsigned32, "Read input 32-bit #"));
inline constexpr auto read_input_32_bit_object =
    array(0x6120, "Read input 32-bit", read_input_32_bit_entries,
          "The states of 32 digital inputs each.");
inline constexpr auto polarity_input_32_bit_object =
    parameters<0x6122, "Polarity input 32-bit", unsigned32, 0, mask>("Which inputs are inverted.");
inline constexpr auto filter_constant_input_32_bit_object =
    parameters<0x6123, "Filter constant input 32-bit", unsigned32, 0, mask>(
        "Which inputs are filtered.");
inline constexpr auto interrupt_mask_any_change_32_bit_object =
    parameters<0x6126, "Interrupt mask any change 32-bit", unsigned32, 0xFFFF'FFFF, mask>(
        "Which inputs cause an event when they change.");
inline constexpr auto interrupt_mask_low_to_high_32_bit_object =
    parameters<0x6127, "Interrupt mask low-to-high 32-bit", unsigned32, 0, mask>(
        "Which inputs cause an event when they are switched on.");
inline constexpr auto interrupt_mask_high_to_low_32_bit_object =
    parameters<0x6128, "Interrupt mask high-to-low 32-bit", unsigned32, 0, mask>(
        "Which inputs cause an event when they are switched off.");

// Outputs.

inline constexpr auto write_output_8_bit_entries =
    channels(by_default(output(DataType::unsigned8, "Write output 8-bit #")));
inline constexpr auto write_output_8_bit_object =
    array(0x6200, "Write output 8-bit", write_output_8_bit_entries,
          "The states of 8 digital outputs each.");
inline constexpr auto change_polarity_output_8_bit_object =
    parameters<0x6202, "Change polarity output 8-bit", unsigned8, 0, mask>(
        "Which outputs are inverted.");
inline constexpr auto error_mode_output_8_bit_entries =
    channels(parameter(DataType::unsigned8, "Error mode output 8-bit #", 0xFF, mask));
inline constexpr auto error_mode_output_8_bit_object =
    array(0x6206, "Error mode output 8-bit", error_mode_output_8_bit_entries,
          "Which outputs take their error value when the device fails; the others keep theirs.");
inline constexpr auto error_value_output_8_bit_entries =
    channels(parameter(DataType::unsigned8, "Error value output 8-bit #", 0, mask));
inline constexpr auto error_value_output_8_bit_object =
    array(0x6207, "Error value output 8-bit", error_value_output_8_bit_entries,
          "What those outputs are switched to.");
inline constexpr auto filter_mask_output_8_bit_object =
    parameters<0x6208, "Filter mask output 8-bit", unsigned8, 0xFF, mask>(
        "Which outputs are written; the others keep their value.");
inline constexpr auto write_output_16_bit_object =
    outputs<0x6300, "Write output 16-bit", unsigned16>("The states of 16 digital outputs each.");
inline constexpr auto change_polarity_output_16_bit_object =
    parameters<0x6302, "Change polarity output 16-bit", unsigned16, 0, mask>(
        "Which outputs are inverted.");
inline constexpr auto error_mode_output_16_bit_object =
    parameters<0x6306, "Error mode output 16-bit", unsigned16, 0xFFFF, mask>(
        "Which outputs take their error value when the device fails; the others keep theirs.");
inline constexpr auto error_value_output_16_bit_object =
    parameters<0x6307, "Error value output 16-bit", unsigned16, 0, mask>(
        "What those outputs are switched to.");
inline constexpr auto filter_mask_output_16_bit_object =
    parameters<0x6308, "Filter mask output 16-bit", unsigned16, 0xFFFF, mask>(
        "Which outputs are written; the others keep their value.");
inline constexpr auto write_output_32_bit_object =
    outputs<0x6320, "Write output 32-bit", unsigned32>("The states of 32 digital outputs each.");
inline constexpr auto change_polarity_output_32_bit_object =
    parameters<0x6322, "Change polarity output 32-bit", unsigned32, 0, mask>(
        "Which outputs are inverted.");
inline constexpr auto error_mode_output_32_bit_object =
    parameters<0x6326, "Error mode output 32-bit", unsigned32, 0xFFFF'FFFF, mask>(
        "Which outputs take their error value when the device fails; the others keep theirs.");
inline constexpr auto error_value_output_32_bit_object =
    parameters<0x6327, "Error value output 32-bit", unsigned32, 0, mask>(
        "What those outputs are switched to.");
inline constexpr auto filter_mask_output_32_bit_object =
    parameters<0x6328, "Filter mask output 32-bit", unsigned32, 0xFFFF'FFFF, mask>(
        "Which outputs are written; the others keep their value.");

}  // namespace canvoy::cia401
