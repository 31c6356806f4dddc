// The on-board computer of a bus (CiA 407) that `canvoy device` runs, and the identification device
// of its driver: their inputs from the vehicle, and the actions of people on them.
//
//     BusComputer computer(motion, kept.assignment);
//     computer.join(environment);
//     computer.act(parse_bus_press(units, "log-in:driver=1234:line=23@1s"));
#pragma once

#include <optional>

#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_motion.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class BusComputer {
 public:
  /// `kept` is the assignment before the last power-down; `motion` must outlive this.
  BusComputer(const BusMotion& motion, const cia407::Assignment& kept)
      : motion_(motion), kept_(kept) {}
  BusComputer(const BusComputer&) = delete;
  BusComputer& operator=(const BusComputer&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `log-in`, `log-out`, `stop`, `block`, `unblock` and `place`, which need the device;
  /// ignores others.
  void act(const BusPress& press);

  /// The current assignment; empty without an identification device.
  const cia407::Assignment& assignment() const { return assignment_; }

 private:
  cia407::MainOnBoardComputerHardware hardware();
  void is_unit(cia407::MainOnBoardComputerUnit& unit, Node& /*node*/) { unit_ = &unit; }
  std::optional<cia407::CivilTime> clock() { return motion_.utc(); }
  void place(const BusPress& press);
  cia407::IdentificationHardware identification_hardware();
  void is_identification(cia407::IdentificationUnit& unit, Node& /*node*/) {
    identification_ = &unit;
  }
  cia407::Assignment remembered() { return assignment_; }
  void log_in(const BusPress& press);

  const BusMotion& motion_;
  cia407::Assignment kept_;
  cia407::Assignment assignment_;
  cia407::MainOnBoardComputerUnit* unit_ = nullptr;
  cia407::IdentificationUnit* identification_ = nullptr;
};

}  // namespace canvoy::tools
