// The train bus at the gateway of a bus (CiA 407) that `canvoy device` runs: reports data to the
// other vehicles, and takes data from them as presses.
//
//     TrainBus train(output);
//     train.join(environment);
//     train.act(parse_bus_press(units, "from-train:index=0x6109:value=17@2s"), node);
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

class TrainBus {
 public:
  /// `output` must outlive this.
  explicit TrainBus(const DeviceOutput& output) : output_(output) {}
  TrainBus(const TrainBus&) = delete;
  TrainBus& operator=(const TrainBus&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `from-train`, which needs the gateway, on its node; ignores others.
  void act(const BusPress& press, Node& node);

 private:
  cia407::TrainBusGatewayHardware hardware();
  void is_gateway(cia407::TrainBusGatewayUnit& unit, Node& /*node*/) { gateway_ = &unit; }
  void send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value);

  const DeviceOutput& output_;
  cia407::TrainBusGatewayUnit* gateway_ = nullptr;
};

}  // namespace canvoy::tools
