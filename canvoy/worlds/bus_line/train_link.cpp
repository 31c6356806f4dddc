#include "canvoy/worlds/bus_line/train_link.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::bus_line {

cia407::TrainBusGatewayHardware TrainLink::first_hardware() {
  return {.send = Callback<void(std::uint16_t, std::uint8_t,
                                std::span<const std::uint8_t>)>::to<&TrainLink::send>(*this)};
}

cia407::TrainBusGatewayHardware TrainLink::following_hardware() {
  return {.send = Callback<void(std::uint16_t, std::uint8_t,
                                std::span<const std::uint8_t>)>::to<&TrainLink::send_back>(*this)};
}

bool TrainLink::press_stop_button(unsigned car) {
  const End& end = ends_.at(car - 1);
  bool is_taken = false;
  end.node->with([&] { is_taken = end.unit->press_stop_button(); });
  return is_taken;
}

void TrainLink::step(Time now) {
  const bool is_alive = !is_cut_ && first().node->is_operational();
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
  const Dictionary& dictionary = first().node->node().dictionary();
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
  for (const End& end : std::span(ends_).subspan(1)) {
    if (end.node != nullptr) hand_over(all, false, end);
  }
  hand_over(all, true, first());
}

/// Passes on the values of this direction.
void TrainLink::hand_over(std::span<const Value> values, bool is_back, const End& end) {
  if (std::ranges::find(values, is_back, &Value::is_back) == values.end()) return;
  end.node->with([&] {
    for (const Value& value : values) {
      if (value.is_back == is_back) end.unit->receive(value.index, value.sub, value.bytes);
    }
  });
}

}  // namespace canvoy::bus_line
