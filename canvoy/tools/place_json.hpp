// Where a value stands, as all verbs write it in JSON: "index":"6010","sub":"00".
#pragma once

#include <cstdint>

#include "canvoy/words/json_line.hpp"

namespace canvoy::tools {

/// Into the object that is being written.
void append_index(words::JsonLine& json, std::uint16_t index, std::uint8_t sub);

}  // namespace canvoy::tools
