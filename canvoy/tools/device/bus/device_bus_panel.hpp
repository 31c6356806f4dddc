// The surroundings of a device of CiA 407 that `canvoy device` runs: actions of passengers and a
// driver at given times, and reports of what they see, hear and get.
//
//     BusPanel panel(units, {.presses = {"ticket@2s"}}, car, environment, output);
//     panel.step(now);   // often
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/canopen/host/file_flash.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/bus/bus_console.hpp"
#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"
#include "canvoy/tools/device/bus/bus_motion.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/bus/bus_tickets.hpp"
#include "canvoy/tools/device/bus/bus_wires.hpp"
#include "canvoy/tools/device/bus/device_bus_displays.hpp"
#include "canvoy/tools/device/bus/reported_errors.hpp"
#include "canvoy/tools/device/bus/sensed_vehicle.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/store/car_store.hpp"

namespace canvoy::tools {

// The file of non-volatile values of a hosted device of CiA 407: the node-ID from LSS for any
// device, the assignment for identification, and the counts of a tachograph and a counting manager.
//
//     BusStore store("identification.store");
//     KeptBusValues kept = store.load();
//     store.keep(kept);

struct KeptBusValues {
  cia407::Assignment assignment{};  ///< numbers only, no texts
  double metres = 0;                ///< total distance of the vehicle
  double trip_begin = 0;            ///< m
  cia407::CountingManagerUnit::Counts counts{};

  friend bool operator==(const KeptBusValues&, const KeptBusValues&) = default;
};

class BusStore {
 public:
  /// Throws Failure if the file cannot be used.
  explicit BusStore(const std::string& path);
  BusStore(const BusStore&) = delete;
  BusStore& operator=(const BusStore&) = delete;

  const Flash& flash() const { return file_->flash(); }
  LssStore::Place lss_place() const;
  /// Reads the file; unreadable content counts as empty.
  KeptBusValues load();
  void keep(const KeptBusValues& values);

 private:
  std::unique_ptr<host::FileFlash> file_;
  KeptBytes values_;
};

// The on-board computer of a bus (CiA 407) that `canvoy device` runs, and the identification device
// of its driver: their inputs from the vehicle, and the actions of people on them.
//
//     BusComputer computer(motion, kept.assignment);
//     computer.join(environment);
//     computer.act(parse_bus_press(units, "log-in:driver=1234:line=23@1s"));

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
  std::optional<cia407::CivilTime> clock() { return motion_.utc(); }
  void place(const BusPress& press);
  cia407::IdentificationHardware identification_hardware();
  cia407::Assignment remembered() { return assignment_; }
  void log_in(const BusPress& press);

  const BusMotion& motion_;
  cia407::Assignment kept_;
  cia407::Assignment assignment_;
  cia407::MainOnBoardComputerUnit* unit_ = nullptr;
  cia407::IdentificationUnit* identification_ = nullptr;
};

// Options of the command line for the surroundings of a device of CiA 407 that `canvoy device`
// runs, except presses.
//
//     BusPanelOptions options;
//     add_bus_panel_options(command, options);
//     check_bus_options(units, options, presses);

struct BusPanelOptions {
  std::vector<std::string> segment{};        ///< words of BusSegment: `minimum`, `no-diagnostics`
  std::string png{};                         ///< of a display: the picture file
  std::string display = "32x4";              ///< columns and lines of the display
  std::vector<std::string> announcements{};  ///< `17=Town Hall`; empty: one for every stop
  unsigned capacity = 80;  ///< capacity of the vehicle in passengers, for a counting manager
};

void add_bus_panel_options(Verb& command, BusPanelOptions& options);

/// Throws UsageError.
cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words);
/// Throws UsageError for an option that does not apply to these units, which are all units of the
/// device.
void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses);

// The train bus at the gateway of a bus (CiA 407) that `canvoy device` runs: reports data to the
// other vehicles, and takes data from them as presses.
//
//     TrainBus train(output);
//     train.join(environment);
//     train.act(parse_bus_press(units, "from-train:index=0x6109:value=17@2s"), node);

class TrainBus {
 public:
  /// `output` must outlive this.
  explicit TrainBus(const DeviceOutput& output) : output_(output) {}
  TrainBus(const TrainBus&) = delete;
  TrainBus& operator=(const TrainBus&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `from-train`, which needs the gateway, on its node; ignores others.
  void act(const BusPress& press, Node& node);

 private:
  cia407::TrainBusGatewayHardware hardware();
  void send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);

  const DeviceOutput& output_;
  cia407::TrainBusGatewayUnit* gateway_ = nullptr;
};

// The passenger counter of a door of a bus and the counting manager (CiA 407) that `canvoy device`
// runs: people who get in and out, and the capacity.
//
//     BusCounting counting({.door = 2, .capacity = 80, .kept = kept.counts});
//     counting.join(environment);
//     counting.act(parse_bus_press(units, "in:3@2s"));

class BusCounting {
 public:
  using Counts = cia407::CountingManagerUnit::Counts;
  struct Settings {
    unsigned door = 1;       ///< of the counter, 1 to 12
    unsigned capacity = 80;  ///< of the vehicle, in passengers
    Counts kept{};           ///< before the last power-down
  };

  explicit BusCounting(const Settings& settings) : settings_(settings) {}
  BusCounting(const BusCounting&) = delete;
  BusCounting& operator=(const BusCounting&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `in`, `out`, `open-door`, `close-door` and `clear`, which need the device; ignores
  /// others.
  void act(const BusPress& press);

  /// The counts; nothing without a counting manager.
  std::optional<Counts> counts() const;

 private:
  cia407::PassengerCounterSettings counter_settings() { return {.door = settings_.door}; }
  cia407::CountingManagerSettings manager_settings() { return {.capacity = settings_.capacity}; }
  void is_manager(cia407::CountingManagerUnit& unit, Node& node);

  Settings settings_;
  cia407::PassengerCounterUnit* counter_ = nullptr;
  cia407::CountingManagerUnit* manager_ = nullptr;
};

// The satellites of a bus (CiA 407) that `canvoy device` runs: input of geographical positioning
// and time fixing, while there is a signal.
//
//     BusSatellites satellites(motion);
//     satellites.join(environment);
//     satellites.act(parse_bus_press(units, "no-signal@2s"));

class BusSatellites {
 public:
  /// `motion` must outlive this.
  explicit BusSatellites(const BusMotion& motion) : motion_(motion) {}
  BusSatellites(const BusSatellites&) = delete;
  BusSatellites& operator=(const BusSatellites&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `signal` and `no-signal`; ignores others.
  void act(const BusPress& press);

 private:
  cia407::PositioningHardware positioning();
  cia447::GpsReading position();
  cia407::TimeFixingHardware time_fixing();
  std::optional<cia407::CivilTime> time();

  const BusMotion& motion_;
  bool has_signal_ = true;
};

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
