#include "canvoy/tools/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "canvoy/tools/spelling.hpp"

namespace canvoy::tools {

namespace {

/// CLI11 explains some errors over several lines; the first says what is wrong.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// The innermost verb that was understood, and how it is called: `canvoy run charger`.
struct Understood {
  const CLI::App* app;
  std::string text;
};
Understood understood(const CLI::App& app) {
  Understood made{&app, app.get_name()};
  while (!made.app->get_subcommands().empty()) {
    made.app = made.app->get_subcommands().front();
    made.text += ' ' + made.app->get_name();
  }
  return made;
}

/// What could stand there in place of an unknown word: options, or verbs.
std::vector<std::string> words_known_to(const CLI::App& app, bool is_option) {
  std::vector<std::string> words;
  if (is_option) {
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
    return words;
  }
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!verb->get_group().empty()) words.push_back(verb->get_name());
  }
  return words;
}

}  // namespace

/// CLI11 asks for what is missing before it looks at what is too much, which is mostly the same
/// thing misspelt.
std::string refusal(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  const int code = error.get_exit_code();
  const bool is_unknown =
      !unknown.empty() && (code == static_cast<int>(CLI::ExitCodes::RequiredError) ||
                           code == static_cast<int>(CLI::ExitCodes::ExtrasError));
  const Understood verb = understood(app);
  if (!is_unknown) return fmt::format("{}; see {} --help", first_line(error.what()), verb.text);
  const std::string word = first_line(unknown.front());
  const std::string name = word.substr(0, word.find('='));
  const std::string meant = did_you_mean(name, words_known_to(*verb.app, word.starts_with('-')));
  return fmt::format("'{}' is not known here{}{} {} --help", word, meant,
                     meant.empty() ? "; see" : " See", verb.text);
}

}  // namespace canvoy::tools
