// Terms of CiA 301 and CiA 306 for the enumerators of descriptions, and names with their numbers
// inserted.
//
//     data_type_name(DataType::unsigned16);          // "UNSIGNED16"
//     object_name(input_group_object, 0x6101);       // "Input group 2"
//     entry_name(text_object, text_object.subs[2], 5);  // "text_of_destination_5"
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::formats {

/// Name of a type: `UNSIGNED8`, `VISIBLE_STRING` (CiA 301, 7.4.7).
std::string_view data_type_name(DataType type);
/// Type of a name, in upper case; nothing for another name.
std::optional<DataType> data_type_named(std::string_view name);
/// Name of an object code: `VAR`, `ARRAY`, `RECORD`, `DOMAIN`.
std::string_view object_code_name(ObjectCode code);
/// Name of an SDO access: `ro`, `wo`, `rw`, `const`; empty for none.
std::string_view access_name(Access access);
/// Name of the access of an entry: `vd` if the virtual device decides.
std::string_view access_name(const EntryInfo& entry);
/// Name of a mapping: `no`, `optional`, `default`.
std::string_view mapping_name(Mapping mapping);
/// Name of a category: `mandatory`, `optional`, `conditional`.
std::string_view category_name(Category category);
/// Words for the meaning of a named value: `state`, `not available`, `reserved`.
std::string_view meaning_name(Meaning meaning);
/// The number that the bits of a REAL32 or REAL64 represent.
double real_value(std::int64_t pattern, DataType type);

/// A raw value of this many bits in hexadecimal, with as many digits as needed.
std::string pattern_text(std::int64_t number, unsigned bits);
/// Stands for no number: `#` in a name, such as "Motor #2" of a manufacturer, is kept.
inline constexpr std::uint16_t no_number = 0xFFFF;
/// `name` with `number` in place of `#`, unless it is `no_number`.
std::string numbered(std::string_view name, unsigned number);
/// Name of the object at `index`, in any block of the profile.
std::string object_name(const Profile& profile, const ObjectInfo& object, unsigned index);
/// Name of an object, such as `input_group_1 to input_group_32` for several.
std::string object_name(const ObjectInfo& object);
/// Name of the entry at `sub`; for a variable that of the object, without a number.
std::string entry_name(const ObjectInfo& object, const EntryInfo& entry, unsigned sub);
/// Like entry_name() of one sub-index, but for all entries that `entry` describes.
std::string entry_name(const ObjectInfo& object, const EntryInfo& entry);
/// Name of a field, with its number in place of `#`.
std::string field_name(const FieldInfo& field);
/// `basic function = 02h to 04h, 08h`: the alternatives of one field together; empty for none.
std::string condition_text(const FieldInfo& field);

}  // namespace canvoy::formats
