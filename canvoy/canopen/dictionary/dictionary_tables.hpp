// The description of a node's entries: constant tables, made at compile time from a profile's
// description (canvoy/profiles), or at run time (HeapTables), and shared by all nodes of a kind.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "canvoy/can/machine.hpp"
#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/canopen/protocol/abort_code.hpp"

namespace canvoy {

/// Access rights of an entry: bits, with names for the usual sums.
enum class Access : std::uint8_t {
  none = 0,
  sdo_read = 1,
  sdo_write = 2,
  tpdo = 4,       ///< may be mapped into a TPDO
  rpdo = 8,       ///< may be mapped into an RPDO
  constant = 16,  ///< does not change in operation
  ro = sdo_read,
  wo = sdo_write,
  rw = sdo_read | sdo_write,
  const_ = sdo_read | constant,
};
constexpr Access operator|(Access a, Access b) {
  return static_cast<Access>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// True if all rights in `what` are among those in `access`.
constexpr bool allows(Access access, Access what) {
  return (static_cast<unsigned>(access) & static_cast<unsigned>(what)) ==
         static_cast<unsigned>(what);
}

/// Meaning of the limits and the default of an entry: bits.
enum class EntryTraits : std::uint8_t {
  none = 0,
  limited = 1,       ///< `low` and `high` apply
  has_sentinel = 2,  ///< `sentinel` is allowed although it lies outside the limits
  plus_node_id = 4,  ///< the default is `initial` plus the node-ID
  not_stored = 8,    ///< a process value, not a parameter: it is not kept without power
  text = 16,         ///< a string: filled in by the layout
  has_sign = 32,     ///< a signed integer: filled in by the layout
};
constexpr EntryTraits operator|(EntryTraits a, EntryTraits b) {
  return static_cast<EntryTraits>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// True if one of the bits in `trait` is among `traits`.
constexpr bool has(EntryTraits traits, EntryTraits trait) {
  return (static_cast<unsigned>(traits) & static_cast<unsigned>(trait)) != 0;
}

/// Byte offset in a block of values: the whole memory of a small machine is below 64 KiB.
using BlockOffset = std::conditional_t<is_small_machine, std::uint16_t, std::uint32_t>;

/// Description of entries of one shape: sub-indices first to last of an object, all of one type,
/// access and range. Objects of one shape may share them, so defaults are separate.
struct EntryShape {
  std::uint8_t sub_first = 0;              ///< the first sub-index
  std::uint8_t sub_last = 0;               ///< the last one, included
  DataType type = DataType::unsigned8;     ///< of each value
  Access access = Access::ro;              ///< rights of clients, and PDOs that may map it
  EntryTraits traits = EntryTraits::none;  ///< what limits and default mean
  std::uint8_t bits = 0;                   ///< length of a number in bits
  std::uint16_t capacity = 0;              ///< bytes that one value takes at most; 0 for a domain
  /// Position of low, high and sentinel in DictionaryTables::numbers, if the entry is limited.
  std::uint16_t limits = 0;
  BlockOffset offset = 0;  ///< of the first value, from the start of the object's values

  /// True for a string: its value has a length of its own before it, and is at most `capacity`.
  constexpr bool is_text() const { return has(traits, EntryTraits::text); }
  /// Distance in bytes from one value to the next: a string has its present length in two bytes
  /// before it.
  constexpr std::uint16_t pitch() const {
    return static_cast<std::uint16_t>(capacity + (is_text() ? 2 : 0));
  }
  friend bool operator==(const EntryShape&, const EntryShape&) = default;
};

/// Objects of one shape: `count` objects with consecutive indices. A description gives the number
/// of entries; the layout fills in the members after it.
struct ObjectRow {
  std::uint16_t index = 0;        ///< index of the first object
  std::uint16_t count = 1;        ///< objects, consecutive from `index`
  std::uint16_t entry_count = 0;  ///< rows in the table of entries
  std::uint16_t entry_first = 0;  ///< position in the table of entries
  /// Position of the first entry's default, and the distance to that of the next object: 0 if all
  /// objects share the same defaults.
  std::uint16_t default_first = 0;
  std::uint16_t default_pitch = 0;  ///< 0: shared by all objects
  BlockOffset offset = 0;           ///< of the first object's values, from the start of the block
  BlockOffset pitch = 0;            ///< bytes from one object's values to the next object's
};

class Dictionary;
struct DictionaryTables;

/// For hosts: the block of values as it is after power-on, made once, so that a reset copies it
/// (initial_values.hpp).
struct InitialValues {
  /// A number to which the node-ID is added.
  struct WithNodeId {
    std::uint32_t offset = 0;  ///< in bytes from the start of the block
    std::uint32_t size = 0;    ///< in bytes, 1 to 8
  };
  std::span<const std::uint8_t> bytes;       ///< the block, without node-ID
  std::span<const WithNodeId> with_node_id;  ///< ordered by their offsets
};

/// Checks limits, and unused bits of odd-sized types, for a value that has the length of its type.
AbortCode check_number(const DictionaryTables& tables, const EntryShape& row,
                       const std::uint8_t* value);

/// The run-time part of a description: constant, and shared by all nodes of a kind.
struct DictionaryTables {
  std::span<const ObjectRow> objects;   ///< sorted by index, without overlap
  std::span<const EntryShape> entries;  ///< of each object sorted by sub-index, without overlap
  /// Default of each entry of an object: a number, or the bits of a real; for more than four bytes
  /// its position in `numbers`, for a string its position in `texts`.
  std::span<const std::uint32_t> defaults;
  /// Limits, sentinels, and defaults of more than four bytes.
  std::span<const std::int64_t> numbers;
  std::span<const std::string_view> texts;  ///< defaults of strings; they outlive the tables
  std::uint32_t value_bytes = 0;            ///< size of the block of values
  /// For devices with objects that move: index in the tables of the object that the bus addresses
  /// by `index`, 0 if there is none. Null: no object moves.
  std::uint16_t (*index_in_tables)(const Dictionary&, std::uint16_t index) = nullptr;
  /// Null if no entry has anything to check, so that a small machine does not link it.
  AbortCode (*check_number)(const DictionaryTables& tables, const EntryShape& row,
                            const std::uint8_t* value) = &canvoy::check_number;
  /// Empty: a reset goes through all rows.
  [[no_unique_address]] HostOnly<InitialValues> initial = {};

  /// Shapes of the entries of an object, sorted by sub-index; empty for an object without entries.
  constexpr std::span<const EntryShape> entries_of(const ObjectRow& object) const {
    return entries.subspan(object.entry_first, object.entry_count);
  }
  /// Defaults of the object with index `index` in such a row.
  constexpr const std::uint32_t* defaults_of(const ObjectRow& object, unsigned index) const {
    return defaults.data() + object.default_first + (index - object.index) * object.default_pitch;
  }
  /// A default from `defaults` in its full form: a number or the bits of a real, without the
  /// node-ID that may be added.
  constexpr std::uint64_t number_at(const EntryShape& row, std::uint32_t place) const {
    return row.capacity > sizeof place ? static_cast<std::uint64_t>(numbers[place]) : place;
  }
};

}  // namespace canvoy
