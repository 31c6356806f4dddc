// The subcommands that look at buses, nodes and logs, and write down what they see: as
// commands.hpp.
#pragma once

#include "canvoy/tools/commands.hpp"

namespace canvoy::tools {

void add_export_table(CLI::App& app, Action& action);
void add_scan(CLI::App& app, Action& action);
void add_clone(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_browse(CLI::App& app, Action& action);

}  // namespace canvoy::tools
