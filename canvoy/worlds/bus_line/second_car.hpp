// The second car of a bus: its gateway, which has the displays there show the data of the first
// car, the gateway in the first car, and the train bus between both.
//
//     SecondCar second(nodes, options.sabotage);
//     second.step(now);                 // each 100 ms
//     second.press_stop_button();
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/worlds/bus_line/bus_node.hpp"
#include "canvoy/worlds/bus_line/bus_nodes.hpp"
#include "canvoy/worlds/bus_line/mirror_control.hpp"

namespace canvoy::bus_line {

// The train bus between the gateways of two cars: data given to the first gateway arrive in the
// second one a moment later, and a press of a button in the second car arrives in the first. The
// first gateway is alive on it while it is operational.
//
//     TrainLink link(world);
//     link.join(first_gateway, second_gateway);
//     link.step(now);   // each 100 ms

class TrainLink {
 public:
  static constexpr Duration delay = 20ms;  ///< from one gateway to the other
  /// Time after which a silent gateway is lost.
  static constexpr Duration time_out = 300ms;

  /// `world` must outlive this object.
  explicit TrainLink(World& world) : world_(world) {}
  TrainLink(const TrainLink&) = delete;
  TrainLink& operator=(const TrainLink&) = delete;

  /// Hardware of the gateway in the first car.
  cia407::TrainBusGatewayHardware first_hardware();
  /// Hardware of the gateway in the second car.
  cia407::TrainBusGatewayHardware second_hardware();
  /// Sets the new unit after a gateway was made again.
  void is_first(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) { first_unit_ = &unit; }
  /// See is_first().
  void is_second(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) {
    second_unit_ = &unit;
    was_alive_ = false;  // it needs all data again
  }
  /// Both must outlive this object.
  void join(BusNode& first, BusNode& second) { first_ = &first, second_ = &second; }

  /// Delivers what is due; call it often.
  void step(Time now);
  /// Cuts or mends the link. What is lost meanwhile is sent again, however short the cut.
  void cut(bool is_cut) {
    is_cut_ = is_cut;
    was_alive_ = false;
  }
  /// Presses a button of the second car. False: its gateway is not in service.
  bool press_stop_button();
  /// True while the first gateway is heard in the second car.
  bool is_coupled() { return world_.now() - heard_ <= time_out; }

 private:
  struct Value {
    bool is_back = false;  ///< to the first car
    Time due{};
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::vector<std::uint8_t> bytes{};
  };

  void send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  void send_back(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  void put(Value value);
  void send_all();
  void arrive(Time now);
  static void hand_over(std::span<const Value> values, bool is_back, BusNode& node,
                        cia407::TrainBusGatewayUnit* unit);

  World& world_;
  BusNode* first_ = nullptr;
  BusNode* second_ = nullptr;
  cia407::TrainBusGatewayUnit* first_unit_ = nullptr;
  cia407::TrainBusGatewayUnit* second_unit_ = nullptr;
  std::deque<Value> under_way_;
  bool is_cut_ = false;
  bool was_alive_ = false;
  Time heard_ = Time{} - time_out - 1us;
};

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
