// The subcommands of the canvoy command: each adds itself to the command line, and says what it
// does when it is chosen.
#pragma once

#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

/// What the chosen subcommand does; it returns the exit status.
using Action = std::function<int()>;

// Each in a file of its name; those that ask and tell on a bus are in ask/ask_verbs.hpp. `action`
// is set when the subcommand was chosen, and must outlive the parsing.
void add_run(CLI::App& app, Action& action);
void add_device(CLI::App& app, Action& action);
void add_monitor(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_decode(CLI::App& app, Action& action);
void add_convert_log(CLI::App& app, Action& action);
void add_program(CLI::App& app, Action& action);
void add_boot(CLI::App& app, Action& action);
void add_gateway(CLI::App& app, Action& action);
void add_lss(CLI::App& app, Action& action);
void add_profile(CLI::App& app, Action& action);
void add_eds(CLI::App& app, Action& action);
void add_export_table(CLI::App& app, Action& action);
void add_scan(CLI::App& app, Action& action);
void add_clone(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_browse(CLI::App& app, Action& action);
/// For shells and man: not in the help.
void add_help_verbs(CLI::App& app, Action& action);

}  // namespace canvoy::tools
