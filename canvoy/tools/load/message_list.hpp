// A plain list of the messages on a bus, in TOML:
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

#include "canvoy/tools/cli/toml_file.hpp"
#include "canvoy/tools/load/loaded_bus.hpp"

namespace canvoy::tools {

/// True if a file is such a list, not a network of nodes.
bool is_message_list(const TomlTable& file);

/// Throws Failure with file and line.
LoadedBus read_message_list(TomlTable& file, const std::string& name);

/// Reads deadlines from a file with `[[deadline]]`, each with `id`, `extended` and `deadline`, and
/// `bus` if it applies to one bus only. Throws Failure with file and line, also for an identifier
/// without a message.
void read_deadlines(TomlTable& file, std::vector<LoadedBus>& buses);

}  // namespace canvoy::tools
