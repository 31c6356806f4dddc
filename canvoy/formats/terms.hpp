// The words of CiA 301 and CiA 306 for what descriptions say in enumerators, and names with their
// numbers in them.
//
//     data_type_name(DataType::unsigned16);          // "UNSIGNED16"
//     object_name(input_group_object, 0x6101);       // "Input group 2"
//     entry_name(text_object, text_object.subs[2], 5);  // "text_of_destination_5"
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/profiles/description.hpp"

namespace canvoy::formats {

/// As CiA 301, 7.4.7 writes it: `UNSIGNED8`, `VISIBLE_STRING`.
std::string_view data_type_name(DataType type);
std::optional<DataType> data_type_named(std::string_view name);
/// `VAR`, `ARRAY`, `RECORD`, `DOMAIN`.
std::string_view object_code_name(ObjectCode code);
/// What SDO may do: `ro`, `wo`, `rw`, `const`; empty for nothing.
std::string_view access_name(Access access);
/// Of an entry: `vd` where the virtual device decides.
std::string_view access_name(const EntryInfo& entry);
/// `no`, `optional`, `default`.
std::string_view mapping_name(Mapping mapping);
/// `mandatory`, `optional`, `conditional`.
std::string_view category_name(Category category);
std::string_view meaning_name(Meaning meaning);
/// What the bits of a REAL32 or REAL64 stand for.
double real_value(std::int64_t pattern, DataType type);

/// A raw value as it stands in these bits, in as many hexadecimal digits as they need.
std::string pattern_text(std::int64_t number, unsigned bits);
/// The first number of what has none: `#` in its name, as in a maker's "Motor #2", stands for
/// itself.
inline constexpr std::uint16_t no_number = 0xFFFF;
/// `name` with a number in place of `#`, unless it is `no_number`.
std::string numbered(std::string_view name, unsigned number);
/// The name of the object at `index`, which may be in any block of the profile.
std::string object_name(const Profile& profile, const ObjectInfo& object, unsigned index);
/// `input_group_1 to input_group_32` for several, else the name.
std::string object_name(const ObjectInfo& object);
/// The name of the entry at `sub`; of a variable that of the object, without a number.
std::string entry_name(const ObjectInfo& object, const EntryInfo& entry, unsigned sub);
/// The same for all entries that `entry` describes.
std::string entry_name(const ObjectInfo& object, const EntryInfo& entry);
std::string field_name(const FieldInfo& field);
/// `basic function = 02h to 04h, 08h`, the alternatives of one field together; empty for none.
std::string condition_text(const FieldInfo& field);

}  // namespace canvoy::formats
