// Checks at compile time that the description of a profile is consistent. A fault does not compile,
// and the error names the reason and the object.
//
//     static_assert(is_consistent<cia419::profile>());
#pragma once

#include <cstddef>
#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy {

namespace detail {

/// True for a pattern of these bits, or a number that they can hold.
constexpr bool fits(std::int64_t number, const BitRange& bits) {
  if (bits.bits >= 63) return true;
  const NumberRange numbers = range_of_type(bits.bits, bits.is_signed);
  const NumberRange patterns = range_of_type(bits.bits, false);
  return numbers.contains(number) || patterns.contains(number);
}

constexpr void check_named_values(const ValueInfo& value, const BitRange& bits) {
  for (std::size_t i = 0; i < value.names.size(); ++i) {
    const NamedValue& named = value.names[i];
    if (named.name.empty()) description_is_wrong("a value has an empty name");
    if (!fits(named.first, bits) || !fits(named.last, bits)) {
      description_is_wrong("a named value does not fit into its bits");
    }
    const NumberRange range = range_of(named, bits);
    if (range.low > range.high) description_is_wrong("a range of named values is exchanged");
    for (std::size_t j = 0; j < i; ++j) {
      const NumberRange other = range_of(value.names[j], bits);
      if (range.low <= other.high && other.low <= range.high) {
        description_is_wrong("two names for one value");
      }
    }
  }
}

constexpr void check_pieces(const ValueInfo& value, const BitRange& bits) {
  std::int64_t last = 0;
  for (const Piece& piece : value.pieces) {
    if (!fits(piece.first, bits) || !fits(piece.last, bits)) {
      description_is_wrong("a piece does not fit into its bits");
    }
    if (piece.first > piece.last) description_is_wrong("a piece is exchanged");
    if (&piece != value.pieces.begin() && piece.first <= last) {
      description_is_wrong("pieces overlap or are not in order");
    }
    last = piece.last;
    if (piece.scale.numerator == 0 || piece.scale.denominator <= 0) {
      description_is_wrong("a scale that cannot be turned round");
    }
  }
}

constexpr void check_value(const ValueInfo& value, const BitRange& bits) {
  check_named_values(value, bits);
  check_pieces(value, bits);
  if (value.scale.numerator == 0 || value.scale.denominator <= 0) {
    description_is_wrong("a scale that cannot be turned round");
  }
  if (value.limits.kind == Limits::Kind::none) return;
  if (value.limits.low > value.limits.high) description_is_wrong("limits are exchanged");
  if (!fits(value.limits.low, bits) || !fits(value.limits.high, bits)) {
    description_is_wrong("limits are beyond the type");
  }
}

/// True if fields that describe the same bits can never hold at the same time: both name a deciding
/// field, and have no value of it in common.
constexpr bool exclude_each_other(const FieldInfo& a, const FieldInfo& b) {
  for (const FieldCondition& one : a.when) {
    bool named = false;
    bool common = false;
    for (const FieldCondition& first : a.when) {
      if (first.field != one.field) continue;
      for (const FieldCondition& second : b.when) {
        if (second.field != one.field) continue;
        named = true;
        common = common || (first.first <= second.last && second.first <= first.last);
      }
    }
    if (named && !common) return true;
  }
  return false;
}

constexpr bool has_field(const EntryInfo& entry, std::string_view name) {
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return true;
  }
  return false;
}

constexpr void check_fields(const EntryInfo& entry) {
  const unsigned length = bit_length(entry.type) == 1 ? 8 : bit_length(entry.type);
  for (std::size_t i = 0; i < entry.fields.size(); ++i) {
    const FieldInfo& field = entry.fields[i];
    if (field.name.empty()) description_is_wrong("a field without a name");
    if (field.bits == 0 || field.first_bit + unsigned{field.bits} > length) {
      description_is_wrong("a field is not within its entry");
    }
    check_value(field.value, bits_of(field));
    for (const FieldCondition& condition : field.when) {
      if (!has_field(entry, condition.field)) description_is_wrong("a condition on no field");
    }
    for (std::size_t j = 0; j < i; ++j) {
      const FieldInfo& other = entry.fields[j];
      const bool overlap = field.first_bit < other.first_bit + other.bits &&
                           other.first_bit < field.first_bit + field.bits;
      if (overlap && !exclude_each_other(field, other)) description_is_wrong("fields overlap");
      if (field.name == other.name && field.number == other.number &&
          !exclude_each_other(field, other)) {
        description_is_wrong("two fields of one name");
      }
    }
  }
}

constexpr void check_default(const EntryInfo& entry, const Default& initial) {
  switch (initial.kind) {
    case Default::Kind::none:
      return;
    case Default::Kind::text:
      if (!is_string(entry.type)) description_is_wrong("a text as the default of a number");
      if (initial.text.size() > entry.capacity) description_is_wrong("a default is too long");
      return;
    case Default::Kind::number:
    case Default::Kind::plus_node_id:
    case Default::Kind::highest_sub:
      break;
  }
  const BitRange bits = bits_of(entry);
  if (bits.bits == 0 || !fits(initial.number, bits)) {
    description_is_wrong("a default does not fit into its type");
  }
  const Limits& limits = entry.value.limits;
  if (limits.kind != Limits::Kind::absolute || initial.kind != Default::Kind::number) return;
  const std::int64_t number =
      number_of(static_cast<std::uint64_t>(initial.number), bits.bits, bits.is_signed);
  const bool inside = number >= limits.low && number <= limits.high;
  if (!inside && find_name(entry.value, number, bits.bits, bits.is_signed) == nullptr) {
    description_is_wrong("a default is outside of its range");
  }
}

constexpr void check_entry(const EntryInfo& entry) {
  if (is_string(entry.type) && entry.capacity == 0) {
    description_is_wrong("a string without a capacity");
  }
  if (bit_length(entry.type) != 0) check_value(entry.value, bits_of(entry));
  check_fields(entry);
  check_default(entry, entry.initial);
  check_default(entry, entry.consumer_initial);
}

}  // namespace detail

/// True if the description of an object is consistent.
constexpr bool is_consistent(const ObjectInfo& object) {
  using detail::description_is_wrong;
  if (object.name.empty()) description_is_wrong("an object without a name");
  if (object.count == 0) description_is_wrong("no object at all");
  const bool has_entry = object.code == ObjectCode::var || object.code == ObjectCode::domain;
  if (has_entry != object.subs.empty()) {
    description_is_wrong("variables have an entry, arrays and records have subs");
  }
  int last = -1;
  for (const EntryInfo& entry : object.entries()) {
    if (entry.sub_first <= last) description_is_wrong("sub-indices are not in order");
    last = entry.last_sub();
    detail::check_entry(entry);
  }
  return true;
}

/// True if the descriptions of a profile are consistent: each of its objects, and their order.
template <const Profile& profile>
consteval bool is_consistent() {
  using detail::description_is_wrong;
  unsigned next = 0;
  for (const ObjectInfo* object : profile.objects) {
    if (object->index < next) description_is_wrong("objects overlap or are not in order");
    next = object->index + unsigned{object->count};
    is_consistent(*object);
  }
  for (const VirtualDeviceInfo& device : profile.virtual_devices) {
    unsigned first = 0;
    for (const DeviceObject& object : device.objects) {
      if (object.index < first) description_is_wrong("objects of a device are not in order");
      first = (object.last == 0 ? object.index : object.last) + 1U;
      if (find_object(profile, object.index) == nullptr) {
        description_is_wrong("a virtual device has an object that is not described");
      }
    }
  }
  for (const PdoInfo& pdo : profile.pdos) {
    unsigned bits = 0;
    for (const std::uint32_t mapped : pdo.mapping) bits += mapped & 0xFF;
    if (bits > 64) description_is_wrong("a PDO maps more than 8 bytes");
  }
  for (const ReadingInfo& reading : profile.readings) {
    for (const ObjectInfo* object : reading.objects) is_consistent(*object);
  }
  return true;
}

}  // namespace canvoy
