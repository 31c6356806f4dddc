// The power supply of a police car, and its relays for radio and periphery.
//
//     SupplyDevice supply(bus, options, events);
//     supply.radio_has_power()
#pragma once

#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/worlds/car/car_bus.hpp"
#include "canvoy/worlds/police/police_event.hpp"
#include "canvoy/worlds/police/police_options.hpp"

namespace canvoy::police {

class SupplyDevice {
 public:
  /// All must outlive this object.
  SupplyDevice(car::CarBus& bus, const PoliceOptions& options, EventLog<PoliceEvent>& events)
      : bus_(bus), options_(options), events_(events) {}
  SupplyDevice(const SupplyDevice&) = delete;
  SupplyDevice& operator=(const SupplyDevice&) = delete;

  /// Puts the device on the bus.
  void add_node();
  /// Takes power from the device; does nothing to other nodes.
  void lose_power(NodeId id);
  /// Sets the inputs of the device when it gets power.
  void sense(NodeId id);
  /// Makes the radio take more current than allowed, or not.
  void overload(bool is_overloaded);

  /// State of the relay of the radio.
  bool radio_has_power() const { return radio_has_power_; }
  /// State of the relay of the periphery.
  bool periphery_has_power() const { return periphery_has_power_; }

 private:
  cia447::PowerSupplyHardware hardware();
  cia447::PowerSupplySettings settings() { return options_.supply; }
  void switch_power(cia447::Supply supply, bool is_on);

  car::CarBus& bus_;
  const PoliceOptions& options_;
  EventLog<PoliceEvent>& events_;
  cia447::PowerSupplyUnit* unit_ = nullptr;
  bool radio_has_power_ = false;
  bool periphery_has_power_ = false;
  bool is_overloaded_ = false;
};

}  // namespace canvoy::police
