// The on-board computer of a bus and the identification device by which the driver tells it what he
// drives: what both find in the vehicle, and what hands do with them.
//
//     OnBoardComputer computer(nodes, options, vehicle, clock);
//     computer.log_in(assignment);
//     computer.press_stop_button();
#pragma once

#include <optional>

#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/sim/bus/bus_nodes.hpp"
#include "canvoy/sim/bus/line_control.hpp"
#include "canvoy/sim/bus/true_clock.hpp"

namespace canvoy::bus {

class OnBoardComputer {
 public:
  /// All must outlive this.
  OnBoardComputer(BusNodes& nodes, const BusNetworkOptions& options, const BusVehicle& vehicle,
                  const TrueClock& clock)
      : nodes_(nodes), options_(options), vehicle_(vehicle), clock_(clock) {}
  OnBoardComputer(const OnBoardComputer&) = delete;
  OnBoardComputer& operator=(const OnBoardComputer&) = delete;

  /// Puts both on the bus.
  void add_nodes();

  /// The driver types what he drives. False: identification has no power.
  bool log_in(const cia407::Assignment& assignment);
  /// The button of the first car is wired to it. False: it is not in service.
  bool press_stop_button();
  /// Its own clock is an hour ahead.
  void mistake_clock(bool is_wrong) { clock_is_wrong_ = is_wrong; }
  bool has_wrong_clock() const { return clock_is_wrong_; }

  /// So many are aboard, by what it has heard.
  unsigned counted() const;
  /// What it hears of a real vehicle gateway; nothing: that is played, or says nothing.
  std::optional<RealMotion> heard_motion();

 private:
  cia407::MainOnBoardComputerHardware hardware();
  cia407::MainOnBoardComputerSettings settings();
  void is_unit(cia407::MainOnBoardComputerUnit& unit, Node& /*node*/) { unit_ = &unit; }
  LineControlHardware line_control_hardware();
  LineControlSettings line_control_settings();
  void is_line_control(LineControl& control, Node& /*node*/) { line_control_ = &control; }
  double pulses_as_metres();
  bool has_open_door() { return !vehicle_.all_doors_closed(); }
  std::optional<cia407::CivilTime> own_clock();
  std::optional<cia407::CivilTime> told_clock();
  cia407::IdentificationHardware identification_hardware();
  cia407::Assignment remembered() { return remembered_; }
  void is_identification(cia407::IdentificationUnit& unit, Node& /*node*/) {
    identification_ = &unit;
  }

  BusNodes& nodes_;
  const BusNetworkOptions& options_;
  const BusVehicle& vehicle_;
  const TrueClock& clock_;
  cia407::MainOnBoardComputerUnit* unit_ = nullptr;
  LineControl* line_control_ = nullptr;
  cia407::IdentificationUnit* identification_ = nullptr;
  cia407::Assignment remembered_;  ///< by the identification device
  bool clock_is_wrong_ = false;
};

}  // namespace canvoy::bus
