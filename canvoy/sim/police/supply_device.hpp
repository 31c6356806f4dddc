// The power supply of a police car, and the relays by which it gives power to radio and periphery.
//
//     SupplyDevice supply(bus, options, events);
//     supply.radio_has_power()
#pragma once

#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/sim/car/car_bus.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/police/police_event.hpp"
#include "canvoy/sim/police/police_options.hpp"

namespace canvoy::police {

class SupplyDevice {
 public:
  /// All must outlive this.
  SupplyDevice(car::CarBus& bus, const PoliceOptions& options, EventLog<PoliceEvent>& events)
      : bus_(bus), options_(options), events_(events) {}
  SupplyDevice(const SupplyDevice&) = delete;
  SupplyDevice& operator=(const SupplyDevice&) = delete;

  /// Puts it on the bus.
  void add_node();
  /// What it does without power; of other nodes nothing happens.
  void lose_power(NodeId id);
  /// What it senses when it gets it.
  void sense(NodeId id);
  /// The radio takes more than it may.
  void overload(bool is_overloaded);

  bool radio_has_power() const { return radio_has_power_; }
  bool periphery_has_power() const { return periphery_has_power_; }

 private:
  cia447::PowerSupplyHardware hardware();
  cia447::PowerSupplySettings settings() { return options_.supply; }
  void is_unit(cia447::PowerSupplyUnit& unit, Node& /*node*/) { unit_ = &unit; }
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
