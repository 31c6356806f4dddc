// canvoy complete WORD..., canvoy man [VERB...]: used by shells and man, and hidden in the help.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/help/completion.hpp"
#include "canvoy/tools/help/completion_scripts.hpp"

namespace canvoy::tools {

namespace {

// Makes a man page from the help of a verb, with the same options.
//
//     man_page(app, read);  // canvoy-read(1)

/// In roff, a backslash begins a command, as do a dot and a quote at the start of a line.
std::string roff(std::string_view text) {
  std::string made;
  for (const char c : text) {
    const bool begins_line = made.empty() || made.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) made += "\\&";
    if (c == '\\') {
      made += "\\e";
    } else if (c == '-') {
      made += "\\-";
    } else {
      made += c;
    }
  }
  return made;
}

std::string dashed(std::string name) {
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::vector<OptionInfo> options_of(const Verb& verb, bool is_place) {
  std::vector<OptionInfo> options = verb.options();
  std::erase_if(options, [=](const OptionInfo& option) { return option.is_place != is_place; });
  return options;
}

std::string synopsis(const Verb& verb, const std::string& name) {
  std::string text = fmt::format(".B {}\n", roff(name));
  for (const OptionInfo& place : options_of(verb, true)) {
    const std::string several = place.takes_several ? "..." : "";
    text += place.is_required ? fmt::format(".I {}{}\n", roff(place.name), several)
                              : fmt::format(".RI [ {}{} ]\n", roff(place.name), several);
  }
  if (!verb.verbs().empty()) text += ".I verb\n";
  return text + ".RI [ options ]\n";
}

std::string options_text(const Verb& verb, bool is_place) {
  std::string text;
  for (const OptionInfo& option : options_of(verb, is_place)) {
    text += fmt::format(".TP\n.B {}\n{}\n", roff(option.name), roff(option.about));
  }
  return text;
}

std::string verbs_text(const Verb& verb, const std::string& name) {
  std::string text;
  for (const std::unique_ptr<Verb>& each : verb.verbs()) {
    if (each->is_hidden()) continue;
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(dashed(name) + '-' + each->name()),
                        roff(each->about()));
  }
  return text;
}

/// The footer, if its first line marks examples.
std::string examples_text(const Verb& verb) {
  const std::string footer = verb.footer();
  const std::size_t begin = footer.find('\n');
  if (begin == std::string::npos) return {};
  return ".SH EXAMPLES\n.nf\n" + roff(footer.substr(begin + 1)) + "\n.fi\n";
}

std::string section(const char* title, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
}

/// Returns man(7) source. `name` is the full name of the verb: `canvoy run charger`.
std::string man_page(const Verb& verb, const std::string& name) {
  std::string title = dashed(name);
  std::ranges::transform(title, title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  });
  return fmt::format(".TH {} 1\n.SH NAME\n{} \\- {}\n", roff(title), roff(dashed(name)),
                     roff(verb.about())) +
         section("SYNOPSIS", synopsis(verb, name)) +
         section("ARGUMENTS", options_text(verb, true)) +
         section("OPTIONS", options_text(verb, false)) + section("VERBS", verbs_text(verb, name)) +
         examples_text(verb) +
         ".SH EXIT STATUS\n0: done, and as expected; 1: it failed, or was not as expected; 2: the "
         "command line is wrong.\n";
}

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
