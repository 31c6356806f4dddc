// Events of CiA 407 from and for virtual devices: 6001h and 6002h (9.2.4, 9.2.5). The meaning of
// the event flags depends on the virtual device that the entry names.
//
//     cia407::events_for_virtual_devices_object.subs[1].fields
#pragma once

#include "canvoy/profiles/cia407/system.hpp"

namespace canvoy::cia407 {

/// An event flag.
enum class Event : std::uint8_t { not_present = 0, pending = 1 };
inline constexpr NamedValue event_states[] = {{Event::not_present, "event not present"},
                                              {Event::pending, "event pending"}};

inline constexpr std::string_view event_code_field = "code of virtual device";

/// Codes of 1000h, except that 00h is no code: an entry without an event is zero.
constexpr std::array<NamedValue, std::size(device_codes)> make_event_codes() {
  std::array<NamedValue, std::size(device_codes)> codes{};
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = device_codes[i];
  codes[0] = {0, "none"};
  return codes;
}
inline constexpr auto event_codes = make_event_codes();

template <DeviceCode code>
inline constexpr FieldCondition events_of[] = {{event_code_field, code_of(code), code_of(code)}};

/// One flag; `when` says for which event codes it has this name.
constexpr FieldInfo event(std::uint8_t bit, std::string_view name,
                          const Items<FieldCondition>& when) {
  return {.first_bit = bit, .name = name, .value = {.names = event_states}, .when = when};
}
template <unsigned bits>
inline constexpr NamedValue reserved_events[] = {
    {0, "event not present"}, {1, (1 << bits) - 1, "reserved", Meaning::reserved}};
/// Flags without an event. `number` distinguishes several of one virtual device.
template <unsigned bits>
constexpr FieldInfo no_events(std::uint8_t first_bit, const Items<FieldCondition>& when,
                              std::uint16_t number = 0) {
  return {.first_bit = first_bit,
          .bits = bits,
          .name = "reserved",
          .value = {.names = reserved_events<bits>},
          .when = when,
          .number = number};
}
/// Events of virtual devices for which no table defines the flags.
constexpr FieldInfo undefined_events(const Items<FieldCondition>& when) {
  return {.bits = 8,
          .name = "event flags",
          .value = {.notation = Notation::bit_mask},
          .description = "Eight events; what they are is not defined.",
          .when = when};
}
inline constexpr FieldInfo manufacturer_information =
    field(8, 16, "manufacturer-specific information", {.notation = Notation::hexadecimal},
          "Bits that are not used are zero.");
inline constexpr FieldInfo event_code = field(24, 8, event_code_field, event_codes);

// The tables of 9.2.4 and 9.2.5, by the code of the virtual device.
inline constexpr auto& of_passenger_information = events_of<DeviceCode::passenger_information>;
inline constexpr auto& of_ticket_canceller = events_of<DeviceCode::ticket_canceller>;
inline constexpr auto& of_announcer = events_of<DeviceCode::acoustic_announcer>;
inline constexpr auto& of_acoustic_manager = events_of<DeviceCode::acoustic_control_manager>;
inline constexpr auto& of_tachograph = events_of<DeviceCode::tachograph>;
inline constexpr auto& of_passenger_counter = events_of<DeviceCode::passenger_counter>;
inline constexpr auto& of_counting_manager = events_of<DeviceCode::passenger_counting_manager>;
inline constexpr auto& of_diagnostics = events_of<DeviceCode::diagnostics>;

inline constexpr FieldCondition of_other_producers[] = {{event_code_field, 0x00, 0x02},
                                                        {event_code_field, 0x05, 0x07},
                                                        {event_code_field, 0x09, 0x13},
                                                        {event_code_field, 0x17, 0xFF}};
inline constexpr FieldInfo events_from_fields[] = {
    event(0, "state information", of_passenger_information),
    event(1, "display in test mode", of_passenger_information),
    event(2, "mapped information cannot be displayed", of_passenger_information),
    no_events<5>(3, of_passenger_information),

    no_events<1>(0, of_acoustic_manager, 1),
    event(1, "driver microphone to indoor loudspeakers", of_acoustic_manager),
    event(2, "driver microphone to outdoor loudspeakers", of_acoustic_manager),
    event(3, "driver microphone to VRCC", of_acoustic_manager),
    event(4, "travel attendant microphone to indoor loudspeakers", of_acoustic_manager),
    event(5, "VRCC to indoor loudspeakers", of_acoustic_manager),
    event(6, "state information of the acoustic control manager", of_acoustic_manager),
    no_events<1>(7, of_acoustic_manager, 2),

    event(0, "state information", of_ticket_canceller),
    no_events<7>(1, of_ticket_canceller),

    event(0, "more than 200 incoming or outgoing passengers", of_passenger_counter),
    no_events<7>(1, of_passenger_counter),

    event(0, "close to passenger capacity limit", of_counting_manager),
    event(1, "passenger capacity warning limit", of_counting_manager),
    no_events<6>(2, of_counting_manager),

    event(0, "more than 200 entries in object 6740h", of_diagnostics),
    event(1, "object 6740h close to capacity limit", of_diagnostics),
    event(2, "more than 200 entries in object 6742h", of_diagnostics),
    event(3, "more than 200 entries in object 6743h", of_diagnostics),
    event(4, "more than 200 entries in object 6744h", of_diagnostics),
    no_events<3>(5, of_diagnostics),

    undefined_events(of_other_producers),
    manufacturer_information,
    event_code,
};

inline constexpr FieldCondition of_other_consumers[] = {{event_code_field, 0x00, 0x02},
                                                        {event_code_field, 0x05, 0x06},
                                                        {event_code_field, 0x09, 0x0B},
                                                        {event_code_field, 0x0D, 0xFF}};
inline constexpr FieldInfo events_for_fields[] = {
    event(0, "reset tachograph trip distance", of_tachograph),
    event(1, "adjust local hour offset", of_tachograph),
    event(2, "adjust local minute offset", of_tachograph),
    no_events<5>(3, of_tachograph),

    event(0, "send state information", of_passenger_information),
    event(1, "enter testmode", of_passenger_information),
    no_events<6>(2, of_passenger_information),

    event(0, "send state information", of_announcer),
    no_events<7>(1, of_announcer),

    event(0, "send state information", of_ticket_canceller),
    no_events<7>(1, of_ticket_canceller),

    // Printed among the states of 6001h only, while 6.9 calls them commands (errata 19, 20).
    no_events<1>(0, of_acoustic_manager, 1),
    event(1, "driver microphone to indoor loudspeakers", of_acoustic_manager),
    event(2, "driver microphone to outdoor loudspeakers", of_acoustic_manager),
    event(3, "driver microphone to VRCC", of_acoustic_manager),
    event(4, "travel attendant microphone to indoor loudspeakers", of_acoustic_manager),
    event(5, "VRCC to indoor loudspeakers", of_acoustic_manager),
    event(6, "state information of the acoustic control manager", of_acoustic_manager),
    no_events<1>(7, of_acoustic_manager, 2),

    undefined_events(of_other_consumers),
    manufacturer_information,
    event_code,
};

/// Names of the entries of one object: one entry for each of the 32 virtual devices that a physical
/// device may have, the first at sub-index `first`.
struct OrdinalNames {
  std::string_view first;          ///< of the 1st device
  std::string_view second;         ///< of the 2nd device
  std::string_view third;          ///< of the 3rd device
  std::string_view other;          ///< of all without an own name; # is the number
  std::string_view twenty_first;   ///< of the 21st device
  std::string_view twenty_second;  ///< of the 22nd device
  std::string_view twenty_third;   ///< of the 23rd device
  std::string_view thirty_first;   ///< of the 31st device
  std::string_view thirty_second;  ///< of the 32nd device
};
/// Entries from `first` on, in the shape of `shape` with 32 bits.
constexpr std::array<EntryInfo, 10> of_32_devices(std::uint8_t first, const OrdinalNames& names,
                                                  EntryInfo shape) {
  shape.type = DataType::unsigned32;
  shape.category = Category::optional;
  shape.mapping = Mapping::optional;
  shape.value.notation = Notation::hexadecimal;
  shape = by_device(shape);
  const auto numbered = [&](std::uint8_t from, std::uint8_t to, std::string_view name) {
    EntryInfo entry = at(static_cast<std::uint8_t>(first + from - 1),
                         static_cast<std::uint8_t>(first + to - 1), shape);
    entry.name = name;
    entry.first_number = from;
    return entry;
  };
  return {numbered(1, 1, names.first),          numbered(2, 2, names.second),
          numbered(3, 3, names.third),          numbered(4, 20, names.other),
          numbered(21, 21, names.twenty_first), numbered(22, 22, names.twenty_second),
          numbered(23, 23, names.twenty_third), numbered(24, 30, names.other),
          numbered(31, 31, names.thirty_first), numbered(32, 32, names.thirty_second)};
}

inline constexpr NamedValue event_at_sub_states[] = {{0, "no event"}, {1, "at least one event"}};
inline constexpr auto event_at_sub_fields =
    repeat_field<32>({.name = "sub #", .value = {.names = event_at_sub_states}, .number = 2});

inline constexpr OrdinalNames events_from_names = {
    "events_from_1st_virtual_device",  "events_from_2nd_virtual_device",
    "events_from_3rd_virtual_device",  "events_from_#th_virtual_device",
    "events_from_21st_virtual_device", "events_from_22nd_virtual_device",
    "events_from_23rd_virtual_device", "events_from_31st_virtual_device",
    "events_from_32nd_virtual_device"};
inline constexpr OrdinalNames events_for_names = {
    "events_for_1st_virtual_device",  "events_for_2nd_virtual_device",
    "events_for_3rd_virtual_device",  "events_for_#th_virtual_device",
    "events_for_21st_virtual_device", "events_for_22nd_virtual_device",
    "events_for_23rd_virtual_device", "events_for_31st_virtual_device",
    "events_for_32nd_virtual_device"};

/// 6001h: which devices have events, and the events of up to 32 of them.
constexpr std::array<EntryInfo, 12> make_events_from() {
  std::array<EntryInfo, 12> entries{};
  entries[0] = entries_within(0x02, 0x21);
  entries[1] = by_device(sub_index(
      1, "event_at_sub",
      entry(unsigned32, ro, by_default, 0, {.notation = Notation::bit_mask}, event_at_sub_fields),
      {.errata = "96", .description = "Which of the sub-indices 02h to 21h are not zero."}));
  const auto devices =
      of_32_devices(2, events_from_names, entry(unsigned8, ro, no, 0, events_from_fields));
  for (std::size_t i = 0; i < devices.size(); ++i) entries[i + 2] = devices[i];
  return entries;
}
inline constexpr auto events_from_entries = make_events_from();
inline constexpr auto events_from_virtual_devices_object =
    array(0x6001, "events_from_virtual_devices", "9.2.4",
          "States of the virtual devices in this device, and events that they tell.",
          events_from_entries, "3, 19, 20, 22, 23, 80, 81, 82, 83");

/// 6002h: the events for up to 32 virtual devices.
constexpr std::array<EntryInfo, 11> make_events_for() {
  std::array<EntryInfo, 11> entries{};
  entries[0] = entries_within(0x01, 0x20);
  const auto devices = of_32_devices(1, events_for_names, {.fields = events_for_fields});
  for (std::size_t i = 0; i < devices.size(); ++i) entries[i + 1] = devices[i];
  return entries;
}
inline constexpr auto events_for_entries = make_events_for();
inline constexpr auto events_for_virtual_devices_object =
    array(0x6002, "events_for_virtual_devices", "9.2.5",
          "Commands to the virtual devices in this device, and events that they are told of.",
          events_for_entries, "19, 20, 21, 22, 80, 82, 83");

}  // namespace canvoy::cia407
