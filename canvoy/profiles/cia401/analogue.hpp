// Analogue inputs and outputs of CiA 401, as public sources agree (indices, types, defaults). The
// text of CiA 401 is not at hand: there are no clauses, and no ranges but those of the types.
//
//     cia401::read_analogue_input_16_bit_object.index  // 6401h
#pragma once

#include "canvoy/profiles/cia401/values.hpp"

namespace canvoy::cia401 {

// Values.

inline constexpr auto read_analogue_input_8_bit_object =
    inputs<0x6400, "Read analogue input 8-bit", integer8>();
inline constexpr auto read_analogue_input_16_bit_entries =
    channels(by_default(input(DataType::integer16, "Read analogue input 16-bit #")));
inline constexpr auto read_analogue_input_16_bit_object =
    array(0x6401, "Read analogue input 16-bit", read_analogue_input_16_bit_entries,
          "Values of up to 16 bits are adjusted to the left.");
inline constexpr auto read_analogue_input_32_bit_object =
    inputs<0x6402, "Read analogue input 32-bit", integer32>();
inline constexpr auto read_analogue_input_float_object =
    inputs<0x6403, "Read analogue input float", real32>();
inline constexpr auto write_analogue_output_8_bit_object =
    outputs<0x6410, "Write analogue output 8-bit", integer8>();
inline constexpr auto write_analogue_output_16_bit_object =
    outputs<0x6411, "Write analogue output 16-bit", integer16, Mapping::by_default>(
        "Values of up to 16 bits are adjusted to the left.");
inline constexpr auto write_analogue_output_32_bit_object =
    outputs<0x6412, "Write analogue output 32-bit", integer32>();
inline constexpr auto write_analogue_output_float_object =
    outputs<0x6413, "Write analogue output float", real32>();

// Configuration of inputs.

/// Conditions that cause an event, one bit each (6421h).
inline constexpr FieldInfo trigger_fields[] = {
    field(0, 1, "upper limit exceeded", enabled_names),
    field(1, 1, "input below lower limit", enabled_names),
    field(2, 1, "input changed by more than delta", enabled_names),
    field(3, 1, "input reduced by more than negative delta", enabled_names),
    field(4, 1, "input increased by more than positive delta", enabled_names),
};
/// The other bits are reserved.
inline constexpr ValueInfo triggers = {.limits = within(0, 0x1F), .notation = Notation::bit_mask};
inline constexpr auto analogue_input_interrupt_trigger_selection_entries =
    channels(sub_index(0, "Analogue input interrupt trigger selection #",
                       entry(unsigned8, rw, no, 0x07, triggers, trigger_fields)));
inline constexpr auto analogue_input_interrupt_trigger_selection_object =
    array(0x6421, "Analogue input interrupt trigger selection",
          analogue_input_interrupt_trigger_selection_entries, "Which events an input causes.");
inline constexpr auto analogue_input_interrupt_source_entries = channels(
    sub_index(0, "Analogue input interrupt source bank #", entry(unsigned32, ro, no, 0, mask)), 8);
inline constexpr auto analogue_input_interrupt_source_object =
    array(0x6422, "Analogue input interrupt source", analogue_input_interrupt_source_entries,
          "Which inputs caused an event, 32 in each bank; reading it clears it.");
inline constexpr auto analogue_input_global_interrupt_enable_object =
    var_object(0x6423, "Analogue input global interrupt enable", "",
               "Whether analogue inputs cause events at all: no TPDO is sent for them until then.",
               entry(boolean, rw, no, 0, enabled_names), {.category = Category::optional});
inline constexpr auto analogue_input_interrupt_upper_limit_integer_object =
    parameters<0x6424, "Analogue input interrupt upper limit integer", integer32, 0>(
        "An event, as long as the value is at or above it.");
inline constexpr auto analogue_input_interrupt_lower_limit_integer_object =
    parameters<0x6425, "Analogue input interrupt lower limit integer", integer32, 0>(
        "An event, as long as the value is below it.");
inline constexpr auto analogue_input_interrupt_delta_unsigned_object =
    parameters<0x6426, "Analogue input interrupt delta unsigned", unsigned32, 0>(
        "An event when the value has changed by as much since the last one.");
inline constexpr auto analogue_input_interrupt_negative_delta_unsigned_object =
    parameters<0x6427, "Analogue input interrupt negative delta unsigned", unsigned32, 0>(
        "The same, of values that fall.");
inline constexpr auto analogue_input_interrupt_positive_delta_unsigned_object =
    parameters<0x6428, "Analogue input interrupt positive delta unsigned", unsigned32, 0>(
        "The same, of values that rise.");
inline constexpr auto analogue_input_interrupt_upper_limit_float_object =
    parameters<0x6429, "Analogue input interrupt upper limit float", real32, 0>("As 6424h.");
inline constexpr auto analogue_input_interrupt_lower_limit_float_object =
    parameters<0x642A, "Analogue input interrupt lower limit float", real32, 0>("As 6425h.");
inline constexpr auto analogue_input_interrupt_delta_float_object =
    parameters<0x642B, "Analogue input interrupt delta float", real32, 0>("As 6426h.");
inline constexpr auto analogue_input_interrupt_negative_delta_float_object =
    parameters<0x642C, "Analogue input interrupt negative delta float", real32, 0>("As 6427h.");
inline constexpr auto analogue_input_interrupt_positive_delta_float_object =
    parameters<0x642D, "Analogue input interrupt positive delta float", real32, 0>("As 6428h.");
inline constexpr auto analogue_input_offset_float_object =
    parameters<0x642E, "Analogue input offset float", real32, 0>(
        "Added to the scaled value of 6403h.");
inline constexpr auto analogue_input_scaling_float_object =
    parameters<0x642F, "Analogue input scaling float", real32, 0x3F80'0000>(
        "Multiplies the value of 6403h; 1.0 by default.");
inline constexpr auto analogue_input_si_unit_object =
    parameters<0x6430, "Analogue input SI unit", unsigned32, 0, unit_code>(
        "Unit and prefix, by CiA 303-2.");
inline constexpr auto analogue_input_offset_integer_object =
    parameters<0x6431, "Analogue input offset integer", integer32, 0>(
        "Added to the scaled value of the integer objects.");
inline constexpr auto analogue_input_scaling_integer_object =
    parameters<0x6432, "Analogue input scaling integer", integer32, 1>(
        "Multiplies the value of the integer objects.");

// Configuration of outputs.

inline constexpr auto analogue_output_offset_float_object =
    parameters<0x6441, "Analogue output offset float", real32, 0>(
        "Added to the scaled value of 6413h.");
inline constexpr auto analogue_output_scaling_float_object =
    parameters<0x6442, "Analogue output scaling float", real32, 0x3F80'0000>(
        "Multiplies the value of 6413h; 1.0 by default.");
inline constexpr auto analogue_output_error_mode_object =
    parameters<0x6443, "Analogue output error mode", unsigned8, 1, error_mode_byte>(
        "Whether an output takes its error value when the device fails.");
inline constexpr auto analogue_output_error_value_integer_object =
    parameters<0x6444, "Analogue output error value integer", integer32, 0>(
        "What the output of an integer object is set to.");
inline constexpr auto analogue_output_error_value_float_object =
    parameters<0x6445, "Analogue output error value float", real32, 0>(
        "What the output of 6413h is set to.");
inline constexpr auto analogue_output_offset_integer_object =
    parameters<0x6446, "Analogue output offset integer", integer32, 0>(
        "Added to the scaled value of the integer objects.");
inline constexpr auto analogue_output_scaling_integer_object =
    parameters<0x6447, "Analogue output scaling integer", integer32, 1>(
        "Multiplies the value of the integer objects.");
inline constexpr auto analogue_output_si_unit_object =
    parameters<0x6450, "Analogue output SI unit", unsigned32, 0, unit_code>(
        "Unit and prefix, by CiA 303-2.");

}  // namespace canvoy::cia401
