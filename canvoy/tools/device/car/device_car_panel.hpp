// Actions of a person on a device of CiA 447 that `canvoy device` runs, and what the person sees:
// hands act at given times by their tables (car/car_hand_tables.hpp); the display of the meter, its
// records, paper, texts and lamps are reported.
//
//     CarPanel panel(units, options, car, environment, output);
//     panel.take("hire@10s");
//     panel.step(node, now);   // often
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/car/car_hands.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

/// Options for a taximeter and the devices that it uses.
struct CarPanelOptions {
  std::uint32_t k = 24'000;  ///< pulses per kilometre, those of our gateway
  unsigned printer = 0;      ///< node-ID; 0: none
  unsigned sign = 0;
  unsigned clock = 0;
  /// Length of the calibration drive of a taximeter, in 0,001 of the distance unit.
  std::uint32_t calibration = 1000;
  std::string mode = "taximeter";      ///< or `odometer`: mode of a taximeter (60DAh:02h)
  std::string calculation = "single";  ///< or `double`: calculation of the fare (60D0h:04h)
  std::string future_tariff{};         ///< `7@2026-12-01T00:00:00`: number and start time
};

void add_car_panel_options(Verb& command, CarPanelOptions& options);

/// Throws UsageError for a hand that none of these units, which are all units of the device, has,
/// and for invalid options.
void check_car_panel(const CarPanelOptions& options);

class CarPanel {
 public:
  /// Joins the environment, and must outlive the device that is made there; all other arguments,
  /// including `flash` (null: nothing is stored), must outlive this.
  CarPanel(std::span<const cia447::CarUnit* const> units, const CarPanelOptions& options,
           DeviceCar& car, Environment& environment, const DeviceOutput& output,
           const Flash* flash = nullptr);
  CarPanel(const CarPanel&) = delete;
  CarPanel& operator=(const CarPanel&) = delete;

  /// The gateway; null: none of the units.
  cia447::IvnGatewayUnit* gateway() const { return hands_.unit<cia447::IvnGatewayKind>(); }
  /// True if one of the devices has a hand of this name.
  bool has(std::string_view order) const { return hands_.has(order); }
  /// Adds a hand with a time. Throws like CarHands::take().
  void take(std::string_view order) { hands_.take(order); }
  /// Performs what is due. Times count from the first call.
  void step(Node& node, Time now);
  /// Stores values before the device loses its power.
  void end();

 private:
  cia447::TaximeterHardware meter_hardware();
  cia447::TaximeterSettings meter_settings();
  void has_network(cia447::CarNetwork& network, Node& node);
  bool seal_is_open() { return is_seal_open_; }
  std::optional<cia447::LocalTime> local_time() { return car_.local_time(); }
  void recorded(const cia447::AuditEntry& entry);
  void show_meter(const cia447::TaximeterDisplay& display);
  void print_receipt(const cia447::TaximeterDisplay& display);
  void print_slip();
  cia447::PrinterHardware printer();
  void put(const cia447::PrintedCharacter& printed);
  void feed(unsigned dots);
  cia447::TerminalHardware terminal();
  void show_text(const cia447::DisplayContent& content);
  cia447::TariffDisplayHardware sign();
  void drive_lamp(unsigned lamp, cia447::Lamp wanted);
  void show_level(const std::array<std::uint8_t, 2>& level);
  cia447::TaxiAlarmHardware alarm();
  void alarm_changed(bool silent, bool full);
  void has_master(cia447::CarMaster& master, Node& /*node*/);
  void car_event(const cia447::CarEvent& event);

  CarPanelOptions options_;
  const DeviceOutput& output_;
  const Flash* flash_;
  bool is_meter_ = false;
  bool is_gateway_ = false;
  bool is_seal_open_ = false;
  bool told_seal_is_open_ = false;
  DeviceCar& car_;
  CarHands hands_;
  std::optional<cia447::MeterOutputs> outputs_;
  std::uint32_t receipts_ = 0;
  bool has_slip_ = false;  ///< a slip waits to be printed
  std::string told_;       ///< last text of the meter
  cia447::Taximeter state_ = cia447::Taximeter::signed_off;
  std::string line_;  ///< current line on paper
  std::string told_of_network_;
};

}  // namespace canvoy::tools
