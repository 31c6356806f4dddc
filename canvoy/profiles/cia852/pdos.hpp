// CiA 852: the PDO parameter sets of clause 12. All are invalid by default, and have transmission
// type FFh.
//
// TPDO n is at 1800h + n - 1 and 1A00h + n - 1, as in CiA 301. Clause 12 prints the indices of TPDO
// 20 and above one higher (errata 16 to 19), and some devices may follow it: that is the reading
// `printed-tpdos`.
//
//     cia852::tpdo_mapping(cia852::joystick_tpdo(2)).index  // 1A04h
#pragma once

#include "canvoy/profiles/cia301/channels.hpp"
#include "canvoy/profiles/cia852/inputs.hpp"
#include "canvoy/profiles/cia852/outputs.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::cia852 {

// Contents of the PDOs (12.2.1 to 12.2.14; errata 21, 25, 36).

inline constexpr unsigned foot_pedals_of_tpdo = 2;
inline constexpr unsigned encoders_of_tpdo = 2;
inline constexpr unsigned wheels_of_tpdo = 4;
inline constexpr unsigned rpdos_of_display = 3;
inline constexpr unsigned parameters_of_rpdo = parameters_of_display / rpdos_of_display;

/// Number of the TPDO of a joystick.
constexpr unsigned joystick_tpdo(unsigned joystick) {
  return joystick == 1 ? 1 : 3 + joystick;
}
/// Number of the TPDO of a foot pedal.
constexpr unsigned foot_pedal_tpdo(unsigned pedal) {
  return 20 + (pedal - 1) / foot_pedals_of_tpdo;
}
/// Number of the TPDO of an encoder.
constexpr unsigned encoder_tpdo(unsigned encoder) {
  return 28 + (encoder - 1) / encoders_of_tpdo;
}
/// Number of the TPDO of a wheel.
constexpr unsigned wheel_tpdo(unsigned wheel) {
  return 32 + (wheel - 1) / wheels_of_tpdo;
}
/// Number of the TPDO of a push-button cluster.
constexpr unsigned push_button_tpdo(unsigned cluster) {
  return 33 + cluster;
}
/// Number of the RPDO of an indicator cluster.
constexpr unsigned indicator_rpdo(unsigned cluster) {
  return cluster == 1 ? 1 : 3 + cluster;
}
/// `part`: 1 has parameters 1 to 4, 2 has 5 to 8, 3 has 9 to 12.
constexpr unsigned display_rpdo(unsigned display, unsigned part) {
  constexpr unsigned of_display_1[] = {2, 4, 12};
  if (display == 1) return of_display_1[part - 1];
  return 13 + rpdos_of_display * (display - 2) + part - 1;
}

// Communication parameters. The device chooses between "rw or const".

/// The entry as rw; a device may have it as const.
constexpr EntryInfo rw_or_const(EntryInfo entry) {
  entry.access = Access::rw;
  entry.or_const = true;
  return entry;
}
inline constexpr EntryInfo tpdo_highest_sub_index =
    sub_index(0, "Highest sub-index supported",
              entry(unsigned8, const_, no, highest_sub(), {.limits = within(2, 6)}));
inline constexpr EntryInfo rpdo_highest_sub_index = sub_index(
    0, "Highest sub-index supported",
    entry(unsigned8, const_, no, highest_sub(), {.limits = within(2, 5)}), {.errata = "30"});
/// Sub-index 01h with this default.
constexpr EntryInfo cob_id_entry(Default initial) {
  return rw_or_const(sub_index(
      1, "COB-ID", entry(unsigned32, ro, no, initial, cia301::code),
      {.description = "Bit 31: invalid; bit 30 of a TPDO, not on request, may be set as well."}));
}
inline constexpr EntryInfo transmission_type_entry = rw_or_const(
    sub_index(2, "Transmission type", entry(unsigned8, ro, no, 0xFF, cia301::transmission_types)));
inline constexpr EntryInfo inhibit_time_entry =
    sub_index(3, "Inhibit time", entry(unsigned16, rw, no, 0, cia301::hundred_microseconds),
              {.category = Category::optional});
inline constexpr EntryInfo event_timer_entry =
    sub_index(5, "Event-timer", entry(unsigned16, rw, no, 0, cia301::milliseconds),
              {.category = Category::optional});
inline constexpr EntryInfo sync_start_entry = rw_or_const(sub_index(
    6, "SYNC start value", entry(unsigned8, ro, no, 0), {.category = Category::optional}));

/// Table 10 and, for the other TPDOs, Tables 14, 18, 22 and 26.
inline constexpr EntryInfo tpdo1_parameter_entries[] = {
    tpdo_highest_sub_index,  cob_id_entry(plus_node_id(cia301::invalid_cob_id | 0x180)),
    transmission_type_entry, inhibit_time_entry,
    event_timer_entry,       sync_start_entry};
inline constexpr EntryInfo tpdo_parameter_entries[] = {
    tpdo_highest_sub_index,  cob_id_entry(cia301::invalid_cob_id),
    transmission_type_entry, inhibit_time_entry,
    event_timer_entry,       sync_start_entry};
/// Tables 30 and 34 (errata 28, 29).
inline constexpr EntryInfo rpdo_parameter_entries[] = {rpdo_highest_sub_index,
                                                       cob_id_entry(cia301::invalid_cob_id),
                                                       transmission_type_entry, event_timer_entry};

// Mapping parameters.

inline constexpr std::string_view ordinals[] = {
    "1st application parameter", "2nd application parameter", "3rd application parameter",
    "4th application parameter", "5th application parameter", "6th application parameter",
    "7th application parameter", "8th application parameter"};

/// Sub-index 00h of a mapping record.
constexpr EntryInfo number_of_mapped(std::uint8_t count) {
  return rw_or_const(sub_index(0, "Number of mapped application objects in PDO",
                               entry(unsigned8, ro, no, count), {.errata = "31"}));
}
/// Mapping of an entry at that position, from 1 on.
constexpr EntryInfo mapped(unsigned position, const ObjectInfo& object, unsigned sub) {
  return rw_or_const(sub_index(static_cast<std::uint8_t>(position), ordinals[position - 1],
                               entry(unsigned32, ro, no, mapped_value(object, sub), cia301::code)));
}
/// An entry that exists if an element beyond the first exists.
constexpr EntryInfo optionally(EntryInfo entry) {
  entry.category = Category::optional;
  return entry;
}
/// An entry that exists on a condition.
constexpr EntryInfo on_condition(EntryInfo entry, std::string_view condition,
                                 std::string_view errata) {
  entry.category = Category::conditional;
  entry.condition = condition;
  entry.errata = errata;
  return entry;
}

/// `count` entries with consecutive sub-indices, of which the first is mandatory.
template <std::size_t count>
constexpr std::array<EntryInfo, count + 1> mapping_of(const ObjectInfo& object,
                                                      unsigned sub_first) {
  std::array<EntryInfo, count + 1> entries{number_of_mapped(count)};
  for (unsigned i = 0; i < count; ++i) {
    entries[i + 1] = mapped(i + 1, object, sub_first + i);
    if (i > 0) entries[i + 1] = optionally(entries[i + 1]);
  }
  return entries;
}

/// 16 bits without meaning keep the positions of the entries behind them. Printed is FFFFh, which
/// maps nothing.
inline constexpr NamedValue third_axis_names[] = {{0x0003'0010, "no third axis"},
                                                  {0xFFFF, "no third axis, as printed"}};
/// Table 12 (errata 23, 24).
constexpr std::array<EntryInfo, 6> joystick_mapping(unsigned n) {
  const ObjectInfo& axes = read_analogue_input_16_bit_object;
  const ObjectInfo& bytes = read_input_8_bit_object;
  EntryInfo third =
      on_condition(mapped(3, axes, joystick_axis_sub(n, 3)), "if the joystick has 3 axes", "23");
  third.value.names = third_axis_names;
  EntryInfo second = mapped(2, axes, joystick_axis_sub(n, 2));
  second.errata = "24";
  EntryInfo memory = mapped(4, bytes, joystick_memory_sub(n));
  memory.errata = "24";
  EntryInfo buttons = mapped(5, bytes, joystick_buttons_sub(n));
  buttons.errata = "24";
  return {{number_of_mapped(5), mapped(1, axes, joystick_axis_sub(n, 1)), second, third, memory,
           buttons}};
}
/// Table 16, for the first of two foot pedals.
constexpr std::array<EntryInfo, 5> foot_pedal_mapping(unsigned n) {
  constexpr std::string_view if_second = "if the second of the two foot pedals is supported";
  const ObjectInfo& position = read_analogue_input_16_bit_object;
  const ObjectInfo& memory = read_input_8_bit_object;
  return {{number_of_mapped(4), mapped(1, memory, foot_pedal_memory_sub(n)),
           mapped(2, position, foot_pedal_position_sub(n)),
           on_condition(mapped(3, memory, foot_pedal_memory_sub(n + 1)), if_second, "22"),
           on_condition(mapped(4, position, foot_pedal_position_sub(n + 1)), if_second, "22")}};
}
/// Table 20.
constexpr auto encoder_mapping(unsigned n) {
  auto entries = mapping_of<encoders_of_tpdo>(read_input_32_bit_object, encoder_position_sub(n));
  for (EntryInfo& entry : entries) {
    if (entry.sub_first > 0) entry.errata = "20";
  }
  return entries;
}
/// Table 24.
constexpr auto wheel_mapping(unsigned n) {
  return mapping_of<wheels_of_tpdo>(read_analogue_input_16_bit_object, wheel_position_sub(n));
}
/// Table 28.
constexpr auto push_button_mapping(unsigned n) {
  return mapping_of<groups_of_cluster>(read_input_8_bit_object, push_buttons_sub(n, 1));
}
/// Table 32.
constexpr auto indicator_mapping(unsigned n) {
  return mapping_of<groups_of_cluster>(write_output_8_bit_object, indicators_sub(n, 1));
}
/// Table 36. The third of a display starts with its parameter 9.
constexpr auto display_mapping(unsigned n, unsigned part, unsigned pitch) {
  const ObjectInfo& object =
      pitch == display_pitch ? write_analogue_output_16_bit_object : wide_display_objects[0];
  return mapping_of<parameters_of_rpdo>(object,
                                        display_sub(n, parameters_of_rpdo * (part - 1) + 1, pitch));
}

/// Results of `make` for the first `count` elements, or for each `step`-th of them.
template <std::size_t count, class Make>
constexpr auto each_of(Make make, unsigned step = 1) {
  std::array<decltype(make(1U)), count> made{};
  for (unsigned i = 0; i < count; ++i) made[i] = make(1 + i * step);
  return made;
}
inline constexpr auto joystick_mappings = each_of<joysticks_max>(joystick_mapping);
inline constexpr auto foot_pedal_mappings =
    each_of<foot_pedals_max / foot_pedals_of_tpdo>(foot_pedal_mapping, foot_pedals_of_tpdo);
inline constexpr auto encoder_mappings =
    each_of<encoders_max / encoders_of_tpdo>(encoder_mapping, encoders_of_tpdo);
inline constexpr auto wheel_mappings =
    each_of<wheels_max / wheels_of_tpdo>(wheel_mapping, wheels_of_tpdo);
inline constexpr auto push_button_mappings = each_of<push_button_clusters_max>(push_button_mapping);
inline constexpr auto indicator_mappings = each_of<indicator_clusters_max>(indicator_mapping);

inline constexpr unsigned display_rpdo_count = displays_max * rpdos_of_display;
/// The mapping of each RPDO of each display.
constexpr auto display_mapping_table(unsigned pitch) {
  return each_of<display_rpdo_count>([=](unsigned n) {
    return display_mapping((n - 1) / rpdos_of_display + 1, (n - 1) % rpdos_of_display + 1, pitch);
  });
}
inline constexpr auto display_mappings = display_mapping_table(display_pitch);
inline constexpr auto wide_display_mappings = display_mapping_table(wide_display_pitch);

}  // namespace canvoy::cia852
