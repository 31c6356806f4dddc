// Values of the object dictionary on the command line: `21.5 °C`, `ready`, `0x1A3`, `hex:01 02`.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::tools {

/// The number in the unit of the value, given in any unit: `0.5 kV`, `1h30min`; nothing if it is no
/// number, or of another quantity.
std::optional<double> parse_amount(const ValueInfo& value, std::string_view text);

/// Reads a value to be written: a number with or without a unit (`21.5 °C`, `0.5 kV`, `1min 30s`),
/// the stored number (`0x1F4`), a name of the profile, fields of the number `present` (`readiness:
/// ready, lamp: on`), a text, or bytes (`hex:01 02`). Throws UsageError with the reason: unknown
/// name, wrong unit, out of range, between two steps, not a number.
std::vector<std::uint8_t> parse_value(const EntryInfo& entry, std::string_view text,
                                      std::uint64_t present = 0);

/// Reads a data type such as `u16`, `i8`, `r32`, `b`, `vs`, `os`, `t`; nothing if unknown (CiA
/// 309-3).
std::optional<DataType> parse_type(std::string_view text);
/// Reads the type of `--type`. Throws UsageError if unknown.
DataType parse_type_argument(std::string_view text);

}  // namespace canvoy::tools
