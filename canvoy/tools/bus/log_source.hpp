// What is a log where a bus may stand as well.
//
//     is_log_source("night.log");  // as is "-", and "./night"
#pragma once

#include <string_view>

namespace canvoy::tools {

/// `-`, a path, or a name that ends as those of logs do: no bus has such a name.
bool is_log_source(std::string_view source);

}  // namespace canvoy::tools
