// Descriptions as rows: objects, entries and fields in the columns of a clause. Rarely used
// properties follow by name.
//
//     using namespace rows;
//     inline constexpr ObjectInfo battery_temperature_object =
//         var_object(0x6010, "battery_temperature", "7.2.3", "Temperature of the battery pack.",
//                    entry(integer16, rw, by_default, 0xFFFF, temperature), {.errata = "1, 2,
//                    25"});
//     inline constexpr EntryInfo rpdo_parameter_entries[] = {
//         sub_index(0, "highest sub-index supported", entry(unsigned8, ro, no, highest_sub())),
//         sub_index(1, "COB-ID", entry(unsigned32, rw, no, invalid_cob_id, code), {.errata =
//         "10"})};
//     inline constexpr FieldInfo readiness[] = {field(0, 1, "readiness", readiness_names)};
#pragma once

#include <array>
#include <concepts>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::rows {

// The columns: UNSIGNED8, INTEGER16; ro, rw; no, optional, by_default.
using enum DataType;
using enum Access;
using enum Mapping;

/// Some bits of an entry.
constexpr FieldInfo field(unsigned first_bit, unsigned bits, std::string_view name,
                          const ValueInfo& value = {}, std::string_view description = {}) {
  return {.first_bit = static_cast<std::uint8_t>(first_bit),
          .bits = static_cast<std::uint8_t>(bits),
          .name = name,
          .value = value,
          .description = description};
}
/// A field of which the values have names.
constexpr FieldInfo field(unsigned first_bit, unsigned bits, std::string_view name,
                          Items<NamedValue> names, std::string_view description = {}) {
  return field(first_bit, bits, name, ValueInfo{.names = names}, description);
}

/// A field that is a plain number, with a sentence for documents.
constexpr FieldInfo field(unsigned first_bit, unsigned bits, std::string_view name,
                          std::string_view description) {
  return field(first_bit, bits, name, ValueInfo{}, description);
}

/// An entry on the bus: type, access, mapping, default, and the meaning of the number or its bits.
constexpr EntryInfo entry(DataType type, Access access, Mapping mapping = Mapping::no,
                          const Default& initial = {}) {
  return {.type = type, .access = access, .mapping = mapping, .initial = initial};
}
/// An entry with the meaning of its number, or of its bits.
constexpr EntryInfo entry(DataType type, Access access, Mapping mapping, const Default& initial,
                          const ValueInfo& value, Items<FieldInfo> fields = {}) {
  return {.type = type,
          .access = access,
          .mapping = mapping,
          .initial = initial,
          .value = value,
          .fields = fields};
}
/// An entry of which the values have names.
constexpr EntryInfo entry(DataType type, Access access, Mapping mapping, const Default& initial,
                          Items<NamedValue> names) {
  return entry(type, access, mapping, initial, ValueInfo{.names = names});
}
/// An entry of which the bits have meanings of their own.
constexpr EntryInfo entry(DataType type, Access access, Mapping mapping, const Default& initial,
                          Items<FieldInfo> fields) {
  return entry(type, access, mapping, initial, ValueInfo{}, fields);
}
/// A string of at most `capacity` bytes.
constexpr EntryInfo string_entry(DataType type, Access access, std::uint16_t capacity,
                                 const Default& initial = {}) {
  return {.type = type, .access = access, .capacity = capacity, .initial = initial};
}

/// Remarks that apply to some entries only.
struct EntryRemarks {
  Category category = Category::mandatory;  ///< of the entry
  std::string_view condition = {};          ///< if set, the entry is conditional
  std::string_view clause = {};             ///< where it differs from the object's
  std::string_view errata = {};             ///< numbers of the findings that decided something
  std::string_view description = {};        ///< a sentence for documents
  std::uint16_t first_number = 1;           ///< number in the name of the first entry
};
/// The entries from sub-index `first` to `last` of an array or record.
constexpr EntryInfo sub_index(unsigned first, unsigned last, std::string_view name, EntryInfo entry,
                              const EntryRemarks& remarks = {}) {
  entry.sub_first = static_cast<std::uint8_t>(first);
  entry.sub_last = static_cast<std::uint8_t>(last);
  entry.name = name;
  entry.first_number = remarks.first_number;
  entry.category = remarks.condition.empty() ? remarks.category : Category::conditional;
  entry.condition = remarks.condition;
  entry.clause = remarks.clause;
  entry.errata = remarks.errata;
  entry.description = remarks.description;
  return entry;
}
/// One entry of an array or record.
constexpr EntryInfo sub_index(unsigned index, std::string_view name, const EntryInfo& entry,
                              const EntryRemarks& remarks = {}) {
  return sub_index(index, index, name, entry, remarks);
}

/// Remarks that apply to some objects only.
struct ObjectRemarks {
  std::uint16_t count = 1;                  ///< of objects with consecutive indices
  std::uint16_t first_number = 1;           ///< number in the name of the first object
  Category category = Category::mandatory;  ///< of the object
  std::string_view condition = {};          ///< if set, the object is conditional
  std::string_view errata = {};             ///< numbers of the findings that decided something
  bool once = false;                        ///< see ObjectInfo::once
};
/// A variable; its only entry has sub-index 00h.
constexpr ObjectInfo var_object(std::uint16_t index, std::string_view name, std::string_view clause,
                                std::string_view description, const EntryInfo& entry,
                                const ObjectRemarks& remarks = {}) {
  return {.index = index,
          .count = remarks.count,
          .name = name,
          .first_number = remarks.first_number,
          .category = remarks.condition.empty() ? remarks.category : Category::conditional,
          .condition = remarks.condition,
          .clause = clause,
          .errata = remarks.errata,
          .description = description,
          .once = remarks.once,
          .entry = entry};
}
/// An array: sub-index 00h, and entries of one type.
constexpr ObjectInfo array_object(std::uint16_t index, std::string_view name,
                                  std::string_view clause, std::string_view description,
                                  Items<EntryInfo> subs, const ObjectRemarks& remarks = {}) {
  ObjectInfo object = var_object(index, name, clause, description, {}, remarks);
  object.code = ObjectCode::array;
  object.subs = subs;
  return object;
}
/// A record: sub-index 00h, and entries of any types.
constexpr ObjectInfo record_object(std::uint16_t index, std::string_view name,
                                   std::string_view clause, std::string_view description,
                                   Items<EntryInfo> subs, const ObjectRemarks& remarks = {}) {
  ObjectInfo object = array_object(index, name, clause, description, subs, remarks);
  object.code = ObjectCode::record;
  return object;
}

/// Objects in the given order.
template <std::same_as<ObjectInfo>... Object>
constexpr std::array<const ObjectInfo*, sizeof...(Object)> objects_of(const Object&... objects) {
  return {&objects...};
}

}  // namespace canvoy::rows
