// The on-board computer of a bus and the identification device at which the driver enters the work
// to do: their wiring in the vehicle, and the actions of hands at them.
//
//     OnBoardComputer computer(nodes, options, vehicle, clock);
//     computer.log_in(assignment);
//     computer.press_stop_button();
#pragma once

#include <optional>

#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/line_control.hpp"
#include "canvoy/worlds/bus_line/true_clock.hpp"

namespace canvoy::bus_line {

class OnBoardComputer {
 public:
  /// All must outlive this object.
  OnBoardComputer(BusNodes& nodes, const BusNetworkOptions& options, const BusVehicle& vehicle,
                  const TrueClock& clock)
      : nodes_(nodes), options_(options), vehicle_(vehicle), clock_(clock) {}
  OnBoardComputer(const OnBoardComputer&) = delete;
  OnBoardComputer& operator=(const OnBoardComputer&) = delete;

  /// Puts both on the bus.
  void add_nodes();

  /// Enters the driver's assignment. False: the identification device has no power.
  bool log_in(const cia407::Assignment& assignment);
  /// Presses a button of the first car, which is wired to the computer. False: it is not in
  /// service.
  bool press_stop_button();
  /// Sets its own clock an hour ahead, or right.
  void mistake_clock(bool is_wrong) { clock_is_wrong_ = is_wrong; }
  /// True while a fault keeps its clock an hour fast.
  bool has_wrong_clock() const { return clock_is_wrong_; }

  /// Number of people aboard, by the messages that it has heard.
  unsigned counted() const;
  /// Motion by a real vehicle gateway; empty: that is simulated here, or is silent.
  std::optional<RealMotion> heard_motion();

 private:
  cia407::MainOnBoardComputerHardware hardware();
  cia407::MainOnBoardComputerSettings settings();
  LineControlHardware line_control_hardware();
  LineControlSettings line_control_settings();
  double pulses_as_metres();
  bool has_open_door() { return !vehicle_.all_doors_closed(); }
  std::optional<cia407::CivilTime> own_clock();
  std::optional<cia407::CivilTime> reported_clock();
  cia407::IdentificationHardware identification_hardware();
  cia407::Assignment remembered() { return remembered_; }

  BusNodes& nodes_;
  const BusNetworkOptions& options_;
  const BusVehicle& vehicle_;
  const TrueClock& clock_;
  cia407::MainOnBoardComputerUnit* unit_ = nullptr;
  LineControl* line_control_ = nullptr;
  cia407::IdentificationUnit* identification_ = nullptr;
  cia407::Assignment remembered_;  ///< assignment in the identification device
  bool clock_is_wrong_ = false;
};

}  // namespace canvoy::bus_line
