#include "canvoy/sim/bus/train_link.hpp"

#include <utility>

namespace canvoy::bus {

cia407::TrainBusGatewayHardware TrainLink::hardware() {
  return {.send = Callback<void(std::uint16_t, std::uint8_t,
                                std::span<const std::uint8_t>)>::to<&TrainLink::send>(*this)};
}

void TrainLink::step(Time now) {
  const bool is_alive = !is_cut_ && first_->is_operational();
  if (is_alive) heard_ = now;
  // Who was not heard for a time tells all that it has.
  if (!std::exchange(was_alive_, is_alive) && is_alive) send_all();
}

void TrainLink::send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
  if (is_cut_) return;
  const Time due = world_.now() + delay;
  under_way_.push_back({due, index, sub, {value.begin(), value.end()}});
  world_.at(due, [this](Time now) { arrive(now); });
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

/// What was sent at one time arrives at one time.
void TrainLink::arrive(Time now) {
  std::vector<Value> all;
  while (!under_way_.empty() && under_way_.front().due <= now) {
    all.push_back(std::move(under_way_.front()));
    under_way_.pop_front();
  }
  if (all.empty() || is_cut_) return;
  second_->with([&] {
    for (const Value& value : all) second_unit_->receive(value.index, value.sub, value.bytes);
  });
}

}  // namespace canvoy::bus
