// Values of any described entry, for tools that learn at run time what they look at. Nothing here
// makes text or takes memory.
//
//     const Reading reading = read_value(object.entry, bytes);
//     if (reading.kind == Reading::Kind::number) show(reading.number, reading.value->unit);
//     Result<std::uint64_t> raw = raw_from_physical(entry.value, bits_of(entry), 21.5);
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/profiles/description.hpp"
#include "canvoy/profiles/number_rules.hpp"

namespace canvoy {

/// What an entry or a field of it says.
struct Reading {
  enum class Kind : std::uint8_t {
    none,    ///< the bytes are no value of this type: too few, or too many
    number,  ///< `number`, in the unit of `value`
    name,    ///< `named`: a state, or why there is no number
    text,    ///< `text`
    bytes,   ///< octets, a domain, a point in time: to be shown as they are
  };
  Kind kind = Kind::none;
  const ValueInfo* value = nullptr;
  const NamedValue* named = nullptr;
  double number = 0;
  std::int64_t raw = 0;
  bool out_of_range = false;  ///< beyond limits that are absolute
  std::string_view text = {};
};
/// The whole entry; a text lives as long as `bytes`.
Reading read_value(const EntryInfo& entry, std::span<const std::uint8_t> bytes);
/// One field of it.
Reading read_field(const EntryInfo& entry, const FieldInfo& field,
                   std::span<const std::uint8_t> bytes);

/// The number to send for a physical value that a person asked for: rounded, but never repaired, as
/// handles do. Aborts: value_too_low, value_too_high; value_range where the number would stand for
/// no value.
Result<std::uint64_t> raw_from_physical(const ValueInfo& value, const BitRange& bits,
                                        double physical);

}  // namespace canvoy
