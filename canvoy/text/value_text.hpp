// Text of values of the object dictionary, for people and programs: `21.5 °C`, `ready`, `"a text"`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::text {

/// The value with its unit, or its name; bytes if the entry is unknown (null). The text appended to
/// a line is short: for an entry with many bits it omits unset bits of the same kind.
std::string value_text(const EntryInfo* entry, std::span<const std::uint8_t> bytes);
/// Like value_text(), at the end of `text`.
void append_value_text(std::string& text, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

/// Appends the value as JSON, where a value must follow: a number in its unit, a name, a string;
/// null if the value is invalid.
void append_value_json(std::string& line, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes);

}  // namespace canvoy::text
