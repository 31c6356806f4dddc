// Which fields of an entry hold, where what some bits mean depends on others (CiA 417-4: the
// sub-function of an input by its basic function).
//
//     for (const FieldInfo& field : entry.fields) {
//       if (is_active(entry, field, bytes)) show(read_field(entry, field, bytes));
//     }
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/profiles/description.hpp"

namespace canvoy::decoder {

/// Whether the conditions of the field (FieldInfo::when) hold for this value of its entry.
bool is_active(const EntryInfo& entry, const FieldInfo& field, std::span<const std::uint8_t> bytes);

}  // namespace canvoy::decoder
