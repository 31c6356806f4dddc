#include "canvoy/tools/device/operator_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <utility>

#include "canvoy/tools/device/operator_elements.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

/// A generic additional modules error (CiA 852, Table 37).
constexpr std::uint16_t additional_module_code = 0x7000;

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

OperatorPanel::OperatorPanel(const OperatorPanelOptions& options, Site& site,
                             const DeviceOutput& output)
    : output_(output), elements_(parse_operator_elements(options.elements)) {
  for (const std::string& text : options.moves) moves_.push_back(parse_move(text));
  std::ranges::stable_sort(moves_, {}, &Move::at);
  site.offer(Callback<cia852::OperatorEnvironment()>::to<&OperatorPanel::elements>(*this));
  site.offer(Callback<cia852::OperatorHardware()>::to<&OperatorPanel::hardware>(*this));
  take_programs(options.program_store, site);
  if (options.hands.empty()) return;
  hands_ = std::make_unique<Hands>(options.hands, elements_, seat_, output);
  hands_->on_change(Callback<void()>::to<&OperatorPanel::hands_moved>(*this));
  hands_->on_loss(Callback<void(unsigned, bool)>::to<&OperatorPanel::hand_lost>(*this));
  site.watch(Callback<void(cia852::OperatorUnit&, Node&)>::to<&OperatorPanel::is_made>(*this));
}

/// Who gives a file wants the objects.
void OperatorPanel::take_programs(const std::string& path, Site& site) {
  if (path.empty()) {
    if (!elements_.program_download) return;
    throw UsageError("--elements: program-download=yes: give a file by --program-store");
  }
  elements_.program_download = true;
  program_store_ = std::make_unique<ProgramStore>(
      path, [this](const std::string& text) { output_.say("operator", text); });
  site.offer(Callback<ProgramPlace()>::to<&OperatorPanel::program_place>(*this));
}

void OperatorPanel::is_made(cia852::OperatorUnit& unit, Node& node) {
  unit_ = &unit;
  node_ = &node;
}

OperatorPanel::Move OperatorPanel::parse_move(const std::string& text) const {
  const std::size_t equals = text.find('=');
  const std::size_t at = text.find('@');
  Move move;
  const char* const first = text.data() + std::min(equals, text.size() - 1) + 1;
  const char* const end = text.data() + std::min(at, text.size());
  const bool has_both = equals != std::string::npos && at != std::string::npos && equals < at;
  const auto [stop, error] = std::from_chars(first, std::max(first, end), move.value);
  if (!has_both || error != std::errc{} || stop != end) {
    throw UsageError(fmt::format(
        "--move: '{}' is nothing with a value and a time: write joystick1.x=12000@2s", text));
  }
  move.control = parse_control(text.substr(0, equals), elements_);
  move.at = parse_moment_argument(text.substr(at + 1));
  return move;
}

void OperatorPanel::take(const std::string& text) {
  const Move move = parse_move(text);
  moves_.erase(moves_.begin(),
               moves_.begin() + static_cast<std::ptrdiff_t>(std::exchange(done_, 0)));
  moves_.insert(std::ranges::upper_bound(moves_, move.at, {}, &Move::at), move);
}

void OperatorPanel::step(Time now) {
  if (!begin_) begin_ = now;
  for (; done_ < moves_.size() && now - *begin_ >= moves_[done_].at; ++done_) {
    seat_.set(moves_[done_].control, moves_[done_].value);
  }
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
  made.show_indicators =
      Callback<void(unsigned, unsigned, std::uint8_t)>::to<&OperatorPanel::show_indicators>(*this);
  made.show_parameter =
      Callback<void(unsigned, unsigned, std::int16_t)>::to<&OperatorPanel::show_parameter>(*this);
  return made;
}

void OperatorPanel::show_indicators(unsigned cluster, unsigned group, std::uint8_t lit) {
  std::uint8_t& before = lit_[cia852::indicators_sub(cluster, group) - 1];
  const unsigned changed = lit ^ unsigned { before };
  before = lit;
  for (unsigned i = 0; i < switches_of_group; ++i) {
    if ((changed >> i & 1) == 0) continue;
    output_.say("operator", fmt::format("indicator {} of cluster {} {}",
                                        (group - 1) * switches_of_group + i + 1, cluster,
                                        (lit >> i & 1) != 0 ? "on" : "off"));
    if (hands_) hands_->show(cluster, (group - 1) * switches_of_group + i + 1, (lit >> i & 1) != 0);
  }
}

void OperatorPanel::show_parameter(unsigned display, unsigned parameter, std::int16_t value) {
  std::int16_t& before = shown_[cia852::display_sub(display, parameter) - 1];
  if (before == value) return;
  before = value;
  output_.say("operator", fmt::format("display {} parameter {}: {}", display, parameter, value));
}

}  // namespace canvoy::tools
