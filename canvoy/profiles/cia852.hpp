// CiA 852: operator environments (seats, cabins and remote controls with joysticks, foot pedals,
// encoders, wheels, push-buttons, indicators and displays), based on the inputs and outputs of CiA
// 401. Where the text contradicts itself, `errata` gives the number of the finding that decided.
//
//     cia852::joystick_axis_sub(2, 1)                  // 04h of 6401h: x of the second joystick
//     cia852::tpdo_mapping(cia852::joystick_tpdo(2))   // 1A04h
//     cia852::device_type({.wheel = true})             // 8884'0191h
#pragma once

#include "canvoy/profiles/cia852/functions.hpp"
#include "canvoy/profiles/cia852/provisions.hpp"

namespace canvoy::cia852 {

inline constexpr std::uint16_t profile_number = 852;

/// Collects the objects of the profile.
template <std::size_t capacity>
struct Pointers {
  std::array<const ObjectInfo*, capacity> items{};  ///< the first `size` of them
  std::size_t size = 0;

  /// Adds an object.
  constexpr void add(const ObjectInfo& object) { items[size++] = &object; }
  /// Adds all of them, which must outlive the list.
  template <std::size_t count>
  constexpr void add(const std::array<ObjectInfo, count>& objects) {
    for (const ObjectInfo& object : objects) add(object);
  }
};

inline constexpr auto objects = [] {
  constexpr std::size_t others = 13 + 13;
  Pointers<others + 2 * tpdo_count + 2 * rpdo_count> all{};
  for (const ObjectInfo* object :
       {&device_type_object, &error_register_object, &sync_cob_id_object, &sync_window_object,
        &store_object, &restore_object, &emergency_cob_id_object, &emergency_inhibit_object,
        &consumer_heartbeat_object, &producer_heartbeat_object, &identity_object,
        &emergency_consumer_object, &error_behavior_object}) {
    all.add(*object);
  }
  all.add(rpdo_parameter_objects);
  all.add(rpdo_mapping_objects);
  all.add(tpdo_parameter_objects);
  all.add(tpdo_mapping_objects);
  for (const ObjectInfo* object :
       {&program_data_object, &read_input_8_bit_object, &read_input_32_bit_object,
        &write_output_8_bit_object, &error_mode_output_8_bit_object,
        &error_value_output_8_bit_object, &read_analogue_input_16_bit_object,
        &write_analogue_output_16_bit_object, &write_analogue_output_float_object,
        &analogue_input_global_interrupt_enable_object, &analogue_output_error_mode_object,
        &analogue_output_error_value_integer_object, &analogue_output_error_value_float_object}) {
    all.add(*object);
  }
  return all.items;
}();

// Other readings.

inline constexpr auto printed_tpdo_objects = [] {
  constexpr std::size_t kept = 16;  // TPDO 1, and 5 to 19: these have the same indices
  constexpr std::size_t moved = tpdo_count - kept;
  std::array<const ObjectInfo*, 2 * moved> all{};
  for (std::size_t i = 0; i < moved; ++i) {
    all[i] = &printed_tpdo_parameter_objects[kept + i];
    all[moved + i] = &printed_tpdo_mapping_objects[kept + i];
  }
  return all;
}();
/// Indices without an object in that reading.
inline constexpr std::uint16_t without_printed_tpdos[] = {tpdo_parameter(first_shifted_tpdo).index,
                                                          tpdo_mapping(first_shifted_tpdo).index};

inline constexpr auto wide_display_reading_objects = [] {
  constexpr std::size_t kept = 11;  // RPDO 1 to 12: the first display has the same indices
  std::array<const ObjectInfo*, rpdo_count - kept + std::size(wide_display_objects)> all{};
  std::size_t place = 0;
  for (std::size_t i = kept; i < rpdo_count; ++i) all[place++] = &wide_rpdo_mapping_objects[i];
  for (const ObjectInfo& object : wide_display_objects) all[place++] = &object;
  return all;
}();

inline constexpr ReadingInfo readings[] = {
    {.name = "printed-tpdos",
     .description = "TPDO 20 and above at the indices that clause 12 prints: one higher than CiA "
                    "301 has them.",
     .errata = "16 to 19",
     .objects = printed_tpdo_objects,
     .without = without_printed_tpdos},
    {.name = "wide-displays",
     .description = "24 sub-indices for each display, of which 12 are used, in place of 12.",
     .errata = "4, 5",
     .objects = wide_display_reading_objects},
};

/// 1000h of a device with one functional element: the code of the element is its bit in 1000h.
constexpr std::uint32_t device_type_of(const VirtualDeviceInfo& element) {
  const auto is = [&element](std::uint8_t bit) { return (element.code >> (bit - 24) & 1) != 0; };
  return device_type({.joystick = is(joystick_bit),
                      .foot_pedal = is(foot_pedal_bit),
                      .encoder = is(encoder_bit),
                      .wheel = is(wheel_bit),
                      .push_button_cluster = is(push_button_cluster_bit),
                      .indicator_cluster = is(indicator_cluster_bit),
                      .display = is(display_bit)});
}

/// Of several operator seats behind one node-ID, each may be a separate logical device (5.1). CiA
/// 301 has room for eight.
inline constexpr Profile profile = {
    .number = profile_number,
    .name = "CiA 852",
    .title = "Recommended practice for operator environments",
    .objects = objects,
    .block_count = 8,
    .device_type = device_type_fields,
    .device_types = {.mask = device_type_mask, .value = device_type({})},
    .base = &cia401::profile,
    .virtual_devices = functional_elements,
    .device_type_of = device_type_of,
    .error_codes = error_codes,
    .readings = readings,
    .provisions = &provisions};

}  // namespace canvoy::cia852
