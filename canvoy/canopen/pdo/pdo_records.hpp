// PDOs with constant records: a device decides whether the communication and mapping records of its
// PDOs can be written (CiA 301, 7.5.2.35 to 7.5.2.38). If all of a direction are constant, the
// compiler checks them, and the code that checks or handles a write is not linked.
//
//     constexpr PdoRecords records = pdo_records(tables, PdoDirection::receive);
#pragma once

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_mapping.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"

namespace canvoy {

/// Constant records are read at reset only. A device that sets other values itself
/// (Node::on_defaults_restored) must set valid ones: a small machine checks the bits of the mapping
/// only.
enum class PdoRecords : std::uint8_t { writable, constant };

namespace detail {

/// Description of an entry in tables: null if there is none. `initial` is the default of a number
/// of up to four bytes.
struct DescribedEntry {
  const EntryShape* row = nullptr;
  std::uint32_t initial = 0;
};
constexpr DescribedEntry find_described(const DictionaryTables& tables, unsigned index,
                                        unsigned sub) {
  for (const ObjectRow& object : tables.objects) {
    if (index < object.index || index - object.index >= object.count) continue;
    const std::uint32_t* initial = tables.defaults_of(object, index);
    for (const EntryShape& row : tables.entries_of(object)) {
      if (sub >= row.sub_first && sub <= row.sub_last) return {&row, *initial};
      ++initial;
    }
  }
  return {};
}

/// True if no client can write an object from index `first` to `last`.
constexpr bool are_constant(const DictionaryTables& tables, unsigned first, unsigned last) {
  for (const ObjectRow& object : tables.objects) {
    if (object.index + object.count <= first || object.index > last) continue;
    for (const EntryShape& row : tables.entries_of(object)) {
      if (allows(row.access, Access::sdo_write)) return false;
    }
  }
  return true;
}

/// True for a COB-ID that a PDO can have with every node-ID, or one that is not valid.
constexpr bool is_right_cob_id(const DescribedEntry& entry) {
  const std::uint32_t initial = entry.initial;
  if (!has(entry.row->traits, EntryTraits::plus_node_id)) {
    return !CobId{initial}.valid() || is_usable(CobId{initial});
  }
  for (unsigned id = node_id_min; id <= node_id_max; ++id) {
    if (CobId{initial + id}.valid() && !is_usable(CobId{initial + id})) return false;
  }
  return true;
}

/// Number of bits of the value in a mapping entry; 0 if a PDO cannot carry it.
constexpr unsigned mapped_bits(const DictionaryTables& tables, std::uint32_t mapped,
                               PdoDirection direction) {
  const unsigned index = mapped >> 16;
  const unsigned sub = mapped >> 8 & 0xFF;
  const unsigned bits = mapped & 0xFF;
  const bool receives = direction == PdoDirection::receive;
  if (index >= 1 && index <= 7) {
    const bool is_dummy = receives && sub == 0 && bit_length(static_cast<DataType>(index)) == bits;
    return is_dummy ? bits : 0;
  }
  const EntryShape* row = find_described(tables, index, sub).row;
  if (row == nullptr || !allows(row->access, receives ? Access::rpdo : Access::tpdo)) return 0;
  return bits == (row->is_text() ? row->capacity * 8U : row->bits) ? bits : 0;
}

/// True if the PDO with the communication record `index` works, or is disabled. Multiplexed PDOs do
/// not count.
constexpr bool is_right_pdo(const DictionaryTables& tables, unsigned index,
                            PdoDirection direction) {
  constexpr unsigned to_mapping = 0x200;
  const DescribedEntry cob_id = find_described(tables, index, pdo_sub::cob_id);
  if (cob_id.row == nullptr) return true;
  if (!is_right_cob_id(cob_id)) return false;
  const DescribedEntry type = find_described(tables, index, pdo_sub::transmission_type);
  if (type.row != nullptr && is_reserved_type(type.initial, direction)) return false;
  const DescribedEntry count = find_described(tables, index + to_mapping, 0);
  if (count.row == nullptr || count.initial > pdo_values_max) return false;
  unsigned bits = 0;
  for (unsigned sub = 1; sub <= count.initial; ++sub) {
    const DescribedEntry entry = find_described(tables, index + to_mapping, sub);
    const unsigned more = entry.row == nullptr ? 0 : mapped_bits(tables, entry.initial, direction);
    bits += more;
    if (more == 0 || bits > pdo_bytes_max * 8) return false;
  }
  return true;
}

}  // namespace detail

/// Kind of all PDO records of a direction. Constant records that are invalid, or name objects that
/// move, are left to the checks at run time.
constexpr PdoRecords pdo_records(const DictionaryTables& tables, PdoDirection direction) {
  const unsigned first = direction == PdoDirection::receive ? object_index::rpdo_parameter
                                                            : object_index::tpdo_parameter;
  if (tables.index_in_tables != nullptr || !detail::are_constant(tables, first, first + 0x3FF)) {
    return PdoRecords::writable;
  }
  for (const ObjectRow& object : tables.objects) {
    if (object.index < first || object.index >= first + pdo_count_max) continue;
    for (unsigned i = 0; i < object.count; ++i) {
      if (!detail::is_right_pdo(tables, object.index + i, direction)) return PdoRecords::writable;
    }
  }
  return PdoRecords::constant;
}

}  // namespace canvoy
