// Hands and outputs of a device that `canvoy device` runs and that is not of a car, a bus or an
// operator environment: modules, lifts, charger and battery.
//
//     DeviceWires wires("lift-landing-panel", hardware, environment, output);
//     wires.take("up@2s");
//     wires.step(node, now);   // often
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/device_hardware.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/hand/hand_order.hpp"
#include "canvoy/tools/device/io_wires.hpp"
#include "canvoy/tools/device/wired_hands.hpp"
#include "canvoy/tools/device/wired_things.hpp"

namespace canvoy::tools {

class DeviceWires : public WiredThings {
 public:
  /// For a device of the catalogue. Joins the environment; all other arguments must outlive this,
  /// and this must outlive the device.
  DeviceWires(std::string_view device, DeviceHardware& hardware, Environment& environment,
              const DeviceOutput& output);

  /// True if the device has a hand of this name.
  bool has(std::string_view order) const { return orders_.has(order); }
  /// Adds a hand with its time. Throws UsageError if the device does not have it.
  void take(std::string_view order) { orders_.take(order); }
  /// Performs what is due. Times count from the first call.
  void step(Node& node, Time now);

  // For hands.

  bool set_input(unsigned number, bool is_on) override;
  bool set_analogue_input(unsigned number, std::int16_t value) override;
  bool set_door_fault(bool lift::DoorFaults::*fault, bool is_there, Time now) override;
  bool put_in_door(bool is_there, Time now) override;
  bool approach_door(bool is_near) override;
  bool touch_door(bool is_touched) override;
  bool set_load(double kilograms) override;
  bool break_rope_sensor(bool is_broken) override;
  lift::CarPlant* car() override { return &hardware_.lift_car().plant(); }
  bool open_safety_chain(bool is_open) override;
  bool catch_safety_gear(bool is_caught) override;
  bool press(cia417::BasicFunction function, std::uint8_t sub_function, const HandValue& value,
             Time now) override;
  bool set_sensor(cia417::SensorFunction sensor, const HandValue& value, Time now) override;
  ChargingPlant* charging() override { return &hardware_.charging(); }

 private:
  bool look();
  cia417::OutputHardware lamps();
  cia417::SensorSettings sensors() { return {.sensors = sensors_}; }
  void show(std::uint32_t number, const cia417::OutputView& view);
  void act(const HandOrder& order, Time now);

  std::string device_;
  DeviceHardware& hardware_;
  const DeviceOutput& output_;
  std::vector<DeviceHand> hands_;
  IoWires io_;
  cia417::PlacedSensors sensors_;
  cia417::InputPanelUnit* inputs_ = nullptr;
  cia417::OutputPanelUnit* outputs_ = nullptr;
  cia417::SensorUnit* sensor_unit_ = nullptr;
  std::vector<cia417::OutputView> views_;
  HandOrders orders_;
};

}  // namespace canvoy::tools
