// CiA 852: joysticks, foot pedals, encoders, wheels and push-button clusters (9.2 to 9.6), as
// entries of the CiA 401 inputs.
//
//     // "Push-button cluster #: Switch 1-to-8"
//     find_entry(cia852::read_input_8_bit_object, 0x31)->name;
#pragma once

#include "canvoy/profiles/cia401/analogue.hpp"
#include "canvoy/profiles/cia401/digital.hpp"
#include "canvoy/profiles/cia852/values.hpp"

namespace canvoy::cia852 {

inline constexpr std::string_view if_joystick = "if the joystick is supported";
inline constexpr std::string_view if_foot_pedal = "if the foot pedal is supported";
inline constexpr std::string_view if_encoder = "if the encoder is supported";
inline constexpr std::string_view if_wheel = "if the wheel is supported";
inline constexpr std::string_view if_push_buttons = "if the push-buttons are supported";

inline constexpr std::string_view push_button_names[groups_of_cluster] = {
    "Push-button cluster #: Switch 1-to-8",   "Push-button cluster #: Switch 9-to-16",
    "Push-button cluster #: Switch 17-to-24", "Push-button cluster #: Switch 25-to-32",
    "Push-button cluster #: Switch 33-to-40", "Push-button cluster #: Switch 41-to-48",
    "Push-button cluster #: Switch 49-to-56", "Push-button cluster #: Switch 57-to-64"};
inline constexpr std::string_view axis_names[joystick_axes] = {
    "Joystick #: x-dimension", "Joystick #: y-dimension", "Joystick #: z-dimension"};

inline constexpr EntryInfo input_8_bit =
    entry(unsigned8, ro, by_default, {}, {.notation = Notation::bit_mask});
/// Eight inputs with these fields.
constexpr EntryInfo input_8_bit_with(Items<FieldInfo> fields, std::string_view description) {
  EntryInfo entry = input_8_bit;
  entry.fields = fields;
  entry.description = description;
  return entry;
}
inline constexpr EntryInfo joystick_memory_input =
    input_8_bit_with(joystick_memory_fields, "In which directions the position is held.");
inline constexpr EntryInfo joystick_buttons_input =
    input_8_bit_with(button_fields, "The buttons on the joystick.");
inline constexpr EntryInfo foot_pedal_memory_input =
    input_8_bit_with(foot_pedal_memory_fields, "Whether the position is held.");
inline constexpr EntryInfo push_buttons_input =
    input_8_bit_with(push_button_fields, "Eight push-buttons of a cluster.");
/// A position; no clause gives its unit.
inline constexpr EntryInfo input_16_bit =
    entry(integer16, ro, by_default, {}, {.counting = Counting::counts});
inline constexpr EntryInfo input_32_bit =
    entry(unsigned32, ro, by_default, {}, {.counting = Counting::counts});

/// The number of an entry is its sub-index (Tables 1, 2 and 5).
inline constexpr auto read_input_8_bit_entries = [] {
  constexpr unsigned last = push_buttons_sub(push_button_clusters_max, groups_of_cluster);
  std::array<EntryInfo, last + 1> entries{highest_sub_index};
  for (unsigned n = 1; n <= joysticks_max; ++n) {
    const unsigned memory = joystick_memory_sub(n);
    const unsigned buttons = joystick_buttons_sub(n);
    entries[memory] = element(memory, n, "Joystick #: Memory function", joystick_memory_input,
                              if_joystick, "9.2");
    entries[buttons] = element(buttons, n, "Joystick #: Up to 8 additional buttons",
                               joystick_buttons_input, if_joystick, "9.2");
  }
  for (unsigned n = 1; n <= foot_pedals_max; ++n) {
    const unsigned memory = foot_pedal_memory_sub(n);
    entries[memory] = element(memory, n, "Foot pedal #: Memory function", foot_pedal_memory_input,
                              if_foot_pedal, "9.3");
  }
  for (unsigned n = 1; n <= push_button_clusters_max; ++n) {
    for (unsigned group = 1; group <= groups_of_cluster; ++group) {
      const unsigned sub = push_buttons_sub(n, group);
      entries[sub] =
          element(sub, n, push_button_names[group - 1], push_buttons_input, if_push_buttons, "9.6");
      entries[sub].errata = "1";
    }
  }
  return entries;
}();
inline constexpr auto read_input_8_bit_object =
    array_object(cia401::read_input_8_bit_object.index, cia401::read_input_8_bit_object.name, "9",
                 "Buttons, push-buttons and memory functions.", read_input_8_bit_entries,
                 {.category = Category::optional, .errata = "1, 8, 14, 49"});

/// Table 3.
inline constexpr auto read_input_32_bit_entries = [] {
  std::array<EntryInfo, encoders_max + 1> entries{highest_sub_index};
  for (unsigned n = 1; n <= encoders_max; ++n) {
    entries[n] =
        element(encoder_position_sub(n), n, "Encoder #: Position", input_32_bit, if_encoder, "9.4");
  }
  return entries;
}();
inline constexpr auto read_input_32_bit_object =
    array_object(cia401::read_input_32_bit_object.index, cia401::read_input_32_bit_object.name,
                 "9.4", "Positions of encoders with one turn or many.", read_input_32_bit_entries,
                 {.category = Category::optional, .errata = "15, 49"});

/// The number of an entry is its sub-index (Tables 1, 2 and 4).
inline constexpr auto read_analogue_input_16_bit_entries = [] {
  std::array<EntryInfo, wheel_position_sub(wheels_max) + 1> entries{highest_sub_index};
  for (unsigned n = 1; n <= joysticks_max; ++n) {
    for (unsigned axis = 1; axis <= joystick_axes; ++axis) {
      const unsigned sub = joystick_axis_sub(n, axis);
      entries[sub] = element(sub, n, axis_names[axis - 1], input_16_bit, if_joystick, "9.2");
    }
  }
  for (unsigned n = 1; n <= foot_pedals_max; ++n) {
    const unsigned sub = foot_pedal_position_sub(n);
    entries[sub] = element(sub, n, "Foot pedal #: Position", input_16_bit, if_foot_pedal, "9.3");
    entries[sub].errata = "7";
  }
  for (unsigned n = 1; n <= wheels_max; ++n) {
    const unsigned sub = wheel_position_sub(n);
    entries[sub] = element(sub, n, "Wheel #: Position", input_16_bit, if_wheel, "9.5");
  }
  return entries;
}();
inline constexpr auto read_analogue_input_16_bit_object = array_object(
    cia401::read_analogue_input_16_bit_object.index, cia401::read_analogue_input_16_bit_object.name,
    "9", "Positions of joysticks, foot pedals and wheels.", read_analogue_input_16_bit_entries,
    {.category = Category::optional, .errata = "7, 13, 49"});

/// Tables 1, 2 and 4.
inline constexpr auto analogue_input_global_interrupt_enable_object =
    var_object(cia401::analogue_input_global_interrupt_enable_object.index,
               cia401::analogue_input_global_interrupt_enable_object.name, "9",
               "While it is FALSE, Operational is entered with emergency 0080h (8.6).",
               cia401::analogue_input_global_interrupt_enable_object.entry,
               {.category = Category::optional, .errata = "48, 49"});

}  // namespace canvoy::cia852
