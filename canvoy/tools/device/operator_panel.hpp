// The seat of an operator environment that `canvoy device operator` runs: what is moved and pressed
// there, as the command line says, and what is seen of indicators and displays.
//
//     OperatorPanel panel({.moves = {"joystick1.x=12000@2s"}}, site, output);
//     panel.step(now);   // often
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/device_output.hpp"
#include "canvoy/tools/device/hands.hpp"
#include "canvoy/tools/device/program_store.hpp"
#include "canvoy/tools/device/seat_state.hpp"

namespace canvoy::tools {

struct OperatorPanelOptions {
  std::string elements{};            ///< as operator_elements.hpp has them
  std::vector<std::string> moves{};  ///< `joystick1.x=12000@2s`
  std::vector<std::string> hands{};  ///< `/dev/input/event5`, or a file as hand_mapping.hpp has it
  std::string program_store{};       ///< a file for the program that the network downloads
};

void add_operator_panel_options(Verb& command, OperatorPanelOptions& options);

class OperatorPanel {
 public:
  /// `output` must outlive this, and this the devices at `site`. Throws UsageError for what makes
  /// no sense.
  OperatorPanel(const OperatorPanelOptions& options, Site& site, const DeviceOutput& output);
  OperatorPanel(const OperatorPanel&) = delete;
  OperatorPanel& operator=(const OperatorPanel&) = delete;

  /// What is moved, to where and when: `joystick1.x=12000@2s`. Throws UsageError.
  void take(const std::string& move);
  /// Times count from the first call.
  void step(Time now);
  /// Real hands are served by each step too, and are to be when this descriptor is readable; -1:
  /// there are none.
  int hands_descriptor() const { return hands_ ? hands_->descriptor() : -1; }
  void serve_hands(Time now);
  /// The file of the program; null: there is none.
  ProgramStore* program_store() { return program_store_.get(); }

 private:
  struct Move {
    Duration at{};
    Control control;
    std::int64_t value = 0;
  };
  Move parse_move(const std::string& text) const;
  cia852::OperatorEnvironment elements() { return elements_; }
  cia852::OperatorHardware hardware();
  ProgramPlace program_place() { return program_store_->place(); }
  void take_programs(const std::string& path, Site& site);
  void is_made(cia852::OperatorUnit& unit, Node& node);
  void hands_moved();
  void hand_lost(unsigned device, bool is_lost);
  void show_indicators(unsigned cluster, unsigned group, std::uint8_t lit);
  void show_parameter(unsigned display, unsigned parameter, std::int16_t value);

  const DeviceOutput& output_;
  cia852::OperatorEnvironment elements_;
  std::vector<Move> moves_;
  std::size_t done_ = 0;
  std::optional<Time> begin_;
  SeatState seat_;
  std::unique_ptr<Hands> hands_;
  std::unique_ptr<ProgramStore> program_store_;
  cia852::OperatorUnit* unit_ = nullptr;
  Node* node_ = nullptr;
  Time now_{};  ///< of the call that is under way
  std::array<std::uint8_t, std::size_t{cia852::indicator_clusters_max} * cia852::groups_of_cluster>
      lit_{};
  std::array<std::int16_t, std::size_t{cia852::displays_max} * cia852::parameters_of_display>
      shown_{};
};

}  // namespace canvoy::tools
