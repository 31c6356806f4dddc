#include "canvoy/tools/help/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canvoy::tools {

namespace {

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

}  // namespace

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

}  // namespace canvoy::tools
