// Values of the object dictionary as people and programs read them: `21.5 °C`, `ready`, `"a text"`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/profiles/description.hpp"

namespace canvoy::words {

/// The value with its unit, or its name; bytes where nothing is known of the entry (null). Added to
/// a line, it is short: of an entry with many bits those that are unset and alike are left out.
std::string value_text(const EntryInfo* entry, std::span<const std::uint8_t> bytes);
void append_value_text(std::string& text, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

/// The same for machines, at the end of JSON where a value has to follow: a number in its unit, a
/// name, a text; null where the value is invalid.
void append_value_json(std::string& line, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

}  // namespace canvoy::words
