// canvoy complete WORD..., canvoy man [VERB...]: what shells and man ask for; people see neither.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/completion.hpp"
#include "canvoy/tools/help/man_page.hpp"
#include "canvoy/tools/spelling.hpp"
#include "canvoy/tools/value_file.hpp"

namespace canvoy::tools {

namespace {

struct HelpOptions {
  std::vector<std::string> words = {};
  std::string folder = {};
};

int print_completions(const CLI::App& app, const HelpOptions& options) {
  // Nobody wants to read in the middle of a line what is wrong with a file.
  try {
    for (const std::string& word : completions(app, options.words)) fmt::print("{}\n", word);
  } catch (const Failure&) {
    return exit_failed;
  }
  return exit_done;
}

/// A page, and those of the verbs below.
void write_pages(const CLI::App& verb, const std::string& name, const std::string& folder) {
  std::string file = name;
  std::ranges::replace(file, ' ', '-');
  const std::string text = man_page(verb, name);
  write_value_file(fmt::format("{}/{}.1", folder, file),
                   {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  for (const CLI::App* each : verb.get_subcommands(nullptr)) {
    if (!each->get_group().empty()) write_pages(*each, name + ' ' + each->get_name(), folder);
  }
}

int print_page(const CLI::App& app, const HelpOptions& options) {
  if (!options.folder.empty()) {
    write_pages(app, app.get_name(), options.folder);
    return exit_done;
  }
  const CLI::App* verb = &app;
  std::string name = app.get_name();
  for (const std::string& word : options.words) {
    const CLI::App* next = nullptr;
    for (const CLI::App* each : verb->get_subcommands(nullptr)) {
      if (each->get_name() == word) next = each;
    }
    if (next == nullptr) {
      std::vector<std::string> known;
      for (const CLI::App* each : verb->get_subcommands(nullptr)) known.push_back(each->get_name());
      throw UsageError(
          fmt::format("'{}' is no verb of {}{}", word, name, did_you_mean(word, known)));
    }
    verb = next;
    name += ' ' + word;
  }
  fmt::print("{}", man_page(*verb, name));
  return exit_done;
}

}  // namespace

void add_help_verbs(CLI::App& app, Action& action) {
  const auto options = std::make_shared<HelpOptions>();
  CLI::App* complete = app.add_subcommand("complete", "What may stand next on a command line");
  complete->group("")->fallthrough(false);
  complete->add_option("word", options->words, "those behind canvoy, behind --");
  complete->callback([&app, options, &action] {
    action = [&app, options] { return print_completions(app, *options); };
  });
  CLI::App* man = app.add_subcommand("man", "The help of a verb as a page for man");
  man->group("");
  man->add_option("verb", options->words, "none: of all");
  man->add_option("--all", options->folder, "write all pages into this folder");
  man->callback(
      [&app, options, &action] { action = [&app, options] { return print_page(app, *options); }; });
}

}  // namespace canvoy::tools
