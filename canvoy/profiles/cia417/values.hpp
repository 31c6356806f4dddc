// Common elements of the objects of CiA 417-4: shapes of entries and fields.
//
//     inline constexpr EntryInfo door_entries[] = {number_of_entries(1, 4), at(1, door),
//                                                  optional_at(2, 4, door)};
#pragma once

#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia417 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Condition of objects that have their category in another part.
inline constexpr std::string_view see_part_2 = "as CiA 417-2 says for the virtual device";

// Entries.

/// Sub-index 00h; `printed` is the default, 0 where the device defines the number.
constexpr EntryInfo count_entry(std::string_view name, std::uint8_t low, std::uint8_t high,
                                std::uint8_t printed = 0) {
  return sub_index(0, name,
                   entry(unsigned8, ro, no, highest_sub(printed), {.limits = within(low, high)}));
}
/// Sub-index 00h where the device decides, within these bounds.
constexpr EntryInfo number_of_entries(std::uint8_t low, std::uint8_t high) {
  return count_entry("Number of entries", low, high);
}
/// Sub-index 00h where the number is fixed.
constexpr EntryInfo number_of_entries(std::uint8_t all) {
  return count_entry("Number of entries", all, all, all);
}
/// Last sub-index of arrays with one entry for each input, output, sensor or rope.
inline constexpr std::uint8_t last_of_many = 0xFE;

/// `entry` at a sub-index; a `#` in its name stands for the number.
constexpr EntryInfo at(std::uint8_t sub, EntryInfo entry) {
  entry.sub_first = sub;
  entry.first_number = sub;
  return entry;
}
/// See at(); entries that a device may leave out.
constexpr EntryInfo optional_at(std::uint8_t first, std::uint8_t last, EntryInfo entry) {
  entry = at(first, entry);
  entry.sub_last = last;
  entry.category = Category::optional;
  return entry;
}
/// See at(); entries that a device has on a condition.
constexpr EntryInfo conditional_at(std::uint8_t first, std::uint8_t last, EntryInfo entry,
                                   std::string_view condition) {
  entry = optional_at(first, last, entry);
  entry.category = Category::conditional;
  entry.condition = condition;
  return entry;
}

/// The provider of a value has it as ro; consumers of a PDO, or of SDO, have it as rw (4.1.2).
constexpr EntryInfo provided(EntryInfo entry) {
  entry.access = Access::ro;
  entry.consumer_access = Access::rw;
  return entry;
}

// Values.

inline constexpr ValueInfo hexadecimal = {.notation = Notation::hexadecimal};

/// Parameters of inputs, outputs and sensors. Unused bytes are FFh (4.3.2 and others), and no
/// sentence gives another default.
inline constexpr NamedValue not_used_32[] = {{0xFFFF'FFFF, "nothing used", Meaning::invalid}};
inline constexpr NamedValue not_used_8[] = {{0xFF, "not used", Meaning::invalid}};
/// Parameters that count: 0 has no meaning.
inline constexpr NamedValue count_names[] = {{0x00, "reserved", Meaning::reserved},
                                             {0xFF, "not used", Meaning::invalid}};

// Fields.

/// A field that exists while another one has certain values.
constexpr FieldInfo field_when(Items<FieldCondition> when, unsigned first_bit, unsigned bits,
                               std::string_view name, const ValueInfo& value = {},
                               std::string_view description = {}) {
  FieldInfo made = field(first_bit, bits, name, value, description);
  made.when = when;
  return made;
}

/// Reserved bits that may hold any value, and those that must be 0 or 1.
template <unsigned bits>
inline constexpr NamedValue any_bits[] = {{0ULL, (1ULL << bits) - 1, "reserved", Meaning::padding}};
/// Reserved bits of messages: the sender leaves them 0.
template <unsigned bits>
inline constexpr NamedValue all_zeros[] = {
    {0, 0, "all bits 0", Meaning::padding},
    {1ULL, (1ULL << bits) - 1, "reserved", Meaning::reserved}};
template <unsigned bits>
inline constexpr NamedValue all_ones[] = {
    {0ULL, (1ULL << bits) - 2, "reserved", Meaning::reserved},
    {(1ULL << bits) - 1, (1ULL << bits) - 1, "all bits 1", Meaning::padding}};

/// `number` distinguishes the reserved bits of one entry.
template <unsigned bits>
constexpr FieldInfo reserved_bits(unsigned first_bit, unsigned number = 1,
                                  Items<FieldCondition> when = {}) {
  FieldInfo made = field_when(when, first_bit, bits, "reserved",
                              {.names = any_bits<bits>, .notation = Notation::hexadecimal});
  made.number = static_cast<std::uint16_t>(number);
  return made;
}
/// See reserved_bits(); a writer sets them to 0.
template <unsigned bits>
constexpr FieldInfo reserved_zeros(unsigned first_bit, unsigned number = 1,
                                   Items<FieldCondition> when = {}) {
  FieldInfo made = reserved_bits<bits>(first_bit, number, when);
  made.value.names = all_zeros<bits>;
  return made;
}
/// See reserved_bits(); a writer sets them to 1.
template <unsigned bits>
constexpr FieldInfo reserved_ones(unsigned first_bit, unsigned number = 1,
                                  Items<FieldCondition> when = {}) {
  FieldInfo made = reserved_bits<bits>(first_bit, number, when);
  made.value.names = all_ones<bits>;
  return made;
}

// Locations of inputs, outputs and sensors: a bit for each lift, the floor, a bit for each door.

inline constexpr unsigned lift_count = 8;
/// Distance between the objects of two lifts (4.1.1).
inline constexpr std::uint16_t block_pitch = 0x800;
/// Distance from the objects of lift 1 to those of lift `lift`.
constexpr std::uint16_t block_shift(unsigned lift) {
  return static_cast<std::uint16_t>((lift - 1) * block_pitch);
}
/// The handle of the same value in lift `lift`, counted from 1.
template <class Handle>
constexpr Handle in_lift(unsigned lift, const Handle& handle) {
  return handle.shifted(block_shift(lift));
}
inline constexpr unsigned door_count = 4;

/// A bit for each of lifts 1 to 8.
constexpr std::array<FieldInfo, lift_count> lift_bits(unsigned first_bit, std::string_view name,
                                                      const ValueInfo& value = {}) {
  return repeat_field<lift_count>(field(first_bit, 1, name, value));
}
/// A bit for each of doors 1 to 4.
constexpr std::array<FieldInfo, door_count> door_bits(unsigned first_bit, std::string_view name,
                                                      const ValueInfo& value = {}) {
  return repeat_field<door_count>(field(first_bit, 1, name, value));
}
inline constexpr NamedValue request_names[] = {{0, "no request"}, {1, "request"}};
inline constexpr ValueInfo request_bit = {.names = request_names};

/// Floors 1 to 254.
enum class Floor : std::uint8_t { car = 0x00, first = 0x01, last = 0xFE, all = 0xFF };

/// Of the sender (4.3.1 and 4.13.1).
inline constexpr NamedValue source_floor_names[] = {{Floor::car, "car"},
                                                    {Floor::all, "reserved", Meaning::reserved}};
inline constexpr ValueInfo source_floor = {.names = source_floor_names};
/// Of the receivers (4.4.1; errata A22).
inline constexpr NamedValue destination_floor_names[] = {{Floor::car, "car"},
                                                         {Floor::all, "all floors"}};
inline constexpr ValueInfo destination_floor = {.names = destination_floor_names};

}  // namespace canvoy::cia417
