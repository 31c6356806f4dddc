// What a person does at a device of CiA 447 that `canvoy device` runs, and sees of it: keys of a
// taximeter and an alarm are pressed at given times, and the seal is opened and closed; the meter's
// display, what it records, paper, texts and lamps are told.
//
//     CarPanel panel(units, {.presses = {"sign-on@2s", "hire@10s"}}, site, output);
//     panel.step(now);   // often
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/car_device.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/cli/verb.hpp"
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
};

void add_car_panel_options(Verb& command, CarPanelOptions& options);

/// Throws UsageError for one that is none of these units, all that there are.
void check_car_presses(std::span<const cia447::CarUnit* const> units,
                       const std::vector<std::string>& presses);

class CarPanel {
 public:
  /// `presses` are such as `hire@10s`; those of other devices are left to them. It joins the site,
  /// and must outlive the device that is made there; `output` and `flash` (null: nothing is kept)
  /// must outlive this.
  CarPanel(std::span<const cia447::CarUnit* const> units, const std::vector<std::string>& presses,
           const CarPanelOptions& options, Site& site, const DeviceOutput& output,
           const Flash* flash = nullptr);
  CarPanel(const CarPanel&) = delete;
  CarPanel& operator=(const CarPanel&) = delete;

  /// Presses what is due. Times count from the first call.
  void step(Time now);
  /// The device is going to lose its power.
  void end();

 private:
  struct Press {
    std::string key;
    Duration at{};
    bool is_done = false;
  };
  void press(const std::string& key);
  bool press_at_meter(const std::string& key);
  void open_seal(bool is_open);

  cia447::TaximeterHardware meter_hardware();
  cia447::TaximeterSettings meter_settings();
  void has_meter(cia447::TaximeterUnit& unit, Node& /*node*/) { meter_ = &unit; }
  void has_network(cia447::CarNetwork& network, Node& node);
  bool seal_is_open() { return is_seal_open_; }
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
  void has_alarm(cia447::TaxiAlarmUnit& unit, Node& /*node*/) { alarm_ = &unit; }
  void alarm_changed(bool silent, bool full);
  void has_master(cia447::CarMaster& master, Node& /*node*/);
  void car_event(const cia447::CarEvent& event);

  CarPanelOptions options_;
  const DeviceOutput& output_;
  const Flash* flash_;
  bool is_meter_ = false;
  bool is_gateway_ = false;
  bool is_seal_open_ = false;
  std::vector<Press> presses_;
  std::optional<Time> begin_;
  cia447::TaximeterUnit* meter_ = nullptr;
  std::optional<cia447::MeterOutputs> outputs_;
  std::uint32_t receipts_ = 0;
  std::string told_;  ///< of the meter
  cia447::Taximeter state_ = cia447::Taximeter::signed_off;
  std::string line_;  ///< on paper
  cia447::TaxiAlarmUnit* alarm_ = nullptr;
  std::string told_of_network_;
};

}  // namespace canvoy::tools
