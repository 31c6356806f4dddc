// canvoy complete WORD..., canvoy man [VERB...]: used by shells and man, and hidden in the help.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/help/completion.hpp"
#include "canvoy/tools/help/completion_scripts.hpp"
#include "canvoy/tools/help/man_page.hpp"

namespace canvoy::tools {

namespace {

struct HelpOptions {
  std::vector<std::string> words = {};
  std::string folder = {};
};

int print_completions(const Verb& app, const HelpOptions& options) {
  // Errors of a file must not appear in the middle of a command line.
  try {
    for (const std::string& word : completions(app, options.words)) fmt::print("{}\n", word);
  } catch (const Failure&) {
    return exit_failed;
  }
  return exit_done;
}

/// Writes a page, and those of the verbs below.
void write_pages(const Verb& verb, const std::string& name, const std::string& folder) {
  std::string file = name;
  std::ranges::replace(file, ' ', '-');
  const std::string text = man_page(verb, name);
  write_value_file(fmt::format("{}/{}.1", folder, file),
                   {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  for (const std::unique_ptr<Verb>& each : verb.verbs()) {
    if (!each->is_hidden()) write_pages(*each, name + ' ' + each->name(), folder);
  }
}

int print_page(const Verb& app, const HelpOptions& options) {
  if (!options.folder.empty()) {
    write_pages(app, app.name(), options.folder);
    return exit_done;
  }
  const Verb* verb = &app;
  std::string name = app.name();
  for (const std::string& word : options.words) {
    const Verb* next = nullptr;
    for (const std::unique_ptr<Verb>& each : verb->verbs()) {
      if (each->name() == word) next = each.get();
    }
    if (next == nullptr) {
      std::vector<std::string> known;
      for (const std::unique_ptr<Verb>& each : verb->verbs()) known.push_back(each->name());
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

void add_help_verbs(Verb& app) {
  const auto options = std::make_shared<HelpOptions>();
  Verb& complete = app.add_verb("complete", "What may stand next on a command line");
  complete.hide();
  complete.keep_options_apart();
  complete.add({{"word", options->words, "those behind canvoy, behind --"}});
  complete.runs([&app, options] { return print_completions(app, *options); });
  Verb& completion = app.add_verb("completion", "What bash, zsh or fish wants to complete canvoy");
  completion.add({{"shell",
                   options->folder,
                   "bash, zsh or fish",
                   {.is_required = true, .allowed = OneOf{"bash", "zsh", "fish"}}}});
  completion.add_examples(
      "  canvoy completion bash > canvoy.bash\n"
      "  canvoy completion zsh > _canvoy\n"
      "  canvoy completion fish > canvoy.fish");
  completion.runs([options] {
    const std::string& shell = options->folder;
    fmt::print("{}", shell == "bash"  ? bash_completion
                     : shell == "zsh" ? zsh_completion
                                      : fish_completion);
    return exit_done;
  });
  Verb& man = app.add_verb("man", "The help of a verb as a page for man");
  man.hide();
  man.add({
      {"verb", options->words, "none: of all"},
      {"--all", options->folder, "write all pages into this folder"},
  });
  man.runs([&app, options] { return print_page(app, *options); });
}

}  // namespace canvoy::tools
