#include "canvoy/tools/cli/verb.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

#include "canvoy/tools/cli/bit_rate_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/meant_line.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

/// Measures of the help.
struct HelpLayout {
  std::size_t width = 100;
  std::size_t descriptions = 34;  ///< column where they begin
  bool is_terminal = false;
};
HelpLayout layout_for(std::size_t columns) {
  constexpr std::size_t columns_min = 20;
  HelpLayout made;
  made.is_terminal = columns != 0;
  if (columns == 0 || columns >= made.width) return made;
  made.width = std::max(columns, columns_min);
  made.descriptions = std::min(made.descriptions, made.width * 2 / 5);
  return made;
}

/// No range excludes what is not a number: it is neither below nor above its bounds.
std::string finite_only(const std::string& text) {
  double value = 0;
  const bool is_number = CLI::detail::lexical_cast(text, value);
  return !is_number || std::isfinite(value) ? "" : fmt::format("{} is no finite number", text);
}

/// A number beyond 64 bits is read as the greatest one, without a word.
std::string in_64_bits_only(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error != std::errc::result_out_of_range
             ? ""
             : fmt::format("'{}' is no whole number up to {}", text, UINT64_MAX);
}

std::string counts(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool is_count = error == std::errc{} && stop == end && value != 0;
  return is_count ? "" : fmt::format("'{}' is no whole number above 0", text);
}

/// Reads a bit rate in any of its forms, for an option in kbit/s.
std::string kilobits(const std::string& text) {
  constexpr std::uint32_t kilo = 1000;
  const std::optional<std::uint32_t> bits = parse_bit_rate(text);
  if (bits && *bits % kilo == 0) return std::to_string(*bits / kilo);
  throw CLI::ValidationError(fmt::format(
      "'{}' is no bit rate of whole kbit/s up to 1 Mbit/s: give 125, 125k or 125000", text));
}

CLI::Option* add_row(CLI::App& app, const OptionRow& row) {
  return std::visit(
      [&](auto* place) {
        const std::string about(row.about);
        // As everywhere, -o is the output file.
        const std::string name = std::string_view(row.name) == "--out" ? "-o,--out" : row.name;
        using Place = decltype(place);
        if constexpr (std::is_same_v<Place, bool*>) {
          return app.add_flag(name, *place, about);
        } else if constexpr (std::is_same_v<Place, double*> ||
                             std::is_same_v<Place, std::optional<double>*>) {
          return app.add_option(name, *place, about)->check(finite_only);
        } else if constexpr (std::is_same_v<Place, std::uint64_t*> ||
                             std::is_same_v<Place, std::optional<std::uint64_t>*>) {
          return app.add_option(name, *place, about)->check(in_64_bits_only);
        } else if constexpr (std::is_same_v<Place, unsigned*>) {
          CLI::Option* const option = app.add_option(name, *place, about);
          return name == "--bit-rate" ? option->transform(kilobits) : option;
        } else {
          return app.add_option(name, *place, about);
        }
      },
      row.place);
}

struct AddCheck {
  CLI::Option& option;

  void operator()(std::monostate /*any*/) const {}
  template <class Number>
  void operator()(const Within<Number>& limits) const {
    option.check(CLI::Range(limits.least, limits.most));
  }
  void operator()(AboveZero /*limit*/) const {
    const std::string name = "POSITIVE";
    option.check(CLI::Validator([](std::string& said) { return counts(said); }, name, name));
  }
  void operator()(const OneOf& words) const {
    option.check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
  }
  void operator()(Check check) const { option.check(check); }
};

void add_rules(CLI::App& app, CLI::Option& option, const Rules& rules) {
  if (rules.is_required) option.required();
  if (rules.takes_one_each) option.expected(1)->take_all()->allow_extra_args(false);
  if (rules.may_be_bare) option.expected(0, 1);
  if (rules.separator != '\0') option.delimiter(rules.separator);
  std::visit(AddCheck{option}, rules.allowed);
  for (const char* other : rules.excludes) {
    if (other != nullptr) option.excludes(app.get_option(other));
  }
  if (rules.needs != nullptr) option.needs(app.get_option(rules.needs));
}

OptionInfo info_of(const CLI::Option& option) {
  OptionInfo info{
      .name = option.get_name(option.get_positional()),
      .about = option.get_description(),
      .is_place = option.get_positional(),
      .is_required = option.get_required(),
      .takes_value = option.get_items_expected_min() > 0,
      .takes_several = option.get_expected_max() > 1,
      .is_flag = option.get_items_expected_max() == 0,
      .said = option.results(),
  };
  for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  return info;
}

// -- errors of a command line

/// CLI11 explains some errors in several lines; the first one states the error.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// The innermost verb that was parsed, and its full name: `canvoy run charger`.
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

/// Words that could replace an unknown word: options, or verbs.
std::vector<std::string> words_known_to(const CLI::App& app, bool is_option) {
  std::vector<std::string> words;
  if (is_option) {
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
    return words;
  }
  for (const CLI::App* verb : app.get_subcommands(nullptr)) {
    if (!verb->get_group().empty()) words.push_back(verb->get_name());
  }
  return words;
}

/// `-f` as the first option that begins so: `--filter`.
std::string meant_by_letter(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t length = 2;
  if (word.size() != length || word[0] != '-') return {};
  const auto found = std::ranges::find_if(
      known, [word](const std::string& option) { return option.substr(2, 1) == word.substr(1); });
  return found == known.end() ? "" : fmt::format("; did you mean '{}'?", *found);
}

/// CLI11 says `--out: 1 required TEXT missing`.
std::string in_plain_words(const std::string& text) {
  const std::size_t count = text.find(": 1 required ");
  if (count == std::string::npos || !text.ends_with(" missing")) return text;
  return text.substr(0, count) + ": its value is missing";
}

/// What others have as an option, and what is done in its place here.
std::string in_its_place(std::string_view option) {
  if (option != "--dbc") return {};
  return "values come from profiles and data sheets, --eds 10=pump.eds; canvoy export dbc writes a "
         "DBC";
}

using Words = std::vector<std::string>;

/// `it is canvoy convert-log IN OUT`
std::string usage_of(const CLI::App& app, const std::string& text) {
  std::string usage = "it is " + text;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    std::string place = option->get_name(true);
    std::ranges::transform(place, place.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    });
    usage += option->get_required() ? ' ' + place : " [" + place + ']';
  }
  return usage;
}

/// Of a line in which all is known: a word or a value is missing, or a value is none.
std::string refusal_of_known(const Understood& verb, const CLI::ParseError& error,
                             const Words& words) {
  const std::string text = in_plain_words(first_line(error.what()));
  std::string line;
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError)) {
    line = completed_line(words, verb.app->get_name(), verb.app->get_footer());
    // A value of the example is none to be sent, and a file of its name may be there.
    if (!line.empty())
      line = is_safe_line(line, words) ? ": " + line : "; " + usage_of(*verb.app, verb.text);
  } else if (text.starts_with("--")) {
    line = example_with(verb.app->get_footer(), text.substr(0, text.find_first_of(": ")));
    if (!line.empty()) line = ", as in " + line;
  }
  return fmt::format("{}{}; see {} --help", text, line, verb.text);
}

/// CLI11 reports missing words before superfluous ones, which are usually the same word misspelled.
std::string refusal(const CLI::App& app, const CLI::ParseError& error, const Words& words) {
  const Words unknown = app.remaining(true);
  const int code = error.get_exit_code();
  const bool is_missing = code == static_cast<int>(CLI::ExitCodes::RequiredError);
  const bool is_unknown =
      !unknown.empty() && (is_missing || code == static_cast<int>(CLI::ExitCodes::ExtrasError));
  const Understood verb = understood(app);
  if (!is_unknown) return refusal_of_known(verb, error, words);
  const std::string word = first_line(unknown.front());
  const std::string name = word.substr(0, word.find('='));
  if (const std::string other = in_its_place(name); !other.empty()) {
    return fmt::format("'{}' is not known here: {}", name, other);
  }
  const Words known = words_known_to(*verb.app, word.starts_with('-'));
  const bool is_known = word.starts_with('-') && std::ranges::find(known, name) != known.end();
  if (is_known && std::ranges::find(words, "--") != words.end()) {
    return fmt::format(
        "'{}' stands after '--', which ends the options; without it: {}; see {} --help", name,
        line_without(words, {"--"}), verb.text);
  }
  std::string meant = meant_by_letter(name, known);
  if (meant.empty()) meant = did_you_mean(name, known);
  if (!meant.empty()) {
    return fmt::format("'{}' is not known here{} See {} --help", word, meant, verb.text);
  }
  const bool is_whole = !is_missing && verb.app != &app;
  if (!is_whole) return fmt::format("'{}' is not known here; see {} --help", word, verb.text);
  // Who writes, and is told to leave a word out, may lose a file by it, or a trial run.
  const std::string line = only_shows(words) ? "without it: " + line_without(words, unknown)
                                             : usage_of(*verb.app, verb.text);
  return fmt::format("'{}' is not known here; {}; see {} --help", word, line, verb.text);
}

/// End of a line of at most `room` characters: after its last blank, or within a long word after
/// its last comma; else after the word.
std::size_t end_of_line(std::string_view text, std::size_t room) {
  if (text.size() <= room) return text.size();
  const std::size_t blank = text.rfind(' ', room);
  if (blank != std::string_view::npos && blank != 0) return blank;
  const std::size_t comma = text.rfind(',', room - 1);
  if (comma != std::string_view::npos) return comma + 1;
  return std::min(text.find(' '), text.size());
}

/// Wraps a line of help; continuation lines begin at its right column. Lines outside of tables
/// begin at the left.
void append_wrapped(std::string& text, std::string_view line, const HelpLayout& layout) {
  const bool is_row = line.starts_with("  ") && line.size() > layout.descriptions;
  const std::size_t indent = is_row ? layout.descriptions : 0;
  text.append(line.substr(0, indent));
  line.remove_prefix(indent);
  while (true) {
    const std::size_t end = end_of_line(line, layout.width - indent);
    text.append(line.substr(0, end)).append(1, '\n');
    line.remove_prefix(end);
    while (line.starts_with(' ') && end != 0) line.remove_prefix(1);
    if (line.empty()) return;
    text.append(indent, ' ');
  }
}

/// The last blank outside of quotes in the first `room` characters, behind the first word; or none.
std::size_t blank_in_command(std::string_view line, std::size_t room) {
  std::size_t found = std::string_view::npos;
  char quote = '\0';
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  for (std::size_t i = begin; i < std::min(line.size(), room); ++i) {
    if (line[i] == quote) {
      quote = '\0';
    } else if (quote == '\0' && (line[i] == '"' || line[i] == '\'')) {
      quote = line[i];
    } else if (quote == '\0' && line[i] == ' ') {
      found = i;
    }
  }
  return found;
}

/// A command in several lines that a shell takes as one.
void append_command(std::string& text, std::string_view line, const HelpLayout& layout) {
  constexpr std::string_view goes_on = " \\\n";
  constexpr std::string_view indent = "      ";
  std::size_t width = layout.width;
  while (line.size() > width) {
    const std::size_t blank = blank_in_command(line, width - goes_on.size() + 2);
    if (blank == std::string_view::npos) break;
    text.append(line.substr(0, blank)).append(goes_on).append(indent);
    line.remove_prefix(blank + 1);
    width = layout.width - indent.size();
  }
  text.append(line).append(1, '\n');
}

std::string wrapped_help(std::string_view help, const HelpLayout& layout) {
  std::string text;
  bool is_example = false;
  while (!help.empty()) {
    const std::size_t end = std::min(help.find('\n'), help.size());
    const std::string_view line = help.substr(0, end);
    is_example = is_example || line == "Examples:";
    if (!is_example) {
      append_wrapped(text, line, layout);
    } else if (layout.is_terminal) {
      append_command(text, line, layout);
    } else {
      text.append(line).append(1, '\n');
    }
    help.remove_prefix(std::min(end + 1, help.size()));
  }
  return text;
}

}  // namespace

Verb::Verb(std::shared_ptr<CLI::App> app, const Verb* parent, std::shared_ptr<Chosen> chosen)
    : app_(std::move(app)), parent_(parent), chosen_(std::move(chosen)) {}

Verb::~Verb() = default;

Verb& Verb::add_verb(const std::string& name, const std::string& about) {
  std::shared_ptr<CLI::App> app = app_->get_subcommand_ptr(app_->add_subcommand(name, about));
  verbs_.push_back(std::unique_ptr<Verb>(new Verb(std::move(app), this, chosen_)));
  return *verbs_.back();
}

void Verb::add(std::initializer_list<OptionRow> rows) {
  for (const OptionRow& row : rows) {
    CLI::Option* const option = add_row(*app_, row);
    add_rules(*app_, *option, row.rules);
    if (!group_.empty() && !option->get_positional()) option->group(group_);
  }
}

void Verb::begin_group(const std::string& title) {
  group_ = title;
}

void Verb::add_taken(const char* name, std::function<void(const std::string&)> take,
                     std::string_view about) {
  app_->add_option_function<std::string>(name, take, std::string(about));
}

void Verb::add_examples(std::string_view examples) {
  app_->footer("Examples:\n" + std::string(examples));
}

void Verb::set_footer(const std::string& text) {
  app_->footer(text);
}

void Verb::hide() {
  app_->group("");
}

void Verb::require_verb() {
  app_->require_subcommand(1);
}

void Verb::allow_verb() {
  app_->require_subcommand(0, 1);
}

void Verb::keep_options_apart() {
  app_->fallthrough(false);
}

void Verb::when_parsed(std::function<void()> then) {
  when_parsed_ = std::move(then);
}

void Verb::runs(Action action) {
  app_->callback([this, action = std::move(action)] {
    if (app_->get_subcommands().empty()) {
      *chosen_ = {action, when_parsed_};
    } else {
      refuse_places_beside_verb();
    }
  });
}

/// A word of this verb that stands beside one of its verbs would be taken and ignored.
void Verb::refuse_places_beside_verb() const {
  const auto given = app_->get_options(
      [](const CLI::Option* option) { return option->get_positional() && option->count() != 0; });
  if (given.empty()) return;
  const std::string word = given.front()->results().front();
  const std::string verb = app_->get_subcommands().front()->get_name();
  chosen_->action = [word, verb, name = name()]() -> int {
    throw UsageError(fmt::format("'{}' and '{}' exclude each other: canvoy {} {}, or canvoy {} {}",
                                 verb, word, name, word, name, verb));
  };
  chosen_->when_parsed = [] {};
}

std::string Verb::name() const {
  return app_->get_name();
}

std::string Verb::about() const {
  return app_->get_description();
}

std::string Verb::footer() const {
  return app_->get_footer();
}

bool Verb::is_hidden() const {
  return app_->get_group().empty();
}

std::vector<OptionInfo> Verb::options() const {
  std::vector<OptionInfo> infos;
  for (const CLI::Option* option : std::as_const(*app_).get_options()) {
    infos.push_back(info_of(*option));
  }
  return infos;
}

std::size_t Verb::count(const char* option) const {
  const CLI::Option* found = std::as_const(*app_).get_option_no_throw(option);
  return found == nullptr ? 0 : found->count();
}

CommandLine::CommandLine(const std::string& about, const std::string& name)
    : Verb(std::make_shared<CLI::App>(about, name), nullptr, std::make_shared<Chosen>()) {}

void CommandLine::set_version(const char* name, const std::string& version) {
  app_->set_version_flag(name, version);
}

void CommandLine::take_options_anywhere() {
  app_->fallthrough();
}

CommandLine::Outcome CommandLine::parse(std::vector<std::string> words, std::size_t columns) {
  const HelpLayout layout = layout_for(columns);
  const std::vector<std::string> typed = words;
  app_->get_formatter()->column_width(layout.descriptions);
  try {
    std::ranges::reverse(words);  // in the order that CLI11 expects
    app_->parse(std::move(words));
    chosen_->when_parsed();
    return {Outcome::Kind::understood};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return {Outcome::Kind::refused, refusal(*app_, error, typed)};
    std::ostringstream help;
    app_->exit(error, help);
    return {Outcome::Kind::answered, wrapped_help(help.str(), layout)};
  }
}

}  // namespace canvoy::tools
