// Lamps, displays and loudspeakers of a lift: virtual outputs and the parameters of each (CiA
// 417-4, 4.2.4, 4.4 and 4.5).
//
//     cia417::output_group_object.count  // 32 groups of 254 outputs
#pragma once

#include "canvoy/profiles/cia417/inputs.hpp"

namespace canvoy::cia417 {

/// The sub-function of BasicFunction::special_indication.
enum class SpecialIndication : std::uint8_t {
  all_off = 0x00,
  no_load = 0x01,
  full_load = 0x02,
  overload = 0x03,
  fire = 0x04,
  fire_brigade_service = 0x05,
  help_is_coming = 0x06,
  special_service = 0x07,
  load_time = 0x08,
  occupied = 0x09,
  out_of_order = 0x0A,
};
/// Errata A4.
inline constexpr NamedValue special_indication_names[] = {
    {SpecialIndication::all_off, "all displays off"},
    {SpecialIndication::no_load, "No load"},
    {SpecialIndication::full_load, "Full load"},
    {SpecialIndication::overload, "Over load"},
    {SpecialIndication::fire, "Fire"},
    {SpecialIndication::fire_brigade_service, "Fire brigade service"},
    {SpecialIndication::help_is_coming, "Help is coming"},
    {SpecialIndication::special_service, "Special service"},
    {SpecialIndication::load_time, "Load time"},
    {SpecialIndication::occupied, "Occupied"},
    {SpecialIndication::out_of_order, "Out of order"},
    {0x0B, 0xFF, "reserved", Meaning::reserved},
};

inline constexpr NamedValue target_acknowledgement_names[] = {{0x00, "reserved", Meaning::reserved},
                                                              {0xFF, "all target stop buttons"}};
inline constexpr NamedValue floor_data_names[] = {{0x00, "clear the display"},
                                                  {0xFF, "reserved", Meaning::reserved}};

// The last byte: the property and its parameter.

/// Form in which a virtual output is shown (6011h, bits 1 to 3 of the last byte).
enum class Property : std::uint8_t {
  standard = 0,
  continuous = 1,
  impulse = 2,
  flashing = 3,
  color = 4,
  volume = 5,
  scroll_rate = 6,
};
inline constexpr NamedValue property_names[] = {
    {Property::standard, "Default"},
    {Property::continuous, "continuous"},
    {Property::impulse, "impulse"},
    {Property::flashing, "flashing"},
    {Property::color, "color"},
    {Property::volume, "volume"},
    {Property::scroll_rate, "scroll rate"},
    {7, "reserved", Meaning::reserved},
};
inline constexpr NamedValue impulse_names[] = {{0, "0.5 s"}, {1, "1 s"}, {2, "1.5 s"}, {3, "2 s"},
                                               {4, "3 s"},   {5, "5 s"}, {6, "10 s"},  {7, "15 s"}};
inline constexpr NamedValue flashing_names[] = {{0, "10 Hz"},  {1, "7.5 Hz"}, {2, "5 Hz"},
                                                {3, "2 Hz"},   {4, "1.5 Hz"}, {5, "1 Hz"},
                                                {6, "0.5 Hz"}, {7, "0.25 Hz"}};
// Codes of impulse_names and flashing_names as times and frequencies.
inline constexpr Piece impulse_times[] = {{0, 3, {.denominator = 2, .offset = 1}},
                                          {4, 4, {.offset = -1}},
                                          {5, 5},
                                          {6, 6, {.offset = 4}},
                                          {7, 7, {.offset = 8}}};
inline constexpr Piece flash_frequencies[] = {
    {0, 2, {.numerator = -5, .denominator = 2, .offset = 20}},
    {3, 6, {.numerator = -1, .denominator = 2, .offset = 7}},
    {7, 7, {.denominator = 4, .offset = -6}}};
/// Color of a virtual output with property color.
enum class Color : std::uint8_t { white = 0, yellow = 1, green = 3, red = 5, blue = 7 };
inline constexpr NamedValue color_names[] = {{Color::white, "white"},
                                             {Color::yellow, "yellow"},
                                             {2, "reserved", Meaning::reserved},
                                             {Color::green, "green"},
                                             {4, "reserved", Meaning::reserved},
                                             {Color::red, "red"},
                                             {6, "reserved", Meaning::reserved},
                                             {Color::blue, "blue"}};
inline constexpr NamedValue volume_names[] = {
    {0, "min."}, {1, 6, "vary", Meaning::state}, {7, "max."}};
inline constexpr NamedValue scroll_names[] = {{0, "automatic"}};

inline constexpr std::string_view property_name = "Property";
/// Condition that the property of the output is this one.
constexpr FieldCondition property_is(Property property) {
  return {property_name, static_cast<std::int64_t>(property), static_cast<std::int64_t>(property)};
}
inline constexpr FieldCondition on_plain_property[] = {
    property_is(Property::standard), property_is(Property::continuous), {property_name, 7, 7}};
inline constexpr FieldCondition on_impulse[] = {property_is(Property::impulse)};
inline constexpr FieldCondition on_flashing[] = {property_is(Property::flashing)};
inline constexpr FieldCondition on_color[] = {property_is(Property::color)};
inline constexpr FieldCondition on_volume[] = {property_is(Property::volume)};
inline constexpr FieldCondition on_scroll_rate[] = {property_is(Property::scroll_rate)};

inline constexpr NamedValue status_names[] = {{0, "no data indicated"}, {1, "data indicated"}};
inline constexpr NamedValue predicate_names[] = {{0, "acknowledgement is not affirmed"},
                                                 {1, "acknowledgement is affirmed"}};

/// State, property with its parameter, and predicate of an output, from bit `first` on.
constexpr std::array<FieldInfo, 9> output_data_fields(unsigned first) {
  return {field(first, 1, "Status", status_names),
          field(first + 1, 3, property_name, property_names),
          field_when(on_plain_property, first + 4, 3, "Property parameter", {.names = any_bits<3>}),
          field_when(on_impulse, first + 4, 3, "Impulse",
                     {.unit = Unit::second, .names = impulse_names, .pieces = impulse_times}),
          field_when(on_flashing, first + 4, 3, "Flashing",
                     {.unit = Unit::hertz, .names = flashing_names, .pieces = flash_frequencies}),
          field_when(on_color, first + 4, 3, "Color", {.names = color_names}),
          field_when(on_volume, first + 4, 3, "Volume", {.names = volume_names}),
          field_when(on_scroll_rate, first + 4, 3, "Scroll rate",
                     {.unit = Unit::line_per_second, .names = scroll_names}),
          field(first + 7, 1, "Predicate", predicate_names)};
}

// The second byte, by basic function.

/// Reserved sub-functions, some of them with their basic function.
inline constexpr FieldCondition on_reserved_output_function[] = {
    function_is(BasicFunction::none, BasicFunction::generic),
    {basic_function_name, static_cast<std::int64_t>(BasicFunction::access_code_upload), 0x3F},
    {basic_function_name, static_cast<std::int64_t>(BasicFunction::operation_data), 0x7F}};
inline constexpr FieldCondition on_position_indicator[] = {
    function_is(BasicFunction::position_indicator)};
inline constexpr FieldCondition on_arrow[] = {
    function_is(BasicFunction::hall_lantern, BasicFunction::direction_indication)};
inline constexpr FieldCondition on_arrow_or_arrival[] = {
    function_is(BasicFunction::hall_lantern, BasicFunction::direction_indication),
    function_is(BasicFunction::arrival_indication)};
inline constexpr FieldCondition on_special_indication[] = {
    function_is(BasicFunction::special_indication)};
inline constexpr FieldCondition on_arrival[] = {function_is(BasicFunction::arrival_indication)};
inline constexpr NamedValue moving_names[] = {{0, "the car stands"}, {1, "the car moves"}};

inline constexpr std::array indication_fields = {
    field_when(on_position_indicator, sub_function_bit, 8, "Floor data",
               {.names = floor_data_names}, "The floor that is shown."),
    field_when(on_arrow_or_arrival, sub_function_bit, 1, "Up"),
    field_when(on_arrow_or_arrival, sub_function_bit + 1, 1, "Down"),
    field_when(on_arrow, sub_function_bit + 2, 1, "Right"),
    field_when(on_arrow, sub_function_bit + 3, 1, "Left"),
    field_when(on_arrow, sub_function_bit + 4, 1, "Moving", {.names = moving_names}),
    reserved_zeros<3>(sub_function_bit + 5, 2, on_arrow),
    field_when(on_special_indication, sub_function_bit, 8, "Special indication",
               {.names = special_indication_names}),
    reserved_zeros<6>(sub_function_bit + 2, 3, on_arrival),
};

/// A virtual output of 6 bytes, in 6011h and in 6200h to 621Fh.
inline constexpr auto virtual_output_fields = join_fields(
    field(0, 8, basic_function_name, output_function_names), hall_call_fields,
    field_when(on_target_stop, sub_function_bit, 8, "Target stop acknowledgement",
               {.names = target_acknowledgement_names}, "The button that is to answer."),
    field_when(on_special_function, sub_function_bit, 8, "Special function acknowledgement",
               {.names = special_acknowledgement_names}),
    indication_fields,
    field_when(on_reserved_output_function, sub_function_bit, 8, "Sub-function",
               {.names = any_bits<8>, .notation = Notation::hexadecimal}),
    field_when(on_manufacturer_function, sub_function_bit, 8, "Sub-function",
               {.names = manufacturer_8, .notation = Notation::hexadecimal}),
    lift_bits(16, "Destination lift #"),
    field(24, 8, "Destination panel", destination_floor, "The floor that is to look."),
    door_bits(32, "Dest. button #"), door_bits(36, "Dest. door #"), output_data_fields(40));

inline constexpr auto virtual_output_mapping_object =
    var_object(0x6011, "Virtual output mapping", "4.2.4",
               "The output that has come last, to be put into an output group.",
               provided({.type = DataType::unsigned48,
                         .mapping = Mapping::by_default,
                         .initial = 0,
                         .value = hexadecimal,
                         .fields = virtual_output_fields}),
               {.condition = "if output groups are implemented", .errata = "A6, B9"});

inline constexpr EntryInfo supported_outputs =
    count_entry("Number of supported outputs", 0x01, last_of_many);
inline constexpr EntryInfo virtual_output_entry = provided(sub_index(
    0, "Virtual output #", entry(unsigned48, ro, no, 0, hexadecimal, virtual_output_fields)));
inline constexpr EntryInfo output_group_entries[] = {
    supported_outputs, at(1, virtual_output_entry),
    optional_at(2, last_of_many, virtual_output_entry)};
inline constexpr auto output_group_object = array_object(
    0x6200, "Output group #", "4.4.1", "State, function and place of up to 254 digital outputs.",
    output_group_entries,
    {.count = group_count, .condition = see_part_2, .errata = "A4, A5, A6, A22, B9, B31, C4"});

// Parameters of the output panel unit.

/// One of the four parameters of an output.
constexpr EntryInfo output_parameter(std::string_view name, Items<FieldInfo> fields) {
  return input_parameter(name, fields);
}

/// Errata B11: no code is defined.
inline constexpr NamedValue output_error_names[] = {{0x00, 0xFE, "reserved", Meaning::reserved},
                                                    {0xFF, "not used", Meaning::invalid}};
inline constexpr FieldInfo output_parameter_1_fields[] = {
    field(0, 1, "Enable", enable_names), reserved_bits<7>(1, 1),
    field(8, 8, "Error code", {.names = output_error_names, .notation = Notation::hexadecimal}),
    reserved_ones<8>(16, 2),
    field(24, 8, "Default value", {.names = not_used_8, .notation = Notation::hexadecimal},
          "The function data of the output after power-on.")};
inline constexpr EntryInfo output_parameter_1 =
    output_parameter("Parameter 1 output #", output_parameter_1_fields);
inline constexpr EntryInfo output_parameter_1_entries[] = {
    supported_outputs, at(1, output_parameter_1),
    conditional_at(2, last_of_many, output_parameter_1, "if the output is implemented")};
inline constexpr auto output_parameter_1_object =
    array_object(0x6220, "Output parameter 1 group #", "4.5.1",
                 "System behaviour: enabled or not, error, and the value after power-on.",
                 output_parameter_1_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "A7, A24, B11, B19"});

inline constexpr FieldInfo output_parameter_2_fields[] = {
    reserved_ones<8>(0),
    field(8, 8, "Limitation", events_per_second, "More events are not accepted."),
    field(16, 8, "Reception event", count_names, "As many messages lead to an output event."),
    field(24, 8, "Impulse time",
          {.unit = Unit::second, .scale = {.denominator = 10}, .names = not_used_8},
          "How long the output stays active; messages meanwhile are not processed.")};
inline constexpr EntryInfo output_parameter_2 =
    output_parameter("Parameter 2 output #", output_parameter_2_fields);
inline constexpr EntryInfo output_parameter_2_entries[] = {
    supported_outputs, optional_at(1, last_of_many, output_parameter_2)};
inline constexpr auto output_parameter_2_object =
    array_object(0x6240, "Output parameter 2 group #", "4.5.2",
                 "Logical behaviour: how often and for how long the outputs are activated.",
                 output_parameter_2_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "B19, B28"});

inline constexpr FieldInfo output_parameter_3_fields[] = {
    reserved_ones<8>(0, 1), reserved_ones<7>(8, 2), field(15, 1, "Polarity", polarity_names),
    reserved_ones<16>(16, 3)};
inline constexpr EntryInfo output_parameter_3 =
    output_parameter("Parameter 3 output #", output_parameter_3_fields);
inline constexpr EntryInfo output_parameter_3_entries[] = {
    supported_outputs, optional_at(1, last_of_many, output_parameter_3)};
inline constexpr auto output_parameter_3_object =
    array_object(0x6260, "Output parameter 3 group #", "4.5.3", "Physical behaviour: polarity.",
                 output_parameter_3_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "B19, C6"});

inline constexpr NamedValue flash_rate_names[] = {{0x00, "always set"},
                                                  {0xFF, "not used", Meaning::invalid}};
inline constexpr NamedValue intensity_names[] = {{0x00, "reserved", Meaning::reserved},
                                                 {0x01, "minimal"},
                                                 {0xFE, "maximum"},
                                                 {0xFF, "not used", Meaning::invalid}};
inline constexpr NamedValue color_code_names[] = {{0x00, 0xFE, "to be defined", Meaning::reserved},
                                                  {0xFF, "not used", Meaning::invalid}};
inline constexpr FieldInfo output_parameter_4_fields[] = {
    field(0, 8, "Flash rate",
          {.unit = Unit::hertz, .scale = {.denominator = 10}, .names = flash_rate_names}),
    field(8, 8, "Scroll rate", {.unit = Unit::line_per_second, .names = not_used_8},
          "In sevenths of the height of a character."),
    field(16, 8, "Color", {.names = color_code_names, .notation = Notation::hexadecimal}),
    field(24, 8, "Intensity/Volume", {.names = intensity_names, .counting = Counting::counts})};
inline constexpr EntryInfo output_parameter_4 =
    output_parameter("Parameter 4 output #", output_parameter_4_fields);
inline constexpr EntryInfo output_parameter_4_entries[] = {
    supported_outputs, optional_at(1, last_of_many, output_parameter_4)};
inline constexpr auto output_parameter_4_object =
    array_object(0x6280, "Output parameter 4 group #", "4.5.4",
                 "Basic setting: flashing, scrolling, color, and how bright or loud.",
                 output_parameter_4_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "B19, B28"});

}  // namespace canvoy::cia417
