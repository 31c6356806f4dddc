#include "canvoy/tools/ask/ask_verbs.hpp"

namespace canvoy::tools {

void add_ask_verbs(CLI::App& app, Action& action, Sessions& sessions) {
  for (const auto add : {add_read, add_write, add_nmt, add_configure, add_store, add_restore,
                         add_send, add_sync, add_time, add_emcy, add_pdo, add_expect, add_wait}) {
    add(app, action, sessions);
  }
}

}  // namespace canvoy::tools
