// The seat of an operator environment that `canvoy device operator` runs: moves and presses from
// the command line, and reports of indicators and displays.
//
//     OperatorPanel panel({.moves = {"joystick1.x=12000@2s"}}, environment, output);
//     panel.step(node, now);   // often
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/hand/hand_order.hpp"
#include "canvoy/tools/device/seat/hands.hpp"
#include "canvoy/tools/device/seat/seat_state.hpp"
#include "canvoy/tools/device/store/program_store.hpp"

namespace canvoy::tools {

struct OperatorPanelOptions {
  std::string elements{};            ///< in the form of operator_elements.hpp
  std::vector<std::string> moves{};  ///< `joystick1.x=12000@2s`
  std::vector<std::string> hands{};  ///< `/dev/input/event5`, or a file (hand_mapping.hpp)
  std::string program_store{};       ///< file for the program that the network downloads
};

void add_operator_panel_options(Verb& command, OperatorPanelOptions& options);

class OperatorPanel {
 public:
  /// `output` must outlive this, and this must outlive the devices at `environment`. Throws
  /// UsageError for invalid options.
  OperatorPanel(const OperatorPanelOptions& options, Environment& environment,
                const DeviceOutput& output);
  OperatorPanel(const OperatorPanel&) = delete;
  OperatorPanel& operator=(const OperatorPanel&) = delete;

  /// Adds a move or press with its time: `joystick1.x=12000@2s`, `joystick1.b3@2s`. Throws
  /// UsageError if the elements do not have it.
  void take(std::string_view order) { orders_.take(order); }
  /// True if the elements have a hand of this name.
  bool has(std::string_view order) const { return orders_.has(order); }
  /// Performs what is due. Times count from the first call.
  void step(Node& node, Time now);
  /// Descriptor of the real hands: step() is to be called when it is readable; -1: none.
  int hands_descriptor() const { return hands_ ? hands_->descriptor() : -1; }
  void serve_hands(Time now);
  /// The file of the program; null: none.
  ProgramStore* program_store() { return program_store_.get(); }

 private:
  cia852::OperatorEnvironment elements() { return elements_; }
  cia852::OperatorHardware hardware();
  ProgramPlace program_place() { return program_store_->place(); }
  void take_programs(const std::string& path, Environment& environment);
  void is_made(cia852::OperatorUnit& unit, Node& node);
  void hands_moved();
  void hand_lost(unsigned device, bool is_lost);
  void show_indicators(unsigned cluster, unsigned group, std::uint8_t lit);
  void show_parameter(unsigned display, unsigned parameter, std::int16_t value);

  const DeviceOutput& output_;
  cia852::OperatorEnvironment elements_;
  std::vector<DeviceHand> seat_hands_;
  HandOrders orders_;
  SeatState seat_;
  std::unique_ptr<Hands> hands_;
  std::unique_ptr<ProgramStore> program_store_;
  cia852::OperatorUnit* unit_ = nullptr;
  Node* node_ = nullptr;
  Time now_{};  ///< time of the current call
  std::array<std::uint8_t, std::size_t{cia852::indicator_clusters_max} * cia852::groups_of_cluster>
      lit_{};
  std::array<std::int16_t, std::size_t{cia852::displays_max} * cia852::parameters_of_display>
      shown_{};
};

}  // namespace canvoy::tools
