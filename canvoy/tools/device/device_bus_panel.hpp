// What is around a device of CiA 407 that `canvoy device` runs: passengers and a driver do
// something with it at given times, and what they see, hear and get of it is told.
//
//     BusPanel panel(units, {.presses = {"ticket@2s"}}, car, site, output);
//     panel.step(now);   // often
#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/acoustic/acoustic_control_manager_unit.hpp"
#include "canvoy/devices/cia407/bus_device.hpp"
#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/console/keyboard_unit.hpp"
#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"
#include "canvoy/tools/device/bus_press.hpp"
#include "canvoy/tools/device/bus_store.hpp"
#include "canvoy/tools/device/device_bus_display.hpp"
#include "canvoy/tools/device/device_car.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

struct BusPanelOptions {
  std::vector<std::string> segment{};        ///< words of BusSegment: `minimum`, `no-diagnostics`
  std::string png{};                         ///< of a display: the file of its picture
  std::string display = "32x4";              ///< its columns and lines
  std::vector<std::string> announcements{};  ///< `17=Town Hall`; none: it has one for every stop
  unsigned capacity = 80;                    ///< of the vehicle, of a counting manager
};

void add_bus_panel_options(CLI::App& command, BusPanelOptions& options);

/// Throws UsageError.
cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words);
/// Throws UsageError for what makes no sense with these units, all that there are.
void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses);

class BusPanel {
 public:
  struct Place {
    const DeviceCar& car;
    Callback<Time()> clock;
    const DeviceOutput& output;
    BusStore* store = nullptr;  ///< null: nothing is kept
  };

  /// Presses of other devices are left to them. It joins the site, and must outlive the device that
  /// is made there; what `place` refers to must outlive this.
  BusPanel(std::span<const cia407::BusUnit* const> units, const std::vector<std::string>& presses,
           const BusPanelOptions& options, Site& site, const Place& place);
  BusPanel(const BusPanel&) = delete;
  BusPanel& operator=(const BusPanel&) = delete;

  /// Does what is due, and tells what is new. Times count from the first call.
  void step(Node& node, Time now);
  /// The device is going to lose its power.
  void end() { keep(); }

 private:
  struct Planned {
    BusPress press;
    bool is_done = false;
  };

  void join(Site& site);
  void join_people(Site& site);
  void join_vehicle(Site& site);
  void join_codes(Site& site);
  template <class Unit>
  void watch(Site& site);
  template <class Unit>
  void is_there(Unit& unit, Node& /*node*/) {
    std::get<Unit*>(units_) = &unit;
  }
  template <class Unit>
  Unit* unit() const {
    return std::get<Unit*>(units_);
  }

  // device_bus_act.cpp
  void act(const BusPress& press, Node& node);
  void act_on_tickets(const BusPress& press);
  void act_as_driver(const BusPress& press);
  void act_on_counter(const BusPress& press);
  void act_on_computer(const BusPress& press);
  void receive(const BusPress& press, Node& node);
  void answer(cia407::TicketAnswer answer, std::string_view who);

  // device_bus_people.cpp, device_bus_vehicle.cpp
  cia407::BusSegment segment() const { return segment_; }
  cia407::DisplayHardware display();
  cia407::TicketCancellerHardware canceller();
  void stamp(const cia407::TicketData& ticket);
  void show_ready(bool is_ready);
  cia407::TicketPrinterHardware printer();
  bool print(const cia407::TicketData& ticket);
  bool has_paper() { return has_paper_; }
  cia407::AcousticAnnouncerHardware announcer();
  bool announce(std::uint32_t stop_point, std::string_view text);
  cia407::AcousticControlManagerHardware control_manager();
  cia407::AudioPaths switch_paths(const cia407::AudioPaths& wanted);
  cia407::TrainBusGatewayHardware train();
  void send_to_train(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  cia407::DriverIndicatorHardware indicator();
  void show_driver(const cia407::DriverView& view);
  cia407::IdentificationHardware identification();
  cia407::Assignment remembered() { return assignment_; }
  cia407::MainOnBoardComputerHardware computer();
  cia407::KeyboardHardware keyboard();
  std::uint32_t keys() { return keys_; }
  bool is_reverse() { return is_reverse_; }
  cia407::GenericIoHardware io();
  std::uint32_t inputs() { return inputs_; }
  void set_outputs(std::uint32_t outputs);
  void set_analogue(unsigned channel, std::int16_t value);
  bool has_error(std::uint16_t code) { return errors_.contains(code); }
  bool is_disconnected(std::uint16_t /*code*/) { return is_disconnected_; }
  cia407::PassengerCounterSettings counter();
  cia407::CountingManagerSettings manager();
  void has_manager(cia407::CountingManagerUnit& unit, Node& node);
  cia407::VehicleGatewayHardware gateway();
  cia407::VehicleReading vehicle();
  double metres() const;
  cia407::TachographHardware tachograph();
  cia407::TachographSettings tachograph_settings();
  cia407::TachographReading record();
  cia407::PositioningHardware positioning();
  cia447::GpsReading receiver();
  cia407::TimeFixingHardware time_fixing();
  std::optional<cia407::CivilTime> satellite_time();
  std::optional<cia407::CivilTime> utc();
  template <cia407::DeviceCode code>
  cia407::CodeOnlyHardware<code> radio();
  cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply> supply();
  void keep();

  std::vector<const cia407::BusUnit*> kinds_;
  BusPanelOptions options_;
  Place place_;
  cia407::BusSegment segment_;
  unsigned door_ = 1;
  std::vector<Planned> plan_;
  std::optional<Time> begin_;
  std::deque<DeviceBusDisplay> displays_;
  std::map<std::uint32_t, std::string> announcements_;

  std::tuple<cia407::TicketCancellerUnit*, cia407::TicketPrinterUnit*, cia407::IdentificationUnit*,
             cia407::MainOnBoardComputerUnit*, cia407::PassengerCounterUnit*,
             cia407::CountingManagerUnit*, cia407::TrainBusGatewayUnit*,
             cia407::VehicleGatewayUnit*, cia407::TachographUnit*>
      units_{};
  bool has_paper_ = true;
  bool has_signal_ = true;
  bool is_disconnected_ = false;
  bool is_reverse_ = false;
  bool is_braking_ = false;
  std::uint32_t keys_ = 0;
  std::map<unsigned, Time> release_at_;  ///< of the keys that are pressed
  std::uint32_t inputs_ = 0;
  std::uint32_t outputs_ = 0;
  std::array<std::int16_t, 8> analogue_{};
  std::set<std::uint16_t> errors_;
  std::array<cia407::DoorState, cia407::VehicleReading::doors_max> doors_{};
  std::array<bool, 2> has_card_{};
  std::string driver_told_;
  cia407::Assignment assignment_;
  KeptBusValues kept_;    ///< from before the start
  KeptBusValues stored_;  ///< since then
  Time keep_at_{};
};

}  // namespace canvoy::tools
