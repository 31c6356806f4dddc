#include "canvoy/worlds/lift/shaft_sensors.hpp"

#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::lift {

namespace {

/// Setting of the TPDO of 6012h.
NodeValue sensor_pdo(NodeId id) {
  constexpr std::uint16_t parameter = 0x1981;
  constexpr std::uint32_t cob_id = 0x380;
  NodeValue value{
      .index = parameter, .sub = pdo_sub::cob_id, .bytes = std::vector<std::uint8_t>(4)};
  store(value.bytes.data(), cob_id + id);
  return value;
}

std::uint32_t number(cia417::SensorFunction sensor) {
  return static_cast<std::uint32_t>(cia417::sensor_number(sensor));
}

}  // namespace

ShaftSensors::ShaftSensors(World& world, SlotIndex slot, NodeId id, FloorNumber floor)
    : world_(&world),
      slot_(slot),
      floor_(floor),
      sensors_(cia417::sensors_at(1, floor)),
      device_(world.port(slot), id, {.sensors = sensors_}),
      values_{sensor_pdo(id)},
      configuration_(device_.node(), values_) {
  set_value(cia417::SensorFunction::temperature, room_temperature);
}

template <class Change>
void ShaftSensors::change(const Change& change_at) {
  change_at(world_->now());
  if (world_->is_running(slot_)) world_->touched(slot_);
}

void ShaftSensors::set_level(cia417::SensorFunction sensor, bool high) {
  change([&](Time now) { device_.unit().set_level(number(sensor), high, now); });
}

void ShaftSensors::set_value(cia417::SensorFunction sensor, std::int16_t value) {
  change([&](Time now) { device_.unit().set_value(number(sensor), value, now); });
}

void ShaftSensors::report(cia417::SensorFunction sensor, cia417::SensorSignal condition) {
  change([&](Time now) { device_.unit().report(number(sensor), condition, now); });
}

}  // namespace canvoy::lift
