// Load of the buses of a network of `canvoy run`, which is played and listened to for a time.
//
//     const std::vector<LoadedBus> buses = played_load(table, "lift.toml", 10s, 1min);
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"

namespace canvoy::tools {

/// Listens for `length`, starting `after` its start. Throws Failure with file and line.
std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration after,
                                   Duration length);

}  // namespace canvoy::tools
