#include "canvoy/tools/help/man_page.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace canvoy::tools {

namespace {

/// For roff a backslash begins a command, as do a dot and a quote at the beginning of a line.
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

std::vector<const CLI::Option*> options_of(const CLI::App& verb, bool positional) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_positional() == positional && !option->get_group().empty()) {
      options.push_back(option);
    }
  }
  return options;
}

std::string synopsis(const CLI::App& verb, const std::string& name) {
  std::string text = fmt::format(".B {}\n", roff(name));
  for (const CLI::Option* option : options_of(verb, true)) {
    const std::string word = option->get_single_name();
    const std::string several = option->get_expected_max() > 1 ? "..." : "";
    text += option->get_required() ? fmt::format(".I {}{}\n", roff(word), several)
                                   : fmt::format(".RI [ {}{} ]\n", roff(word), several);
  }
  if (!verb.get_subcommands(nullptr).empty()) text += ".I verb\n";
  return text + ".RI [ options ]\n";
}

std::string options_text(const CLI::App& verb, bool positional) {
  std::string text;
  for (const CLI::Option* option : options_of(verb, positional)) {
    text += fmt::format(".TP\n.B {}\n{}\n", roff(option->get_name(positional)),
                        roff(option->get_description()));
  }
  return text;
}

std::string verbs_text(const CLI::App& verb, const std::string& name) {
  std::string text;
  for (const CLI::App* each : verb.get_subcommands(nullptr)) {
    if (each->get_group().empty()) continue;
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(dashed(name) + '-' + each->get_name()),
                        roff(each->get_description()));
  }
  return text;
}

/// The footer, whose first line says that they are examples.
std::string examples_text(const CLI::App& verb) {
  const std::string footer = verb.get_footer();
  const std::size_t begin = footer.find('\n');
  if (begin == std::string::npos) return {};
  return ".SH EXAMPLES\n.nf\n" + roff(footer.substr(begin + 1)) + "\n.fi\n";
}

std::string section(const char* title, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
}

}  // namespace

std::string man_page(const CLI::App& verb, const std::string& name) {
  std::string title = dashed(name);
  std::ranges::transform(title, title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  });
  return fmt::format(".TH {} 1\n.SH NAME\n{} \\- {}\n", roff(title), roff(dashed(name)),
                     roff(verb.get_description())) +
         section("SYNOPSIS", synopsis(verb, name)) +
         section("ARGUMENTS", options_text(verb, true)) +
         section("OPTIONS", options_text(verb, false)) + section("VERBS", verbs_text(verb, name)) +
         examples_text(verb) +
         ".SH EXIT STATUS\n0: done, and as expected; 1: it failed, or was not as expected; 2: the "
         "command line is wrong.\n";
}

}  // namespace canvoy::tools
