// The verbs that ask and tell on one bus: those of the command line that a script's lines may call
// as well.
#pragma once

#include <string_view>

#include "canvoy/tools/ask/sessions.hpp"
#include "canvoy/tools/commands.hpp"

namespace canvoy::tools {

// Each in a file of its name or its group.
void add_read(CLI::App& app, Action& action, Sessions& sessions);
void add_write(CLI::App& app, Action& action, Sessions& sessions);
void add_nmt(CLI::App& app, Action& action, Sessions& sessions);
void add_configure(CLI::App& app, Action& action, Sessions& sessions);
void add_store(CLI::App& app, Action& action, Sessions& sessions);
void add_restore(CLI::App& app, Action& action, Sessions& sessions);
void add_send(CLI::App& app, Action& action, Sessions& sessions);
void add_sync(CLI::App& app, Action& action, Sessions& sessions);
void add_time(CLI::App& app, Action& action, Sessions& sessions);
void add_emcy(CLI::App& app, Action& action, Sessions& sessions);
void add_pdo(CLI::App& app, Action& action, Sessions& sessions);
void add_expect(CLI::App& app, Action& action, Sessions& sessions);
void add_wait(CLI::App& app, Action& action, Sessions& sessions);
/// All of these.
void add_ask_verbs(CLI::App& app, Action& action, Sessions& sessions);

/// Lines of them.
void add_script(CLI::App& app, Action& action, Sessions& sessions);

/// Whether it is one of them.
bool is_ask_verb(std::string_view name);
/// The one of this name, or `script`; false where there is none.
bool add_ask_verb(CLI::App& app, Action& action, Sessions& sessions, std::string_view name);

}  // namespace canvoy::tools
