// Values of data sheets as bytes, as they stand in a dictionary.
//
//     sheet_bytes(DataType::unsigned32, "$NODEID+0x180", 5)  // 85 01 00 00
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// Nothing where the text is no value of the type, or beyond what the type holds. Strings are taken
/// as they are; of an octet string, pairs of hexadecimal digits. An empty text is 0, or an empty
/// string.
std::optional<std::vector<std::uint8_t>> sheet_bytes(DataType type, std::string_view text,
                                                     std::uint8_t node_id);
/// The other way round; nothing where the bytes are no value of the type, or a text that no line of
/// a file can hold. Zeros behind a text are padding.
std::optional<std::string> sheet_value_text(DataType type, std::span<const std::uint8_t> bytes);
/// A raw number in the notation that its type asks for: `0x1A`, `-5`, `1.5`.
std::string sheet_number_text(std::int64_t number, DataType type);
/// The type of this index, where values of it can be told.
std::optional<DataType> sheet_type(unsigned data_type);
/// Whether two texts are the same value, however they are written.
bool same_value(unsigned data_type, std::string_view a, std::string_view b);

}  // namespace canvoy::formats
