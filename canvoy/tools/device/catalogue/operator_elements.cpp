#include "canvoy/tools/device/catalogue/operator_elements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <vector>

#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/toml_file.hpp"

namespace canvoy::tools {

namespace {

using cia852::OperatorEnvironment;

struct Count {
  std::string_view name;
  unsigned OperatorEnvironment::*number;
  unsigned least;
  unsigned most;
};
/// 9.1.
constexpr Count counts[] = {
    {"joysticks", &OperatorEnvironment::joysticks, 0, cia852::joysticks_max},
    {"foot-pedals", &OperatorEnvironment::foot_pedals, 0, cia852::foot_pedals_max},
    {"encoders", &OperatorEnvironment::encoders, 0, cia852::encoders_max},
    {"wheels", &OperatorEnvironment::wheels, 0, cia852::wheels_max},
    {"push-button-clusters", &OperatorEnvironment::push_button_clusters, 0,
     cia852::push_button_clusters_max},
    {"indicator-clusters", &OperatorEnvironment::indicator_clusters, 0,
     cia852::indicator_clusters_max},
    {"displays", &OperatorEnvironment::displays, 0, cia852::displays_max},
    {"display-parameters", &OperatorEnvironment::display_parameters, 1,
     cia852::parameters_of_display},
};
struct Choice {
  std::string_view name;
  bool OperatorEnvironment::*is_chosen;
};
constexpr Choice choices[] = {
    {"joystick-buttons", &OperatorEnvironment::joystick_inputs},
    {"display-floats", &OperatorEnvironment::display_floats},
    {"program-download", &OperatorEnvironment::program_download},
    {"configuration", &OperatorEnvironment::configuration},
};

std::string known_words() {
  std::vector<std::string_view> words;
  for (const Count& count : counts) words.push_back(count.name);
  for (const Choice& choice : choices) words.push_back(choice.name);
  return fmt::format("{}", fmt::join(words, ", "));
}

unsigned parse_count(const Count& count, std::string_view text) {
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool is_number = error == std::errc{} && stop == end;
  if (is_number && number >= count.least && number <= count.most) return number;
  throw UsageError(
      fmt::format("--elements: {}={}: {} to {}", count.name, text, count.least, count.most));
}

bool parse_choice(const Choice& choice, std::string_view text) {
  if (text == "yes" || text == "no") return text == "yes";
  throw UsageError(fmt::format("--elements: {}={}: yes or no", choice.name, text));
}

void take_word(OperatorEnvironment& elements, std::string_view word) {
  const std::size_t equals = word.find('=');
  const std::string_view name = word.substr(0, equals);
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view() : word.substr(equals + 1);
  for (const Count& count : counts) {
    if (count.name == name) elements.*count.number = parse_count(count, value);
  }
  for (const Choice& choice : choices) {
    if (choice.name == name) elements.*choice.is_chosen = parse_choice(choice, value);
  }
  const auto is_it = [name](const auto& known) { return known.name == name; };
  if (std::ranges::none_of(counts, is_it) && std::ranges::none_of(choices, is_it)) {
    throw UsageError(fmt::format("--elements: '{}' is none of {}", name, known_words()));
  }
}

OperatorEnvironment read_elements(const std::string& path) {
  OperatorEnvironment elements;
  TomlFile file(path);
  for (const Count& count : counts) {
    file.table().take(count.name, elements.*count.number, {count.least, count.most});
  }
  for (const Choice& choice : choices) file.table().take(choice.name, elements.*choice.is_chosen);
  file.table().finish();
  return elements;
}

/// A device without elements has nothing to send.
void check(const OperatorEnvironment& elements) {
  const bool has_any = cia852::has_8_bit_inputs(elements) || elements.encoders > 0 ||
                       elements.wheels > 0 || cia852::has_outputs(elements);
  if (!has_any) throw UsageError("--elements: give one at least, as joysticks=1");
}

}  // namespace

const char* const operator_elements_help =
    "of an operator environment: joysticks=2,foot-pedals=2,encoders=1,wheels=2,"
    "push-button-clusters=1,indicator-clusters=1,displays=1,display-parameters=12,"
    "joystick-buttons=yes,configuration=yes (objects of CiA 401), or a file .toml with these words "
    "(default: those); display-floats=yes and program-download=yes as well";

OperatorEnvironment parse_operator_elements(const std::string& text) {
  if (text.empty()) return cia852::usual_elements;
  OperatorEnvironment elements;
  if (text.ends_with(".toml")) {
    elements = read_elements(text);
  } else {
    for (std::string_view rest = text; !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      take_word(elements, word);
    }
  }
  check(elements);
  return elements;
}

}  // namespace canvoy::tools
