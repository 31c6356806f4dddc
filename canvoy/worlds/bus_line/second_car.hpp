// The second car of a bus: its gateway, which has the displays there show the data of the first
// car, the gateway in the first car, and the train bus between both.
//
//     SecondCar second(nodes, options.sabotage);
//     second.step(now);                 // each 100 ms
//     second.press_stop_button();
#pragma once

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/mirror_control.hpp"
#include "canvoy/worlds/bus_line/train_link.hpp"

namespace canvoy::bus_line {

class SecondCar {
 public:
  /// Both must outlive this object.
  SecondCar(BusNodes& nodes, const Sabotage& sabotage)
      : nodes_(nodes), sabotage_(sabotage), train_(nodes.world()) {}
  SecondCar(const SecondCar&) = delete;
  SecondCar& operator=(const SecondCar&) = delete;

  /// Puts both gateways on the bus.
  void add_nodes();
  /// Delivers what is due on the train bus.
  void step(Time now) { train_.step(now); }
  /// Cuts or mends the train bus.
  void cut_train_bus(bool is_cut) { train_.cut(is_cut); }
  /// Presses a button of this car, which is wired to its gateway. False: the press has no effect.
  bool press_stop_button() { return !sabotage_.dead_second_button && train_.press_stop_button(); }

 private:
  cia407::BusSegment segment() { return {.has_main_computer = false, .has_diagnostics = false}; }
  MirrorControlHardware mirror_hardware();
  MirrorControlSettings mirror_settings();

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  TrainLink train_;
};

}  // namespace canvoy::bus_line
