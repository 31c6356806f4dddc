// What the buses of a network of `canvoy run` carry: it is played, and listened to for a time.
//
//     const std::vector<LoadedBus> buses = played_load(table, "lift.toml", 10s, 1min);
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// `length` is listened to, `after` its start. Throws Failure with file and line.
std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration after,
                                   Duration length);

}  // namespace canvoy::tools
