#include "canvoy/worlds/bus_line/second_car.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::bus_line {

cia407::TrainBusGatewayHardware TrainLink::first_hardware() {
  return {.send = callback<&TrainLink::send>(*this)};
}

cia407::TrainBusGatewayHardware TrainLink::second_hardware() {
  return {.send = callback<&TrainLink::send_back>(*this)};
}

bool TrainLink::press_stop_button() {
  bool is_taken = false;
  second_->with([&] { is_taken = second_unit_->press_stop_button(); });
  return is_taken;
}

void TrainLink::step(Time now) {
  const bool is_alive = !is_cut_ && first_->is_operational();
  if (is_alive) heard_ = now;
  // After a silence, all data are sent.
  if (!std::exchange(was_alive_, is_alive) && is_alive) send_all();
}

void TrainLink::send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
  put({.index = index, .sub = sub, .bytes = {value.begin(), value.end()}});
}

void TrainLink::send_back(std::uint16_t index, std::uint8_t sub,
                          std::span<const std::uint8_t> value) {
  put({.is_back = true, .index = index, .sub = sub, .bytes = {value.begin(), value.end()}});
}

void TrainLink::put(Value value) {
  if (is_cut_) return;
  value.due = world_.now() + delay;
  world_.at(value.due, [this](Time now) { arrive(now); });
  under_way_.push_back(std::move(value));
}

void TrainLink::send_all() {
  const Dictionary& dictionary = first_->node().dictionary();
  for (const DeviceObject& object : cia407::train_bus_gateway.objects) {
    constexpr unsigned subs_max = 0xFE;
    for (unsigned sub = 0; sub <= subs_max; ++sub) {
      const auto entry = dictionary.find(object.index, static_cast<std::uint8_t>(sub));
      if (!entry || entry->row->type == DataType::domain) continue;
      send(object.index, static_cast<std::uint8_t>(sub), entry->bytes());
    }
  }
}

/// Values that were sent at one time arrive at one time.
void TrainLink::arrive(Time now) {
  std::vector<Value> all;
  while (!under_way_.empty() && under_way_.front().due <= now) {
    all.push_back(std::move(under_way_.front()));
    under_way_.pop_front();
  }
  if (all.empty() || is_cut_) return;
  hand_over(all, false, *second_, second_unit_);
  hand_over(all, true, *first_, first_unit_);
}

/// Passes on the values of this direction.
void TrainLink::hand_over(std::span<const Value> values, bool is_back, BusNode& node,
                          cia407::TrainBusGatewayUnit* unit) {
  if (std::ranges::find(values, is_back, &Value::is_back) == values.end()) return;
  node.with([&] {
    for (const Value& value : values) {
      if (value.is_back == is_back) unit->receive(value.index, value.sub, value.bytes);
    }
  });
}

void SecondCar::add_nodes() {
  using namespace cia407;
  Environment& first = nodes_.add_site();
  first.provide(callback<&TrainLink::first_hardware>(train_));
  first.watch(callback<&TrainLink::is_first>(train_));
  nodes_.add(train_gateway_id, first);
  Environment& second = nodes_.add_site();
  second.provide(callback<&SecondCar::segment>(*this));
  second.provide(callback<&TrainLink::second_hardware>(train_));
  second.provide(callback<&SecondCar::mirror_hardware>(*this));
  second.provide(callback<&SecondCar::mirror_settings>(*this));
  second.watch(callback<&TrainLink::is_second>(train_));
  nodes_.add(second_gateway_id, second);
  train_.join(nodes_.node(train_gateway_id), nodes_.node(second_gateway_id));
}

MirrorControlHardware SecondCar::mirror_hardware() {
  return {.is_coupled = callback<&TrainLink::is_coupled>(train_)};
}

MirrorControlSettings SecondCar::mirror_settings() {
  MirrorControlSettings settings{
      .nodes = {second_destination_id, second_next_stop_id, second_announcer_id},
      .displays = {{second_destination_id, DisplayUse::destination},
                   {second_next_stop_id, DisplayUse::next_stop}}};
  for (const AddedDevice& added : nodes_.design().added) {
    if (added.car == 2) settings.nodes.push_back(added.id);
  }
  return settings;
}

}  // namespace canvoy::bus_line
