// The canvoy command.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/argument/remote_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/load/load.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/front_options.hpp"
#include "canvoy/tools/node/other_names.hpp"
#include "canvoy/tools/node/typed_options.hpp"
#include "canvoy/tools/node/typed_words.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/terminal/terminal_text.hpp"
#include "canvoy/version.hpp"

namespace canvoy::tools {
namespace {

constexpr const char* version_option = "--version";
constexpr const char* output_lost = "the output could not be written: is there room on the disk?";

/// Printed output may still be in a buffer, for a disk that is full.
int finish_output(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  throw Failure(output_lost);
}

/// A verb of the command line.
struct VerbEntry {
  std::string_view name;
  void (*add)(Verb& app);
};
constexpr auto verb_entries = std::to_array<VerbEntry>({
    {"run", add_run},
    {"device", add_device},
    {"monitor", add_monitor},
    {"view", add_view},
    {"report", add_report},
    {"decode", add_decode},
    {"convert-log", add_convert_log},
    {"record", add_record},
    {"replay", add_replay},
    {"stats", add_stats},
    {"doctor", add_doctor},
    {"check", add_check},
    {"load", add_load},
    {"explain", add_explain},
    {"search", add_search},
    {"program", add_program},
    {"boot", add_boot},
    {"gateway", add_gateway},
    {"lss", add_lss},
    {"profile", add_profile},
    {"eds", add_eds},
    {"export", add_export_table},
    {"scan", add_scan},
    {"clone", add_clone},
    {"plot", add_plot},
    {"browse", add_browse},
});

static_assert(std::ranges::all_of(verb_entries, [](const VerbEntry& verb) {
  return std::ranges::find(verb_words, verb.name, &VerbWords::name) != verb_words.end();
}));

/// Adds only the called verb if it is unambiguous: describing all of them takes longer than most of
/// them run.
void add_verbs(Verb& app, Sessions& sessions, std::string_view first_word) {
  if (first_word == version_option) return;
  const auto* called = std::ranges::find(verb_entries, first_word, &VerbEntry::name);
  if (called != verb_entries.end()) return called->add(app);
  if (add_ask_verb(app, sessions, first_word)) return;
  for (const VerbEntry& verb : verb_entries) verb.add(app);
  add_ask_verbs(app, sessions);
  add_script(app, sessions);
  add_help_verbs(app);
}

/// A line with what all verbs have, and the called verb.
std::unique_ptr<CommandLine> line_of(std::string_view first_word, Sessions& sessions) {
  auto line = std::make_unique<CommandLine>(
      "Canvoy: see, simulate, test and drive CANopen networks", "canvoy");
  line->set_version(version_option, fmt::format("canvoy {}", version));
  line->require_verb();
  line->take_options_anywhere();
  line->add_taken("--colour,--color", use_colour,
                  "everywhere: auto (on a terminal, unless NO_COLOR is set), always or never");
  line->add_taken(
      "--network", use_network_file,
      "everywhere: a file of the network, whose names of nodes are understood (default: "
      "$CANVOY_NETWORK)");
  add_verbs(*line, sessions, first_word);
  return line;
}

/// For verbs that send requests to nodes, `can0/2:7` is the bus and the node.
std::vector<std::string> words_of(int count, char** arguments, Sessions& sessions) {
  std::vector<std::string> words = typed_words(with_options_behind_verb(
      {arguments + 1, arguments + count},
      [&sessions](std::string_view verb) { return line_of(verb, sessions); }));
  if (words.empty() || !is_ask_verb(words.front())) return words;
  std::vector<std::string> behind_verb(words.begin() + 1, words.end());
  split_remote_bus(behind_verb);
  behind_verb.insert(behind_verb.begin(), words.front());
  return behind_verb;
}

int run(int count, char** arguments) {
  Sessions sessions;
  try {
    using Kind = CommandLine::Outcome::Kind;
    const std::vector<std::string> words = words_of(count, arguments, sessions);
    const std::unique_ptr<CommandLine> line =
        line_of(words.empty() ? std::string_view{} : std::string_view(words.front()), sessions);
    const CommandLine::Outcome outcome =
        line->parse(with_known_options(words, *line), terminal_width(STDOUT_FILENO));
    if (outcome.kind == Kind::understood) return finish_output(line->run());
    if (outcome.kind == Kind::answered) {
      fmt::print("{}", outcome.text);
      return finish_output(exit_done);
    }
    print_message(fmt::format("canvoy: {}", outcome.text));
    return exit_usage;
  } catch (const Failure& failure) {
    // The message may quote the content of a file.
    print_message(fmt::format("canvoy: {}", formats::plain_text(failure.what())));
    return failure.status();
  } catch (const std::system_error&) {
    // Thrown by {fmt} if it cannot print.
    print_message(fmt::format("canvoy: {}", output_lost));
    return exit_failed;
  }
}

}  // namespace
}  // namespace canvoy::tools

int main(int count, char** arguments) {
  return canvoy::tools::run(count, arguments);
}
