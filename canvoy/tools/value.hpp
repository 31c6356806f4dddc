// Values of the object dictionary as people write and read them: `21.5 °C`, `ready`, `0x1A3`, "a
// text".
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

/// The value with its unit, or its name; bytes in hexadecimal where nothing is known of the entry
/// (null).
std::string value_text(const EntryInfo* entry, std::span<const std::uint8_t> bytes);
void append_value_text(std::string& text, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

/// The same for machines: a number in its unit, a name, a text; null where the value is invalid.
nlohmann::json value_json(const EntryInfo* entry, std::span<const std::uint8_t> bytes);
/// What that dumps, at the end of JSON where a value has to follow.
void append_value_json(std::string& line, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

/// Reads a value that is to be written: a number with or without its unit, a name of the profile, a
/// text, or bytes
/// (`hex:01 02`). Throws UsageError with the reason: unknown name, wrong unit, out of range, not a
/// number.
std::vector<std::uint8_t> parse_value(const EntryInfo& entry, std::string_view text);

/// A data type as `u16`, `i8`, `r32`, `b`, `vs`, `os`, `t` (CiA 309-3); nothing for an unknown one.
std::optional<DataType> parse_type(std::string_view text);
/// The same of `--type`: throws UsageError for an unknown one.
DataType parse_type_argument(std::string_view text);

}  // namespace canvoy::tools
