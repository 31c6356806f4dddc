#include "canvoy/tools/node/ask_verbs.hpp"

#include <algorithm>
#include <array>

namespace canvoy::tools {

namespace {

struct AskVerb {
  std::string_view name;
  void (*add)(Verb& app, Sessions& sessions);
};
constexpr auto ask_verbs = std::to_array<AskVerb>({
    {"read", add_read},
    {"write", add_write},
    {"nmt", add_nmt},
    {"configure", add_configure},
    {"store", add_store},
    {"restore", add_restore},
    {"send", add_send},
    {"sync", add_sync},
    {"time", add_time},
    {"emcy", add_emcy},
    {"pdo", add_pdo},
    {"expect", add_expect},
    {"wait", add_wait},
});

}  // namespace

void add_ask_verbs(Verb& app, Sessions& sessions) {
  for (const AskVerb& verb : ask_verbs) verb.add(app, sessions);
}

bool is_ask_verb(std::string_view name) {
  return std::ranges::find(ask_verbs, name, &AskVerb::name) != ask_verbs.end();
}

bool add_ask_verb(Verb& app, Sessions& sessions, std::string_view name) {
  if (name == "script") {
    add_script(app, sessions);
    return true;
  }
  const auto* called = std::ranges::find(ask_verbs, name, &AskVerb::name);
  if (called == ask_verbs.end()) return false;
  called->add(app, sessions);
  return true;
}

}  // namespace canvoy::tools
