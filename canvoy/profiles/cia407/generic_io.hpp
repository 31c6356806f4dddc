// Objects of CiA 407 that a generic I/O device provides: 6760h to 6763h (9.2.28).
//
//     cia407::digital_input_object.index  // 6760h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

/// An input or output with the access printed in the object description.
constexpr ObjectInfo io(std::uint16_t index, std::string_view name, std::string_view clause,
                        std::string_view description) {
  return var_object(index, name, clause, description, {}, of_device({}));
}
/// The object with 32 bits, one for each input or output.
constexpr ObjectInfo digital(ObjectInfo object, Access access, Default initial) {
  object.entry = entry(unsigned32, access, optional, initial, {.notation = Notation::bit_mask});
  return object;
}
inline constexpr ObjectInfo digital_input_object =
    digital(io(0x6760, "digital_input", "9.2.28.1", "Up to 32 digital inputs."), Access::ro, {});
inline constexpr ObjectInfo digital_output_object =
    digital(io(0x6761, "digital_output", "9.2.28.2", "Up to 32 digital outputs."), Access::rw, 0);

/// Two channels in an entry, each with its sign.
inline constexpr FieldInfo analogue_channels[] = {
    {.first_bit = 0, .bits = 16, .name = "channel 2", .is_signed = true},
    {.first_bit = 16, .bits = 16, .name = "channel 1", .is_signed = true},
};
inline constexpr auto analogue_input_entries =
    one_or_more(entries_within(1, 4, "number_of_input_groups"),
                sub_index(0, "input_group_#",
                          entry(unsigned32, ro, optional, {}, {.notation = Notation::hexadecimal},
                                analogue_channels)),
                4);
inline constexpr auto analogue_output_entries =
    one_or_more(entries_within(1, 4, "number_of_output_groups"),
                {.name = "output_group_#",
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .access_by_device = true,
                 .mapping = Mapping::optional,
                 .initial = 0,
                 .value = {.notation = Notation::hexadecimal},
                 .fields = analogue_channels},
                4);
inline constexpr auto analogue_input_object =
    array(0x6762, "analogue_input", "9.2.28.3", "Up to 4 groups of 2 analogue inputs.",
          analogue_input_entries);
inline constexpr auto analogue_output_object =
    array(0x6763, "analogue_output", "9.2.28.4", "Up to 4 groups of 2 analogue outputs.",
          analogue_output_entries);

}  // namespace canvoy::cia407
