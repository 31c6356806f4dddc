// The command line: verbs and their arguments. Help, man page and completion are made from the rows
// that describe options.
//
//     CommandLine line("Canvoy: see, simulate, test and drive CANopen networks", "canvoy");
//     Verb& command = line.add_verb("decode", "Show what the frames of a log mean");
//     command.add({
//         {"log", options->log, log_argument_text, required},
//         {"--count", options->count, "end after as many frames", above_zero},
//         {"--json", options->json, "one JSON object a line"},
//     });
//     command.add_examples("  canvoy decode bus.log");
//     command.runs([=] { return decode(*options); });
//     if (line.parse(words).kind == CommandLine::Outcome::Kind::understood) return line.run();
//
// CLI11 is used in one source file only, so that including this header is cheap to compile.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

/// Action of the chosen verb; returns the exit status.
using Action = std::function<int()>;

/// Target of the value of an option. Its type defines the option: a bool is a flag, a vector takes
/// several words.
using Place =
    std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*,
                 std::uint16_t*, unsigned*, std::uint64_t*, std::optional<unsigned>*,
                 std::optional<std::uint64_t>*, double*, std::optional<double>*>;

/// A range, inclusive.
template <class Number>
struct Within {
  Number least;
  Number most;
};
struct AboveZero {};
using OneOf = std::array<const char*, 3>;
/// Checks a value: returns the error, or an empty text.
using Check = std::string (*)(const std::string& said);

/// Rules for an option beyond its type. Other options are named, and must already exist.
struct Rules {
  bool is_required = false;
  bool takes_one_each = false;  ///< of several words: `--node 5 --node 7`, not `--node 5 7`
  bool may_be_bare = false;     ///< `--web` alone
  char separator = '\0';        ///< of several values in one word
  std::variant<std::monostate, Within<unsigned>, Within<double>, AboveZero, OneOf, Check> allowed =
      {};
  std::array<const char*, 3> excludes = {};
  const char* needs = nullptr;
};

// The only rule of most options.
inline constexpr Rules required{.is_required = true};
inline constexpr Rules one_each{.takes_one_each = true};
inline constexpr Rules may_be_bare{.may_be_bare = true};
inline constexpr Rules above_zero{.allowed = AboveZero{}};
constexpr Rules between(unsigned least, unsigned most) {
  return {.allowed = Within<unsigned>{least, most}};
}
constexpr Rules between(double least, double most) {
  return {.allowed = Within<double>{least, most}};
}
constexpr Rules checked_by(Check check) {
  return {.allowed = check};
}
constexpr Rules separated_by(char separator) {
  return {.separator = separator};
}
template <class... Names>
constexpr Rules excludes(const Names*... names) {
  return {.excludes = {names...}};
}

/// An option, or an argument by position if its name has no dashes.
struct OptionRow {
  const char* name;  ///< `--json`; `--colour,--color`; `bus`
  Place place;       ///< must outlive the parsing
  std::string_view about;
  Rules rules = {};

  template <class Value>
  OptionRow(const char* named, Value& value, std::string_view text, Rules ruled = {})
      : name(named), place(&value), about(text), rules(ruled) {}
};

/// An option as seen by help, man page and completion, with its value.
struct OptionInfo {
  std::string name = {};                ///< `--json`; `bus`
  std::vector<std::string> names = {};  ///< all names with two dashes
  std::string about = {};
  bool is_place = false;
  bool is_required = false;
  bool takes_value = false;  ///< a value is required
  bool takes_several = false;
  bool is_flag = false;
  std::vector<std::string> said = {};
};

class Verb {
 public:
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;
  ~Verb();

  // -- description

  /// Adds a verb below this one. It lives as long as this.
  Verb& add_verb(const std::string& name, const std::string& about);
  void add(std::initializer_list<OptionRow> rows);
  /// Starts a group of options with this title in the help.
  void begin_group(const std::string& title);
  /// Adds an option with a value that is passed to `take`, which may throw Failure.
  void add_taken(const char* name, std::function<void(const std::string&)> take,
                 std::string_view about);
  /// Adds examples below the options, one per line. tests/cli/help_test.py runs them all.
  void add_examples(std::string_view examples);
  /// Sets the text below the options; examples are at its end, after a line `Examples:`.
  void set_footer(const std::string& text);
  /// Hides the verb from the help of the verb above.
  void hide();
  /// Requires or allows one of the verbs below.
  void require_verb();
  void allow_verb();
  /// Does not accept options of the verbs above after this verb.
  void keep_options_apart();
  /// Sets the function called when all words of the line were parsed, for the chosen verb.
  void when_parsed(std::function<void()> then);
  /// Sets the action if no verb below was chosen.
  void runs(Action action);

  // -- properties

  std::string name() const;
  std::string about() const;
  std::string footer() const;
  bool is_hidden() const;
  const Verb* parent() const { return parent_; }
  std::span<const std::unique_ptr<Verb>> verbs() const { return verbs_; }
  std::vector<OptionInfo> options() const;

  // -- parsed values

  /// Number of occurrences of an option; 0 if the option does not exist.
  std::size_t count(const char* option) const;

 private:
  friend class CommandLine;

  /// What the words have chosen.
  struct Chosen {
    Action action = {};
    std::function<void()> when_parsed = [] {};
  };
  /// `chosen` is that of the command line, shared by all of its verbs.
  Verb(std::shared_ptr<CLI::App> app, const Verb* parent, std::shared_ptr<Chosen> chosen);

  void refuse_places_beside_verb() const;

  std::shared_ptr<CLI::App> app_;
  const Verb* parent_;
  std::shared_ptr<Chosen> chosen_;
  std::function<void()> when_parsed_ = [] {};
  std::vector<std::unique_ptr<Verb>> verbs_ = {};
  std::string group_ = {};
};

/// The first word, and all words after it.
class CommandLine : public Verb {
 public:
  CommandLine(const std::string& about, const std::string& name);

  /// Sets the output of the option `name`.
  void set_version(const char* name, const std::string& version);
  /// Accepts options of the command line after verbs as well; applies to options added afterwards.
  void take_options_anywhere();

  struct Outcome {
    enum class Kind : std::uint8_t {
      understood,
      answered,  ///< help or version was printed
      refused,
    };
    Kind kind;
    std::string text = {};  ///< the help; or in one line the error, a suggestion, and where help is
  };
  /// Parses the words after the program name. Help has lines of at most `columns` characters, and
  /// of 100; 0: no terminal, whose lines of examples stay whole. Throws what the functions of
  /// add_taken() and when_parsed() throw.
  Outcome parse(std::vector<std::string> words, std::size_t columns = 0);

  /// Runs the action of the chosen verb, which must exist.
  int run() const { return chosen_->action(); }
};

}  // namespace canvoy::tools
