// Converts values of data sheets to bytes, as in a dictionary, and back.
//
//     sheet_bytes(DataType::unsigned32, "$NODEID+0x180", 5)  // 85 01 00 00
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats {

/// Converts a text to bytes. Nothing if it is not a value of the type, or out of its range. Strings
/// are taken as they are, octet strings as pairs of hexadecimal digits. An empty text is 0, or an
/// empty string.
std::optional<std::vector<std::uint8_t>> sheet_bytes(DataType type, std::string_view text,
                                                     std::uint8_t node_id);
/// Converts bytes to a text. Nothing if they are not a value of the type, or a text that a line of
/// a file cannot hold. Zeros after a text are padding.
std::optional<std::string> sheet_value_text(DataType type, std::span<const std::uint8_t> bytes);
/// A raw number in the notation of its type: `0x1A`, `-5`, `1.5`.
std::string sheet_number_text(std::int64_t number, DataType type);
/// The type with this index, if its values have a notation.
std::optional<DataType> sheet_type(unsigned data_type);
/// True if two texts have the same value in any notation.
bool same_value(unsigned data_type, std::string_view a, std::string_view b);

}  // namespace canvoy::formats
