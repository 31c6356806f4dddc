// The subcommands of the canvoy command. Each function adds one to the command line, with its
// action.
#pragma once

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

// Each is in a file of its name; those that send requests on a bus are in ask/ask_verbs.hpp.
void add_run(Verb& app);
void add_device(Verb& app);
void add_monitor(Verb& app);
void add_view(Verb& app);
void add_report(Verb& app);
void add_decode(Verb& app);
void add_convert_log(Verb& app);
void add_record(Verb& app);
void add_replay(Verb& app);
void add_stats(Verb& app);
void add_doctor(Verb& app);
void add_check(Verb& app);
void add_explain(Verb& app);
void add_search(Verb& app);
void add_program(Verb& app);
void add_boot(Verb& app);
void add_gateway(Verb& app);
void add_lss(Verb& app);
void add_profile(Verb& app);
void add_eds(Verb& app);
void add_export_table(Verb& app);
void add_scan(Verb& app);
void add_clone(Verb& app);
void add_plot(Verb& app);
void add_browse(Verb& app);
/// For shells and man; not in the help.
void add_help_verbs(Verb& app);

}  // namespace canvoy::tools
