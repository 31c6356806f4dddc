// What the buses of a network of `canvoy run` carry: it is played, and listened to from its start.
//
//     const std::vector<LoadedBus> buses = played_load(table, "lift.toml", 1min);
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line.
std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration length);

}  // namespace canvoy::tools
