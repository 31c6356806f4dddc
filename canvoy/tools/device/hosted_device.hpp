// A device of `canvoy device`, from the catalogue or a data sheet, with its surroundings.
//
//     HostedDevice device(wanted, port, hardware, options, output);
//     device.start(now);
//     device.step(now);   // often
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "canvoy/canopen/lss/bit_timing_switch.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/lss/lss_store.hpp"
#include "canvoy/canopen/remote/identity.hpp"
#include "canvoy/devices/cia419/charger.hpp"
#include "canvoy/formats/sheet/sheet_device.hpp"
#include "canvoy/tools/device/car/device_car_panel.hpp"
#include "canvoy/tools/device/device_hardware.hpp"
#include "canvoy/tools/device/device_options.hpp"
#include "canvoy/tools/device/device_wires.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/interface_bit_timing.hpp"
#include "canvoy/tools/device/store/car_store.hpp"
#include "canvoy/tools/device/store/device_store.hpp"

namespace canvoy::tools {

// LSS for a device of the command: its serial number, storage of its node-ID, and text of events.
//
//     LssOption lss(output, "battery", device.node(), {.serial_number = 7});

class LssOption {
 public:
  struct Settings {
    std::optional<std::uint32_t> serial_number;
    const Flash* flash = nullptr;  ///< storage of the node-ID; null: not stored
    LssStore::Place place = {};
    std::string interface = {};        ///< interface with a bit rate that LSS may set; empty: none
    Indicators* indicators = nullptr;  ///< indicators of its state
    /// Uses the stored bit rate for the interface; false if the bit rate was just found by
    /// listening.
    bool takes_stored_bit_rate = true;
  };

  /// To be called before Node::start(). The node must have a free route.
  LssOption(const DeviceOutput& output, std::string who, Node& node, const Settings& settings);
  LssOption(const LssOption&) = delete;
  LssOption& operator=(const LssOption&) = delete;

 private:
  void reset(ResetScope scope);
  void entered(LssState state);
  void switch_to(std::uint8_t bit_timing) {
    if (bit_timing_) bit_timing_->switch_to(bit_timing);
  }
  LssSlaveHooks hooks(const Settings& settings);

  const DeviceOutput& output_;
  std::string who_;
  Node& node_;
  NodeId told_ = 0;  ///< the pending node-ID that was last reported
  Identity identity_;
  Indicators* indicators_;
  std::optional<LssStore> store_;
  std::optional<InterfaceBitTiming> bit_timing_;
  std::optional<BitTimingSwitch> switch_;
  LssSlave slave_;
  Service service_;
};

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
