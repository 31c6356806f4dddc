#include "canvoy/tools/device/bus/train_bus.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::tools {

namespace {

constexpr std::size_t relayed_value_max = 4;

}  // namespace

void TrainBus::join(Environment& environment) {
  using cia407::TrainBusGatewayHardware, cia407::TrainBusGatewayUnit;
  environment.provide(Callback<TrainBusGatewayHardware()>::to<&TrainBus::hardware>(*this));
  environment.watch(Callback<void(TrainBusGatewayUnit&, Node&)>::to<&TrainBus::is_gateway>(*this));
}

/// In the number of bytes of the object.
void TrainBus::act(const BusPress& press, Node& node) {
  if (press.what != "from-train") return;
  const auto index = static_cast<std::uint16_t>(press.number("index").value_or(0));
  const auto sub = static_cast<std::uint8_t>(press.number("sub").value_or(0));
  std::array<std::uint8_t, relayed_value_max> bytes{};
  store(bytes.data(), press.number("value").value_or(0));
  const Result<Entry> entry = node.dictionary().find(index, sub);
  const bool is_taken =
      entry && entry->bytes().size() <= bytes.size() &&
      gateway_->receive(index, sub, std::span(bytes).first(entry->bytes().size()));
  if (!is_taken) {
    output_.say("train-bus-gateway",
                fmt::format("{:04X}h:{:02X}h is none that it tells here", index, sub));
  }
}

cia407::TrainBusGatewayHardware TrainBus::hardware() {
  return {.send = Callback<void(std::uint16_t, std::uint8_t,
                                std::span<const std::uint8_t>)>::to<&TrainBus::send>(*this)};
}

void TrainBus::send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
  output_.say("train-bus-gateway", fmt::format("to the train: {:04X}h:{:02X}h = {:02X}", index, sub,
                                               fmt::join(value, " ")));
}

}  // namespace canvoy::tools
