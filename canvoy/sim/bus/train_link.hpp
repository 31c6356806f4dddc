// The train bus between the gateways of two cars: what the first one is told arrives in the second
// one a moment later, and a button that is pressed in the second car in the first one. The first
// one is alive on it while it is operational.
//
//     TrainLink link(world);
//     link.join(first_gateway, second_gateway);
//     link.step(now);   // each 100 ms
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/sim/bus/bus_node.hpp"

namespace canvoy::bus {

class TrainLink {
 public:
  static constexpr Duration delay = 20ms;
  /// Of who is not heard.
  static constexpr Duration time_out = 300ms;

  /// `world` must outlive this.
  explicit TrainLink(World& world) : world_(world) {}
  TrainLink(const TrainLink&) = delete;
  TrainLink& operator=(const TrainLink&) = delete;

  /// Of the gateway in the first car.
  cia407::TrainBusGatewayHardware first_hardware();
  cia407::TrainBusGatewayHardware second_hardware();
  /// One of them was made anew.
  void is_first(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) { first_unit_ = &unit; }
  void is_second(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) {
    second_unit_ = &unit;
    was_alive_ = false;  // it has to be told all
  }
  /// Both must outlive this.
  void join(BusNode& first, BusNode& second) { first_ = &first, second_ = &second; }

  void step(Time now);
  /// What is lost meanwhile is sent again, however short it was.
  void cut(bool is_cut) {
    is_cut_ = is_cut;
    was_alive_ = false;
  }
  /// Of the second car. False: its gateway is not in service.
  bool press_stop_button();
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

}  // namespace canvoy::bus
