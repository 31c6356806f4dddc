// The cars behind the first one of a bus: in each, a gateway, which has the displays there show the
// data of the first car; the gateway in the first car; and the train bus between all of them.
//
//     FollowingCars following(nodes, options.sabotage);
//     following.step(now);                 // each 100 ms
//     following.press_stop_button(2);
#pragma once

#include <deque>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/mirror_control.hpp"
#include "canvoy/worlds/bus_line/train_link.hpp"

namespace canvoy::bus_line {

class FollowingCars {
 public:
  /// Both must outlive this object.
  FollowingCars(BusNodes& nodes, const Sabotage& sabotage)
      : nodes_(nodes), sabotage_(sabotage), train_(nodes.world()) {}
  FollowingCars(const FollowingCars&) = delete;
  FollowingCars& operator=(const FollowingCars&) = delete;

  /// Puts all gateways on the bus.
  void add_nodes();
  /// Delivers what is due on the train bus.
  void step(Time now) { train_.step(now); }
  /// Cuts or mends the train bus behind the first car.
  void cut_train_bus(bool is_cut) { train_.cut(is_cut); }
  /// Presses a button of car 2, 3 or 4, which is wired to its gateway. False: the press has no
  /// effect.
  bool press_stop_button(unsigned car) {
    return sabotage_.dead_button_car != car && train_.press_stop_button(car);
  }

 private:
  /// A car, as its gateway knows it.
  class Car {
   public:
    /// Both must outlive the car.
    Car(const BusNodes& nodes, TrainLink& train, unsigned number)
        : nodes_(nodes), train_(train), number_(number) {}
    void add_to(Environment& environment);

   private:
    cia407::BusSegment segment() { return {.has_main_computer = false, .has_diagnostics = false}; }
    MirrorControlHardware mirror_hardware();
    MirrorControlSettings mirror_settings();
    void is_made(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) {
      train_.is_following(number_, unit);
    }

    const BusNodes& nodes_;
    TrainLink& train_;
    unsigned number_;
  };

  BusNodes& nodes_;
  const Sabotage& sabotage_;
  TrainLink train_;
  std::deque<Car> cars_;
};

}  // namespace canvoy::bus_line
