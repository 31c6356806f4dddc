// Recognizes a log where a bus is also possible.
//
//     is_log_source("night.log");  // as is "-", and "./night"
#pragma once

#include <string_view>

namespace canvoy::tools {

/// True for `-`, a path, or a name with the ending of a log: no bus has such a name.
bool is_log_source(std::string_view source);

}  // namespace canvoy::tools
