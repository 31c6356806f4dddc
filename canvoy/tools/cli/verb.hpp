// The command line: verbs, and what may stand behind each. Help, man page and completion follow
// from the rows that describe an option.
//
//     CommandLine line("Canvoy: see, simulate, test and drive CANopen networks", "canvoy");
//     Verb& command = line.add_verb("decode", "Show what the frames of a log mean");
//     command.add({
//         {"log", options->log, log_argument_text, required},
//         {"--count", options->count, "end after as many frames", above_zero},
//         {"--json", options->json, "one JSON object a line"},
//     });
//     command.add_examples("  canvoy decode bus.log");
//     command.runs([options] { return decode(*options); });
//     if (line.parse(words).kind == CommandLine::Outcome::Kind::understood) return line.run();
//
// It is CLI11 behind one source: who includes this waits for none of it.
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

/// What a verb does when it was chosen; it returns the exit status.
using Action = std::function<int()>;

/// Where an option writes what was said. By its type: a bool is a flag, and of a vector the option
/// takes several words.
using Place =
    std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*,
                 std::uint16_t*, unsigned*, std::uint64_t*, std::optional<unsigned>*,
                 std::optional<std::uint64_t>*, double*, std::optional<double>*>;

/// Both ends are allowed.
template <class Number>
struct Within {
  Number least;
  Number most;
};
struct AboveZero {};
using OneOf = std::array<const char*, 3>;
/// What is wrong with what was said, or nothing.
using Check = std::string (*)(const std::string& said);

/// What holds for an option beyond its type. Other options are those that the verb has by then, by
/// name.
struct Rules {
  bool is_required = false;
  bool takes_one_each = false;  ///< of several words: `--node 5 --node 7`, not `--node 5 7`
  bool may_be_bare = false;     ///< `--web` alone
  char separator = '\0';        ///< of several words in one
  std::variant<std::monostate, Within<unsigned>, Within<double>, AboveZero, OneOf, Check> allowed =
      {};
  std::array<const char*, 3> excludes = {};
  const char* needs = nullptr;
};

// Most options have but one of them.
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

/// One option, or, where its name has no dashes, what stands at a place behind the verb.
struct OptionRow {
  const char* name;  ///< `--json`; `--colour,--color`; `bus`
  Place place;       ///< must outlive the parsing
  std::string_view about;
  Rules rules = {};

  template <class Value>
  OptionRow(const char* named, Value& value, std::string_view text, Rules ruled = {})
      : name(named), place(&value), about(text), rules(ruled) {}
};

/// An option as help, man page and completion see it, and what was said.
struct OptionInfo {
  std::string name = {};                ///< `--json`; `bus`
  std::vector<std::string> names = {};  ///< all of those with two dashes
  std::string about = {};
  bool is_place = false;
  bool is_required = false;
  bool takes_value = false;  ///< it needs one
  bool takes_several = false;
  bool is_flag = false;
  std::vector<std::string> said = {};
};

class Verb {
 public:
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;
  ~Verb();

  // -- describing it

  /// A verb behind this one. It lives as long as this.
  Verb& add_verb(const std::string& name, const std::string& about);
  void add(std::initializer_list<OptionRow> rows);
  /// Options that are added from then on stand below this line of the help.
  void begin_group(const std::string& title);
  /// An option with a value that `take` is called with. It may throw Failure.
  void add_taken(const char* name, std::function<void(const std::string&)> take,
                 std::string_view about);
  /// Of each example a line, below the options. tests/cli/help_test.py runs them all.
  void add_examples(std::string_view examples);
  /// What stands below the options; examples are its end, behind a line `Examples:`.
  void set_footer(const std::string& text);
  /// Not in the help of the verb above.
  void hide();
  /// One of the verbs behind it has to follow, or may.
  void require_verb();
  void allow_verb();
  /// Options of the verbs above are not taken behind it.
  void keep_options_apart();
  /// Called when all behind the verb was understood.
  void when_parsed(std::function<void()> then);
  /// What it does where no verb behind it was chosen.
  void runs(Action action);

  // -- what was described

  std::string name() const;
  std::string about() const;
  std::string footer() const;
  bool is_hidden() const;
  const Verb* parent() const { return parent_; }
  std::span<const std::unique_ptr<Verb>> verbs() const { return verbs_; }
  std::vector<OptionInfo> options() const;

  // -- what was said

  /// How often; 0 as well where there is no such option.
  std::size_t count(const char* option) const;

 private:
  friend class CommandLine;

  /// `chosen` is what the command line does, and shared by all of its verbs.
  Verb(std::shared_ptr<CLI::App> app, const Verb* parent, std::shared_ptr<Action> chosen);

  std::shared_ptr<CLI::App> app_;
  const Verb* parent_;
  std::shared_ptr<Action> chosen_;
  std::vector<std::unique_ptr<Verb>> verbs_ = {};
  std::string group_ = {};
};

/// The first word, and all behind it.
class CommandLine : public Verb {
 public:
  CommandLine(const std::string& about, const std::string& name);

  /// What `name` prints.
  void set_version(const char* name, const std::string& version);
  /// Options of its own are taken behind verbs as well; of those that are added from then on.
  void take_options_anywhere();

  struct Outcome {
    enum class Kind : std::uint8_t {
      understood,
      answered,  ///< help or version were asked for
      refused,
    };
    Kind kind;
    std::string text = {};  ///< the help; or in one line what is wrong, meant, and where help is
  };
  /// Of the words behind the name. Throws what add_taken()'s and when_parsed()'s functions do.
  Outcome parse(std::vector<std::string> words);

  /// What the chosen verb does. There has to be one.
  int run() const { return (*chosen_)(); }
};

}  // namespace canvoy::tools
