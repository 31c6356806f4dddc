// A plain list of what is sent on a bus, in TOML:
//
//     bit_rate = 125000
//     [errors]
//     at_once = 1
//     each = "100ms"
//     [[message]]
//     id = 0x185
//     bytes = 8
//     period = "10ms"
#pragma once

#include <string>

#include "canvoy/tools/load/loaded_bus.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// Whether a file is such a list, and no network of nodes.
bool is_message_list(const TomlTable& file);

/// Throws Failure with file and line.
LoadedBus read_message_list(TomlTable& file, const std::string& name);

/// Takes other deadlines, of a file with `[[deadline]]`, each with `id`, `extended` and `deadline`,
/// and `bus` where it holds on one alone. Throws Failure with file and line, also for an identifier
/// that nobody sends.
void read_deadlines(TomlTable& file, std::vector<LoadedBus>& buses);

}  // namespace canvoy::tools
