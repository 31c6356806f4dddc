// The surroundings of a device of CiA 407 that `canvoy device` runs: actions of passengers and a
// driver at given times, and reports of what they see, hear and get.
//
//     BusPanel panel(units, {.presses = {"ticket@2s"}}, car, environment, output);
//     panel.step(now);   // often
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/tools/device/bus/bus_computer.hpp"
#include "canvoy/tools/device/bus/bus_console.hpp"
#include "canvoy/tools/device/bus/bus_counting.hpp"
#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"
#include "canvoy/tools/device/bus/bus_motion.hpp"
#include "canvoy/tools/device/bus/bus_panel_options.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/bus/bus_satellites.hpp"
#include "canvoy/tools/device/bus/bus_store.hpp"
#include "canvoy/tools/device/bus/bus_tickets.hpp"
#include "canvoy/tools/device/bus/bus_wires.hpp"
#include "canvoy/tools/device/bus/device_bus_displays.hpp"
#include "canvoy/tools/device/bus/reported_errors.hpp"
#include "canvoy/tools/device/bus/sensed_vehicle.hpp"
#include "canvoy/tools/device/bus/train_bus.hpp"

namespace canvoy::tools {

class BusPanel {
 public:
  struct Place {
    const DeviceCar& car;
    Callback<Time()> clock;
    const DeviceOutput& output;
    BusStore* store = nullptr;  ///< null: nothing is stored
  };

  /// Ignores presses of other devices. Joins the environment, and must outlive the device that is
  /// made there; what `place` refers to must outlive this.
  BusPanel(std::span<const cia407::BusUnit* const> units, const std::vector<std::string>& presses,
           const BusPanelOptions& options, Environment& environment, const Place& place);
  BusPanel(const BusPanel&) = delete;
  BusPanel& operator=(const BusPanel&) = delete;

  /// Adds a press with its time. Throws like parse_bus_press().
  void take(std::string_view press);
  /// Performs what is due, and reports changes. Times count from the first call.
  void step(Node& node, Time now);
  /// Stores values before the device loses its power.
  void end() { keep(); }

 private:
  struct Planned {
    BusPress press;
    bool is_done = false;
  };

  void join(Environment& environment);
  cia407::BusSegment segment() const { return segment_; }
  void act(const BusPress& press, Node& node);
  void keep();

  std::vector<const cia407::BusUnit*> units_;
  cia407::BusSegment segment_;
  std::vector<Planned> plan_;
  std::optional<Time> begin_;
  BusStore* store_;
  KeptBusValues kept_;    ///< before the start
  KeptBusValues stored_;  ///< since the start
  Time keep_at_{};

  // Surroundings of the device.
  BusMotion motion_;
  ReportedErrors errors_;
  DeviceBusDisplays displays_;
  BusLoudspeakers loudspeakers_;
  BusTickets tickets_;
  BusComputer computer_;
  BusConsole console_;
  SensedVehicle vehicle_;
  BusSatellites satellites_;
  BusCounting counting_;
  TrainBus train_;
  BusWires wires_;
};

}  // namespace canvoy::tools
