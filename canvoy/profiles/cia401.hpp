// CiA 401: generic input and output modules, in the parts on which other profiles are built (CiA
// 852).
//
// The text of CiA 401 is not at hand. Indices, types and defaults are those of CiA's conformance
// test and are certain. The meanings of single bits, the PDOs that exist at start, and the limits
// of arrays are common practice. A device with other values changes them (canvoy/profiles/
// device_description.hpp).
//
//     cia401::profile.objects.size()
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia401/analogue.hpp"
#include "canvoy/profiles/cia401/digital.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::cia401 {

inline constexpr std::uint16_t profile_number = 401;

inline constexpr NamedValue profile_names[] = {{profile_number, "CiA 401"}};
inline constexpr NamedValue presence_names[] = {{0, "no"}, {1, "yes"}};
inline constexpr NamedValue pdo_mapping_names[] = {{0, "pre-defined"}, {1, "device-specific"}};

/// Bits of 1000h that are also those of profiles built on this one.
inline constexpr FieldInfo profile_field = field(0, 16, "Device profile number", profile_names);
/// A bit of 1000h: whether the device has such inputs or outputs.
constexpr FieldInfo io_field(std::uint8_t bit, std::string_view name) {
  return field(bit, 1, name, presence_names);
}
inline constexpr FieldInfo digital_input_field = io_field(16, "Digital input");
inline constexpr FieldInfo digital_output_field = io_field(17, "Digital output");
inline constexpr FieldInfo analogue_input_field = io_field(18, "Analogue input");
inline constexpr FieldInfo analogue_output_field = io_field(19, "Analogue output");
inline constexpr FieldInfo pdo_mapping_field = field(23, 1, "M", pdo_mapping_names);

inline constexpr FieldInfo device_type_fields[] = {
    profile_field,
    digital_input_field,
    digital_output_field,
    analogue_input_field,
    analogue_output_field,
    pdo_mapping_field,
    field(24, 8, "Specific functionality", {.notation = Notation::hexadecimal},
          "0 of generic modules; others say which part of the profile they follow."),
};

/// `count` entries of one object, side by side in a PDO.
template <std::size_t count>
constexpr std::array<std::uint32_t, count> side_by_side(const ObjectInfo& object, unsigned first) {
  std::array<std::uint32_t, count> mapped{};
  for (unsigned i = 0; i < count; ++i) mapped[i] = mapped_value(object, first + i);
  return mapped;
}
inline constexpr auto digital_input_mapping = side_by_side<8>(read_input_8_bit_object, 1);
inline constexpr auto digital_output_mapping = side_by_side<8>(write_output_8_bit_object, 1);
inline constexpr auto analogue_input_mapping_1 =
    side_by_side<4>(read_analogue_input_16_bit_object, 1);
inline constexpr auto analogue_input_mapping_2 =
    side_by_side<4>(read_analogue_input_16_bit_object, 5);
inline constexpr auto analogue_input_mapping_3 =
    side_by_side<4>(read_analogue_input_16_bit_object, 9);
inline constexpr auto analogue_output_mapping_1 =
    side_by_side<4>(write_analogue_output_16_bit_object, 1);
inline constexpr auto analogue_output_mapping_2 =
    side_by_side<4>(write_analogue_output_16_bit_object, 5);
inline constexpr auto analogue_output_mapping_3 =
    side_by_side<4>(write_analogue_output_16_bit_object, 9);

/// A PDO of the pre-defined connection set; the node-ID is added to `can_id`.
constexpr PdoInfo pdo(PdoInfo::Direction direction, std::uint16_t number, std::uint32_t can_id,
                      Items<std::uint32_t> mapping, std::string_view name) {
  return {.direction = direction,
          .number = number,
          .cob_id = can_id,
          .plus_node_id = true,
          .mapping = mapping,
          .name = name,
          .condition = "if the device has one of the mapped objects"};
}
inline constexpr PdoInfo pdos[] = {
    pdo(PdoInfo::Direction::receive, 1, 0x200, digital_output_mapping, "Digital outputs"),
    pdo(PdoInfo::Direction::receive, 2, 0x300, analogue_output_mapping_1,
        "Analogue outputs 1 to 4"),
    pdo(PdoInfo::Direction::receive, 3, 0x400, analogue_output_mapping_2,
        "Analogue outputs 5 to 8"),
    pdo(PdoInfo::Direction::receive, 4, 0x500, analogue_output_mapping_3,
        "Analogue outputs 9 to 12"),
    pdo(PdoInfo::Direction::transmit, 1, 0x180, digital_input_mapping, "Digital inputs"),
    pdo(PdoInfo::Direction::transmit, 2, 0x280, analogue_input_mapping_1, "Analogue inputs 1 to 4"),
    pdo(PdoInfo::Direction::transmit, 3, 0x380, analogue_input_mapping_2, "Analogue inputs 5 to 8"),
    pdo(PdoInfo::Direction::transmit, 4, 0x480, analogue_input_mapping_3,
        "Analogue inputs 9 to 12"),
};

inline constexpr ErrorCodeInfo analogue_inputs_disabled = {
    .code = 0x0080,
    .text = "Warning: Analog inputs disabled",
    .description = "Sent on the way to Operational, where 6423h is FALSE."};
inline constexpr ErrorCodeInfo error_codes[] = {
    analogue_inputs_disabled,
    {0x2310, "current at outputs too high"},
    {0x2320, "short circuit at outputs"},
    {0x2330, "load dump at outputs"},
    {0x3110, "input voltage too high"},
    {0x3120, "input voltage too low"},
    {0x3210, "internal voltage too high"},
    {0x3220, "internal voltage too low"},
    {0x3310, "output voltage too high"},
    {0x3320, "output voltage too low"},
};

inline constexpr auto objects = objects_of(
    read_input_8_bit_object, polarity_input_8_bit_object, filter_constant_input_8_bit_object,
    global_interrupt_enable_digital_object, interrupt_mask_any_change_8_bit_object,
    interrupt_mask_low_to_high_8_bit_object, interrupt_mask_high_to_low_8_bit_object,
    read_input_bit_object, read_input_16_bit_object, polarity_input_16_bit_object,
    filter_constant_input_16_bit_object, interrupt_mask_any_change_16_bit_object,
    interrupt_mask_low_to_high_16_bit_object, interrupt_mask_high_to_low_16_bit_object,
    read_input_32_bit_object, polarity_input_32_bit_object, filter_constant_input_32_bit_object,
    interrupt_mask_any_change_32_bit_object, interrupt_mask_low_to_high_32_bit_object,
    interrupt_mask_high_to_low_32_bit_object, write_output_8_bit_object,
    change_polarity_output_8_bit_object, error_mode_output_8_bit_object,
    error_value_output_8_bit_object, filter_mask_output_8_bit_object, write_output_16_bit_object,
    change_polarity_output_16_bit_object, error_mode_output_16_bit_object,
    error_value_output_16_bit_object, filter_mask_output_16_bit_object, write_output_32_bit_object,
    change_polarity_output_32_bit_object, error_mode_output_32_bit_object,
    error_value_output_32_bit_object, filter_mask_output_32_bit_object,
    read_analogue_input_8_bit_object, read_analogue_input_16_bit_object,
    read_analogue_input_32_bit_object, read_analogue_input_float_object,
    write_analogue_output_8_bit_object, write_analogue_output_16_bit_object,
    write_analogue_output_32_bit_object, write_analogue_output_float_object,
    analogue_input_interrupt_trigger_selection_object, analogue_input_interrupt_source_object,
    analogue_input_global_interrupt_enable_object,
    analogue_input_interrupt_upper_limit_integer_object,
    analogue_input_interrupt_lower_limit_integer_object,
    analogue_input_interrupt_delta_unsigned_object,
    analogue_input_interrupt_negative_delta_unsigned_object,
    analogue_input_interrupt_positive_delta_unsigned_object,
    analogue_input_interrupt_upper_limit_float_object,
    analogue_input_interrupt_lower_limit_float_object, analogue_input_interrupt_delta_float_object,
    analogue_input_interrupt_negative_delta_float_object,
    analogue_input_interrupt_positive_delta_float_object, analogue_input_offset_float_object,
    analogue_input_scaling_float_object, analogue_input_si_unit_object,
    analogue_input_offset_integer_object, analogue_input_scaling_integer_object,
    analogue_output_offset_float_object, analogue_output_scaling_float_object,
    analogue_output_error_mode_object, analogue_output_error_value_integer_object,
    analogue_output_error_value_float_object, analogue_output_offset_integer_object,
    analogue_output_scaling_integer_object, analogue_output_si_unit_object);
/// With several logical devices in a node, the objects of each are 800h above those of the one
/// before (CiA 301).
inline constexpr Profile profile = {.number = profile_number,
                                    .name = "CiA 401",
                                    .title = "Device profile for generic I/O modules",
                                    .objects = objects,
                                    .block_count = 8,
                                    .device_type = device_type_fields,
                                    .pdos = pdos,
                                    .error_codes = error_codes};

}  // namespace canvoy::cia401
