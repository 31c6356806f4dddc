// Values of any described entry, for tools that get the description at run time. Nothing here makes
// text or allocates memory.
//
//     const Reading reading = read_value(object.entry, bytes);
//     if (reading.kind == Reading::Kind::number) show(reading.number, reading.value->unit);
//     Result<std::uint64_t> raw = raw_from_physical(entry.value, bits_of(entry), 21.5);
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy {

/// Value of an entry or a field.
struct Reading {
  /// Which of the members of a Reading count.
  enum class Kind : std::uint8_t {
    none,    ///< the bytes are no value of this type: too few or too many
    number,  ///< `number`, in the unit of `value`
    name,    ///< `named`: a state, or the reason why there is no number
    text,    ///< `text`
    bytes,   ///< octets, a domain, a point in time: shown as bytes
  };
  Kind kind = Kind::none;             ///< see Kind
  const ValueInfo* value = nullptr;   ///< where its unit and scale are; null for texts and bytes
  const NamedValue* named = nullptr;  ///< if it has a name; otherwise null
  double number = 0;                  ///< physical
  std::int64_t raw = 0;               ///< as on the wire, with its sign
  bool out_of_range = false;          ///< beyond absolute limits
  std::string_view text = {};         ///< if it is a string
};
/// Reads the whole entry. A text lives as long as `bytes`.
Reading read_value(const EntryInfo& entry, std::span<const std::uint8_t> bytes);
/// Reads one field of it.
Reading read_field(const EntryInfo& entry, const FieldInfo& field,
                   std::span<const std::uint8_t> bytes);

/// Number to send for a physical value that a user entered: rounded, but not replaced by a valid
/// one as with handles. Aborts: value_too_low, value_too_high; value_range where the number would
/// be no value.
Result<std::uint64_t> raw_from_physical(const ValueInfo& value, const BitRange& bits,
                                        double physical);

}  // namespace canvoy
