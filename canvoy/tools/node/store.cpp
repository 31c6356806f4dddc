// canvoy store, restore BUS NODE [GROUP]: stores the parameters of a node, or restores its defaults
// (CiA 301, 7.5.2.13 and 7.5.2.14).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/place_json.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"

namespace canvoy::tools {

namespace {

struct StoreOptions : AskOptions {
  std::string group = "all";
};

/// Store or restore.
struct StoreVerb {
  std::string_view name;
  std::uint16_t index;
  std::string_view signature;
  std::string_view done;
};
constexpr StoreVerb storing = {"store", object_index::store_parameters, "save", "has stored"};
constexpr StoreVerb restoring = {"restore", object_index::restore_parameters, "load",
                                 "takes its defaults at the next reset of"};

constexpr auto store_groups =
    std::to_array<std::string_view>({"all", "communication", "application"});

std::uint8_t parse_group(std::string_view text) {
  const auto* found = std::ranges::find(store_groups, text);
  if (found != store_groups.end()) {
    return static_cast<std::uint8_t>(found - store_groups.begin() + 1);
  }
  unsigned sub = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), sub);
  constexpr unsigned sub_max = 127;
  if (error == std::errc{} && end == text.data() + text.size() && sub >= 1 && sub <= sub_max) {
    return static_cast<std::uint8_t>(sub);
  }
  throw UsageError(fmt::format(
      "'{}' is no group of parameters: all, communication, application, or a sub-index 1 to 127{}",
      text, did_you_mean(text, {store_groups.begin(), store_groups.end()})));
}

std::string group_text(std::uint8_t sub) {
  if (sub > store_groups.size()) return fmt::format("the parameters of sub-index {:02X}h", sub);
  return fmt::format("{} parameters", store_groups.at(sub - 1U));
}

int store_parameters(const StoreOptions& options, Sessions& sessions, const StoreVerb& verb) {
  const NodeId node = options.node_id();
  const std::uint8_t sub = parse_group(options.group);
  Session& session = options.open(sessions);
  const std::vector<std::uint8_t> signature(verb.signature.begin(), verb.signature.end());
  session.write(node, verb.index, sub, signature);
  const std::string text = fmt::format("{} {}", verb.done, group_text(sub));
  if (!options.json) {
    fmt::print("{} {}\n", text::node_text(node), text);
    return exit_done;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text(verb.name);
  json.key("node").number(node);
  append_index(json, verb.index, sub);
  json.key("text").text(text);
  json.end_object();
  fmt::print("{}\n", line);
  return exit_done;
}

void add_store_verb(Verb& app, Sessions& sessions, const StoreVerb& verb, const std::string& text,
                    std::string_view examples) {
  const auto options = std::make_shared<StoreOptions>();
  Verb& command = app.add_verb(std::string(verb.name), text);
  options->add_bus(command);
  options->add_any_node(command);
  command.add({
      {"group", options->group, "all (the default), communication, application, or a sub-index"},
  });
  options->add_time_out(command);
  options->add_json(command);
  command.add_examples(examples);
  command.runs([options, &sessions, &verb] { return store_parameters(*options, sessions, verb); });
}

}  // namespace

void add_store(Verb& app, Sessions& sessions) {
  add_store_verb(app, sessions, storing, "Have a node keep its parameters without power (1010h)",
                 "  canvoy store can0 10\n"
                 "  canvoy store can0 10 communication --json");
}

void add_restore(Verb& app, Sessions& sessions) {
  add_store_verb(app, sessions, restoring,
                 "Have a node go back to its defaults at the next reset (1011h)",
                 "  canvoy restore can0 10\n"
                 "  canvoy restore can0 10 application --timeout 5s");
}

}  // namespace canvoy::tools
