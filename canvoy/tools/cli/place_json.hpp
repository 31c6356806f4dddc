// The address of a value in JSON, equal for all verbs: "index":"6010","sub":"00".
#pragma once

#include <cstdint>

#include "canvoy/text/json_line.hpp"

namespace canvoy::tools {

/// Appends it to the current object.
void append_index(text::JsonLine& json, std::uint16_t index, std::uint8_t sub);

}  // namespace canvoy::tools
