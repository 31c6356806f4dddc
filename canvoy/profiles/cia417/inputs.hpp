// Buttons, keys and contacts of a lift: virtual inputs and the parameters of each (CiA 417-4, 4.2.3
// and 4.3).
//
//     cia417::input_group_object.count  // 32 groups of 254 inputs
#pragma once

#include "canvoy/profiles/cia417/functions.hpp"

namespace canvoy::cia417 {

inline constexpr std::uint16_t group_count = 32;

/// State of a virtual input (6010h, bits 0 and 1 of the last byte).
enum class CallRequest : std::uint8_t { none = 0, request = 1, defective = 2, not_installed = 3 };
inline constexpr NamedValue call_request_names[] = {
    {CallRequest::none, "no call request"},
    {CallRequest::request, "call request"},
    {CallRequest::defective, "function is defective", Meaning::failure},
    {CallRequest::not_installed, "function is not installed", Meaning::not_implemented},
};

inline constexpr NamedValue target_stop_names[] = {{0x00, "reserved", Meaning::reserved},
                                                   {0xFF, "reserved", Meaning::reserved}};
inline constexpr NamedValue lock_names[] = {{0, "without locking function"},
                                            {1, "with locking function"}};

/// Sub-functions that are not yet defined, or reserved with their basic function.
inline constexpr FieldCondition on_open_input_function[] = {
    function_is(BasicFunction::none, BasicFunction::generic),
    {basic_function_name, static_cast<std::int64_t>(BasicFunction::access_code_upload), 0x7F}};

/// A virtual input of 6 bytes, in 6010h and in 6100h to 611Fh.
inline constexpr auto virtual_input_fields = join_fields(
    field(0, 8, basic_function_name, input_function_names), hall_call_fields,
    field_when(on_target_stop, sub_function_bit, 8, "Target stop", {.names = target_stop_names},
               "The floor to which the car is to go from the source floor."),
    field_when(on_special_function, sub_function_bit, 8, "Special function",
               {.names = special_function_names}),
    field_when(on_open_input_function, sub_function_bit, 8, "Sub function",
               {.names = any_bits<8>, .notation = Notation::hexadecimal}, "To be defined."),
    field_when(on_manufacturer_function, sub_function_bit, 8, "Sub function",
               {.names = manufacturer_8, .notation = Notation::hexadecimal}),
    lift_bits(16, "Source lift #", request_bit),
    field(24, 8, "Source panel", source_floor, "The floor at which the input is."),
    door_bits(32, "Dest. door #", request_bit), door_bits(36, "Source door #", request_bit),
    field(40, 2, "Call request", call_request_names), reserved_zeros<5>(42, 2),
    field(47, 1, "Lock", lock_names));

inline constexpr auto virtual_input_mapping_object =
    var_object(0x6010, "Virtual input mapping", "4.2.3",
               "The input that is sent next: a copy of the one that has changed.",
               provided({.type = DataType::unsigned48,
                         .mapping = Mapping::by_default,
                         .initial = 0,
                         .value = hexadecimal,
                         .fields = virtual_input_fields}),
               {.condition = "if input groups are implemented", .errata = "A6"});

inline constexpr EntryInfo supported_inputs =
    count_entry("Number of supported inputs", 0x01, last_of_many);
inline constexpr EntryInfo virtual_input_entry = provided(sub_index(
    0, "Virtual input #", entry(unsigned48, ro, no, {}, hexadecimal, virtual_input_fields)));
inline constexpr EntryInfo input_group_entries[] = {
    supported_inputs, at(1, virtual_input_entry),
    optional_at(2, last_of_many, virtual_input_entry)};
inline constexpr auto input_group_object = array_object(
    0x6100, "Input group #", "4.3.1", "State, function and place of up to 254 digital inputs.",
    input_group_entries, {.count = group_count, .condition = see_part_2, .errata = "B31"});

// Parameters of inputs.

/// One parameter of all inputs of a group.
constexpr EntryInfo input_parameter(std::string_view name, Items<FieldInfo> fields) {
  return sub_index(0, name,
                   entry(unsigned32, rw, no, {},
                         {.names = not_used_32, .notation = Notation::hexadecimal}, fields));
}

inline constexpr NamedValue enable_names[] = {{0, "disabled"}, {1, "enabled"}};
inline constexpr FieldInfo input_parameter_1_fields[] = {
    field(0, 1, "Enable", enable_names), reserved_bits<7>(1, 1),
    field(8, 8, "Error code", {.names = not_used_8, .notation = Notation::hexadecimal}),
    reserved_ones<16>(16, 2)};
inline constexpr EntryInfo input_parameter_1 =
    input_parameter("Parameter 1 input #", input_parameter_1_fields);
inline constexpr EntryInfo input_parameter_1_entries[] = {
    supported_inputs, at(1, input_parameter_1),
    conditional_at(2, last_of_many, input_parameter_1, "if the input is implemented")};
inline constexpr auto input_parameter_1_object =
    array_object(0x6120, "Input parameter 1 group #", "4.3.2",
                 "System behaviour: whether the inputs are enabled, and what is wrong with them.",
                 input_parameter_1_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "A24, B19"});

inline constexpr ValueInfo events_per_second = {.unit = Unit::per_second, .names = count_names};
inline constexpr FieldInfo input_parameter_2_fields[] = {
    reserved_ones<8>(0, 1),
    field(8, 8, "Limitation", events_per_second, "More events are not accepted."),
    field(16, 8, "Sending event", events_per_second, "As many events lead to a message."),
    reserved_ones<8>(24, 2)};
inline constexpr EntryInfo input_parameter_2 =
    input_parameter("Parameter 2 input #", input_parameter_2_fields);
inline constexpr EntryInfo input_parameter_2_entries[] = {
    supported_inputs, optional_at(1, last_of_many, input_parameter_2)};
inline constexpr auto input_parameter_2_object =
    array_object(0x6140, "Input parameter 2 group #", "4.3.3",
                 "Logical behaviour: how often the inputs may change.", input_parameter_2_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "B19"});

inline constexpr ValueInfo debounce_time = {.unit = Unit::millisecond, .names = not_used_8};
inline constexpr NamedValue edge_names[] = {{0, "not sent"}, {1, "sent"}};
inline constexpr NamedValue polarity_names[] = {{0, "not inverted"}, {1, "inverted"}};
inline constexpr std::array debounce_and_edge_fields = {
    field(0, 8, "Debounce time", debounce_time), field(8, 1, "LH edge", edge_names),
    field(9, 1, "HL edge", edge_names), reserved_ones<5>(10, 1),
    field(15, 1, "Polarity", polarity_names)};
inline constexpr auto input_parameter_3_fields =
    join_fields(debounce_and_edge_fields, reserved_ones<16>(16, 2));
inline constexpr EntryInfo input_parameter_3 =
    input_parameter("Parameter 3 input #", input_parameter_3_fields);
inline constexpr EntryInfo input_parameter_3_entries[] = {
    supported_inputs, optional_at(1, last_of_many, input_parameter_3)};
inline constexpr auto input_parameter_3_object = array_object(
    0x6160, "Input parameter 3 group #", "4.3.4",
    "Physical behaviour: debouncing, edges that are sent, polarity.", input_parameter_3_entries,
    {.count = group_count, .condition = see_part_2, .errata = "B19, C6"});

inline constexpr FieldInfo input_parameter_4_fields[] = {reserved_bits<32>(0)};
inline constexpr EntryInfo input_parameter_4 =
    input_parameter("Parameter 4 input #", input_parameter_4_fields);
inline constexpr EntryInfo input_parameter_4_entries[] = {
    supported_inputs, optional_at(1, last_of_many, input_parameter_4)};
inline constexpr auto input_parameter_4_object = array_object(
    0x6180, "Input parameter 4 group #", "4.3.5", "Reserved.", input_parameter_4_entries,
    {.count = group_count, .condition = see_part_2, .errata = "B10, B19"});

}  // namespace canvoy::cia417
