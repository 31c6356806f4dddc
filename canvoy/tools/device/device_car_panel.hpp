// What a person does at a device of CiA 447 that `canvoy device` runs, and sees of it: hands do at
// given times what their tables say (car/car_hand_tables.hpp); the meter's display, what it
// records, paper, texts and lamps are told.
//
//     CarPanel panel(units, options, car, site, output);
//     panel.take("hire@10s");
//     panel.step(node, now);   // often
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/car_device.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/tools/device/car/car_hands.hpp"
#include "canvoy/tools/device/device_car.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

/// A taximeter and those that it has do something.
struct CarPanelOptions {
  std::uint32_t k = 24'000;  ///< pulses for a kilometre: those of our gateway
  unsigned printer = 0;      ///< node-IDs; 0: there is none
  unsigned sign = 0;
  unsigned clock = 0;
  /// What the calibration drive of a taximeter is long, in 0,001 of the distance unit.
  std::uint32_t calibration = 1000;
  std::string mode = "taximeter";      ///< or `odometer`: of a taximeter (60DAh:02h)
  std::string calculation = "single";  ///< or `double`: of its fare (60D0h:04h)
  std::string future_tariff{};         ///< `7@2026-12-01T00:00:00`: number, and from when on
};

void add_car_panel_options(Verb& command, CarPanelOptions& options);

/// Throws UsageError for a hand that none of these units has, all that there are, and for options
/// that make no sense.
void check_car_panel(std::span<const cia447::CarUnit* const> units,
                     std::span<const std::string> presses, std::span<const std::string> sets,
                     const CarPanelOptions& options);

class CarPanel {
 public:
  /// It joins the site, and must outlive the device that is made there; all others, and `flash`
  /// (null: nothing is kept), must outlive this.
  CarPanel(std::span<const cia447::CarUnit* const> units, const CarPanelOptions& options,
           DeviceCar& car, Site& site, const DeviceOutput& output, const Flash* flash = nullptr);
  CarPanel(const CarPanel&) = delete;
  CarPanel& operator=(const CarPanel&) = delete;

  /// Null: it is none of the units.
  cia447::IvnGatewayUnit* gateway() const { return hands_.unit<cia447::IvnGatewayKind>(); }
  /// A hand and a time: throws as parse_hand_order() does.
  void take(std::string_view order) { hands_.take(parse_hand_order(units_, order)); }
  /// Does what is due. Times count from the first call.
  void step(Node& node, Time now);
  /// The device is going to lose its power.
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
  cia447::PrinterHardware printer();
  void put(const cia447::PrintedCharacter& printed);
  void feed(unsigned dots);
  cia447::TerminalHardware terminal();
  void show_text(const cia447::DisplayContent& content);
  cia447::TariffDisplayHardware sign();
  void drive_lamp(unsigned lamp, cia447::Lamp wanted);
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
  std::vector<const cia447::CarUnit*> units_;
  CarHands hands_;
  std::optional<cia447::MeterOutputs> outputs_;
  std::uint32_t receipts_ = 0;
  std::string told_;  ///< of the meter
  cia447::Taximeter state_ = cia447::Taximeter::signed_off;
  std::string line_;  ///< on paper
  std::string told_of_network_;
};

}  // namespace canvoy::tools
