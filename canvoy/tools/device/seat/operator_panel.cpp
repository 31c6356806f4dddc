#include "canvoy/tools/device/seat/operator_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/catalogue/operator_elements.hpp"
#include "canvoy/tools/device/seat/seat_hands.hpp"

namespace canvoy::tools {

namespace {

/// A generic additional modules error (CiA 852, Table 37).
constexpr std::uint16_t additional_module_code = 0x7000;
constexpr std::string_view operator_name = "operator";

}  // namespace

void add_operator_panel_options(Verb& command, OperatorPanelOptions& options) {
  command.add({
      {"--elements", options.elements, operator_elements_help},
      {"--move", options.moves,
       "what is moved or pressed of an operator environment, and when: "
       "joystick1.x=12000@2s, joystick1.b3=1@2s, joystick1.hold-x=1@2s, foot-pedal1=, "
       "foot-pedal1.hold=, encoder1=, wheel1=, push-button-cluster1.b13=1@3s",
       one_each},
      {"--program-store", options.program_store,
       "keep the program that the network downloads to an operator environment "
       "(1F50h) in this file"},
      {"--joystick", options.hands,
       "an input device of Linux, as /dev/input/event5, that is the next joystick of an "
       "operator environment; or a file .toml that says what it moves",
       one_each},
  });
}

OperatorPanel::OperatorPanel(const OperatorPanelOptions& options, Environment& environment,
                             const DeviceOutput& output)
    : output_(output),
      elements_(parse_operator_elements(options.elements)),
      seat_hands_(seat_hands(elements_)),
      orders_({{operator_name, seat_hands_}}) {
  const HandTable table = {operator_name, seat_hands_};
  check_hand_options({&table, 1}, {}, options.moves, "--move");
  for (const std::string& move : options.moves) take(move);
  environment.provide(callback<&OperatorPanel::elements>(*this));
  environment.provide(callback<&OperatorPanel::hardware>(*this));
  take_programs(options.program_store, environment);
  if (options.hands.empty()) return;
  hands_ = std::make_unique<Hands>(options.hands, elements_, seat_, output);
  hands_->on_change(callback<&OperatorPanel::hands_moved>(*this));
  hands_->on_loss(callback<&OperatorPanel::hand_lost>(*this));
  environment.watch(callback<&OperatorPanel::is_made>(*this));
}

/// A program store requires the objects.
void OperatorPanel::take_programs(const std::string& path, Environment& environment) {
  if (path.empty()) {
    if (!elements_.program_download) return;
    throw UsageError("--elements: program-download=yes: give a file by --program-store");
  }
  elements_.program_download = true;
  program_store_ = std::make_unique<ProgramStore>(
      path, [this](const std::string& text) { output_.say(operator_name, text); });
  environment.provide(callback<&OperatorPanel::program_place>(*this));
}

void OperatorPanel::is_made(cia852::OperatorUnit& unit, Node& node) {
  unit_ = &unit;
  node_ = &node;
}

void OperatorPanel::step(Node& node, Time now) {
  orders_.step(node, now, [this](const HandOrder& order) {
    order.hand->act({.unit = &seat_, .number = order.number}, order.value);
  });
  serve_hands(now);
}

void OperatorPanel::serve_hands(Time now) {
  now_ = now;
  if (hands_ && node_ != nullptr) hands_->serve(now);
}

void OperatorPanel::hands_moved() {
  unit_->hardware_changed();
  node_->advance(now_);
}

void OperatorPanel::hand_lost(unsigned device, bool is_lost) {
  node_->report({.code = additional_module_code, .instance = static_cast<std::uint16_t>(device)},
                is_lost);
}

cia852::OperatorHardware OperatorPanel::hardware() {
  cia852::OperatorHardware made = seat_.inputs();
  made.show_indicators = callback<&OperatorPanel::show_indicators>(*this);
  made.show_parameter = callback<&OperatorPanel::show_parameter>(*this);
  return made;
}

void OperatorPanel::show_indicators(unsigned cluster, unsigned group, std::uint8_t lit) {
  std::uint8_t& before = lit_[cia852::indicators_sub(cluster, group) - 1];
  const unsigned changed = lit ^ unsigned { before };
  before = lit;
  for (unsigned i = 0; i < switches_of_group; ++i) {
    if ((changed >> i & 1) == 0) continue;
    output_.say(operator_name, fmt::format("indicator {} of cluster {} {}",
                                           (group - 1) * switches_of_group + i + 1, cluster,
                                           (lit >> i & 1) != 0 ? "on" : "off"));
    if (hands_) hands_->show(cluster, (group - 1) * switches_of_group + i + 1, (lit >> i & 1) != 0);
  }
}

void OperatorPanel::show_parameter(unsigned display, unsigned parameter, std::int16_t value) {
  std::int16_t& before = shown_[cia852::display_sub(display, parameter) - 1];
  if (before == value) return;
  before = value;
  output_.say(operator_name, fmt::format("display {} parameter {}: {}", display, parameter, value));
}

}  // namespace canvoy::tools
