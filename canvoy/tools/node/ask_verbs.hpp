// The verbs that send requests on one bus, which lines of a script may use as well.
#pragma once

#include <string_view>

#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/session/sessions.hpp"

namespace canvoy::tools {

// Each is in a file of its name or its group.
void add_read(Verb& app, Sessions& sessions);
void add_write(Verb& app, Sessions& sessions);
void add_nmt(Verb& app, Sessions& sessions);
void add_configure(Verb& app, Sessions& sessions);
void add_store(Verb& app, Sessions& sessions);
void add_restore(Verb& app, Sessions& sessions);
void add_send(Verb& app, Sessions& sessions);
void add_sync(Verb& app, Sessions& sessions);
void add_time(Verb& app, Sessions& sessions);
void add_emcy(Verb& app, Sessions& sessions);
void add_pdo(Verb& app, Sessions& sessions);
void add_expect(Verb& app, Sessions& sessions);
void add_wait(Verb& app, Sessions& sessions);
/// Adds all of these.
void add_ask_verbs(Verb& app, Sessions& sessions);

/// Adds the verb that runs lines of them.
void add_script(Verb& app, Sessions& sessions);

/// True if it is one of them.
bool is_ask_verb(std::string_view name);
/// True if it is a state or a command of `nmt`, in any of its spellings.
bool is_nmt_word(std::string_view word);
/// Adds the verb of this name, or `script`; false if there is none.
bool add_ask_verb(Verb& app, Sessions& sessions, std::string_view name);

}  // namespace canvoy::tools
