// Tells which fields of an entry are valid where the meaning of some bits depends on others, such
// as the sub-function of an input on its basic function (CiA 417-4).
//
//     for (const FieldInfo& field : entry.fields) {
//       if (is_active(entry, field, bytes)) show(read_field(entry, field, bytes));
//     }
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::decoder {

/// True if the conditions of the field (FieldInfo::when) are met by this value of its entry.
bool is_active(const EntryInfo& entry, const FieldInfo& field, std::span<const std::uint8_t> bytes);

}  // namespace canvoy::decoder
