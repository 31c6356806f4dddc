// The train bus between the gateways of all cars: data given to the first gateway arrive in all
// others a moment later, and a press of a button in another car arrives in the first. The first
// gateway is alive on it while it is operational.
//
//     TrainLink link(world);
//     link.join(1, first_gateway);
//     link.join(2, second_gateway);
//     link.step(now);   // each 100 ms
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/worlds/bus_line/bus_node.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

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
  /// Hardware of the gateway in any other car.
  cia407::TrainBusGatewayHardware following_hardware();
  /// Sets the new unit after a gateway was made again.
  void is_first(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) { first().unit = &unit; }
  /// See is_first(); `car` is 2 to 4.
  void is_following(unsigned car, cia407::TrainBusGatewayUnit& unit) {
    ends_.at(car - 1).unit = &unit;
    was_alive_ = false;  // it needs all data again
  }
  /// Joins the gateway of a car, which must outlive this object.
  void join(unsigned car, BusNode& gateway) { ends_.at(car - 1).node = &gateway; }

  /// Delivers what is due; call it often.
  void step(Time now);
  /// Cuts or mends the link behind the first car. What is lost meanwhile is sent again, however
  /// short the cut.
  void cut(bool is_cut) {
    is_cut_ = is_cut;
    was_alive_ = false;
  }
  /// Presses a button of car 2, 3 or 4. False: its gateway is not in service.
  bool press_stop_button(unsigned car);
  /// True while the first gateway is heard in the other cars.
  bool is_coupled() { return world_.now() - heard_ <= time_out; }

 private:
  struct Value {
    bool is_back = false;  ///< to the first car
    Time due{};
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::vector<std::uint8_t> bytes{};
  };
  /// A gateway on the train bus.
  struct End {
    BusNode* node = nullptr;  ///< null: there is no such car
    cia407::TrainBusGatewayUnit* unit = nullptr;
  };

  End& first() { return ends_.front(); }
  void send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  void send_back(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);
  void put(Value value);
  void send_all();
  void arrive(Time now);
  static void hand_over(std::span<const Value> values, bool is_back, const End& end);

  World& world_;
  std::array<End, cars_max> ends_{};  ///< of each car
  std::deque<Value> under_way_;
  bool is_cut_ = false;
  bool was_alive_ = false;
  Time heard_ = Time{} - time_out - 1us;
};

}  // namespace canvoy::bus_line
