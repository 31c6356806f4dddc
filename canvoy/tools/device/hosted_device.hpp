// A device of `canvoy device`, from the catalogue or a data sheet, with its surroundings.
//
//     HostedDevice device(wanted, port, hardware, options, output);
//     device.start(now);
//     device.step(now);   // often
#pragma once

#include <memory>
#include <string>

#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/formats/sheet/sheet_device.hpp"
#include "canvoy/tools/device/car/device_car_panel.hpp"
#include "canvoy/tools/device/device_hardware.hpp"
#include "canvoy/tools/device/device_options.hpp"
#include "canvoy/tools/device/device_wires.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/lss_option.hpp"
#include "canvoy/tools/device/store/car_store.hpp"
#include "canvoy/tools/device/store/device_store.hpp"

namespace canvoy::tools {

class HostedDevice {
 public:
  /// All arguments must outlive this. Throws Failure if a file cannot be used.
  HostedDevice(const Wanted& wanted, const Port& port, DeviceHardware& hardware,
               const DeviceOptions& options, const DeviceOutput& output);
  ~HostedDevice();
  HostedDevice(const HostedDevice&) = delete;
  HostedDevice& operator=(const HostedDevice&) = delete;

  Node& node() { return *node_; }
  /// To be called often.
  void step(Time now);
  /// Adds a hand, button or move with its time, as in --press, --set and --move. Throws UsageError
  /// if this device does not have it.
  void take(const std::string& order);
  /// The panel of an operator environment with real hands; null: none.
  OperatorPanel* panel_with_hands() const;
  void start(Time now);
  void say_what_was_kept() const;

 private:
  class HeartbeatOption;
  class StateTeller;

  void hold_device(const Wanted& wanted, const Port& port, DeviceHardware& hardware,
                   const DeviceOptions& options);
  void hold_bus_device(const Wanted& wanted, const Port& port, const DeviceHardware& hardware,
                       const DeviceOptions& options);
  template <class Panel>
  void take_options(const DeviceOptions& options, Panel& panel);
  template <class Device>
  void hold(const std::shared_ptr<Device>& device);
  void is_charger(cia419::Charger& charger, Node& node);
  void hold_bootloader(const Wanted& wanted, const Port& port);
  void hold_sheet(const Wanted& wanted, const Port& port, bool stores);
  static void say_values_only(const std::string& kind, const formats::SheetDevice& device);
  void add_lss(const DeviceOptions& options);
  void charger_said(cia419::Charger::Event event);

  const DeviceOutput& output_;
  std::string who_;
  Environment environment_;
  std::unique_ptr<DeviceWires> wires_;
  std::unique_ptr<CarStore> car_store_;  ///< for a device of a car
  std::unique_ptr<CarPanel> car_panel_;
  std::unique_ptr<BusStore> bus_store_;  ///< for a device of a bus
  std::unique_ptr<BusPanel> bus_panel_;
  std::unique_ptr<OperatorPanel> operator_panel_;
  std::shared_ptr<void> device_;
  Node* node_ = nullptr;
  cia419::Charger* charger_ = nullptr;
  std::unique_ptr<DeviceStore> store_;
  std::unique_ptr<HeartbeatOption> heartbeat_;
  std::unique_ptr<LssOption> lss_;
  std::unique_ptr<StateTeller> teller_;
  std::shared_ptr<Indicators> indicators_;
  std::unique_ptr<LightsTeller> lights_;
};

}  // namespace canvoy::tools
