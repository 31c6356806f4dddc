// Mapping parameters as values: index, sub-index and length of a mapped entry (CiA 301, 7.5.2.36).
//
//     MappingValue(0x6010'00'10).index  // 6010h
//     mapping_entry(1, battery_temperature_object)  // sub-index 01h of a mapping parameter
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

struct MappingValue {
  std::uint16_t index = 0;  ///< of the mapped object
  std::uint8_t sub = 0;     ///< of the mapped entry
  std::uint8_t bits = 0;    ///< length; 1 to 64

  constexpr MappingValue() = default;
  /// Makes a value; the numbers are cut to 16, 8 and 8 bits.
  constexpr MappingValue(unsigned of_index, unsigned of_sub, unsigned of_bits)
      : index(static_cast<std::uint16_t>(of_index)),
        sub(static_cast<std::uint8_t>(of_sub)),
        bits(static_cast<std::uint8_t>(of_bits)) {}
  /// Takes the value of an entry of a mapping parameter apart.
  constexpr explicit MappingValue(std::uint32_t raw)
      : MappingValue(raw >> 16, raw >> 8 & 0xFF, raw & 0xFF) {}

  /// Value of an entry of a mapping parameter.
  constexpr std::uint32_t raw() const {
    return static_cast<std::uint32_t>(index) << 16 | static_cast<std::uint32_t>(sub) << 8 | bits;
  }
  /// In an RPDO, the index of a basic data type stands for bits that are ignored.
  constexpr bool is_dummy() const { return index >= 1 && index <= 7; }
};

/// True for 1600h to 17FFh.
constexpr bool is_rpdo_mapping(unsigned index) {
  return index >= 0x1600 && index <= 0x17FF;
}
inline constexpr unsigned last_pdo_mapping_index = 0x1BFF;  ///< of a TPDO
/// True for 1A00h to 1BFFh.
constexpr bool is_tpdo_mapping(unsigned index) {
  return index >= 0x1A00 && index <= last_pdo_mapping_index;
}
/// True for a mapping parameter of either direction.
constexpr bool is_pdo_mapping(unsigned index) {
  return is_rpdo_mapping(index) || is_tpdo_mapping(index);
}
/// Maximum number of bits in one PDO.
inline constexpr unsigned pdo_bits_max = 64;

/// Value of a mapping parameter that maps an entry of `object`.
constexpr std::uint32_t mapped_value(const ObjectInfo& object, unsigned sub = 0) {
  const EntryInfo* entry = find_entry(object, sub);
  if (entry == nullptr) detail::description_is_wrong("the mapped entry is not there");
  return MappingValue(object.index, sub, bit_length(entry->type)).raw();
}

/// An entry of a mapping parameter that maps an entry of `object` and is constant.
constexpr EntryInfo mapping_entry(unsigned position, const ObjectInfo& object, unsigned sub = 0) {
  const std::uint32_t mapped = mapped_value(object, sub);
  return {.sub_first = static_cast<std::uint8_t>(position),
          .name = name_of(object, *find_entry(object, sub)),
          .type = DataType::unsigned32,
          .access = Access::ro,
          .initial = mapped,
          .value = {.notation = Notation::hexadecimal}};
}

/// True if a mapping parameter maps an entry of the object at `index` by default.
constexpr bool maps(const ObjectInfo& mapping, unsigned index) {
  if (!is_pdo_mapping(mapping.index)) return false;
  for (const EntryInfo& entry : mapping.entries()) {
    if (entry.sub_first == 0 || entry.initial.kind != Default::Kind::number) continue;
    if (MappingValue(static_cast<std::uint32_t>(entry.initial.number)).index == index) return true;
  }
  return false;
}

}  // namespace canvoy
