// A whole sensor unit of CiA 417-4.
//
//     SensorUnitDevice<8> device(port, 30, {.sensors = sensors});
//     device.node().start(now);
//     device.unit().set_level(0, true, now);
#pragma once

#include <array>

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit.hpp"

namespace canvoy::cia417 {

namespace detail {

/// A base class, so that it is constructed before the unit.
template <std::size_t count>
struct SensorArrays {
  std::array<SensorState, count> states{};
  std::array<std::uint32_t, count> queue{};
};

}  // namespace detail

/// A sensor unit with its memory.
template <std::size_t count>
class OwnSensorUnit : private detail::SensorArrays<count>, public SensorUnit {
 public:
  /// Makes the unit; all arguments must outlive it.
  OwnSensorUnit(Node& node, Tpdos& tpdos, const SensorSettings& settings)
      : SensorUnit(node, tpdos, {this->states, this->queue}, settings) {}
};

/// A group of `sensors` with all their parameters, and a heartbeat every second. The PDO of 6012h
/// exists, and is invalid until it gets its COB-ID: 380h and the node-ID. A maker has a separate
/// description with its own identity.
template <std::uint8_t sensors, LiftDeviceOptions options = LiftDeviceOptions{}>
struct SensorKind : KindOf<SensorUnit, NoHardware, SensorSettings> {
  using ProfileBehaviour = BusBehaviour;  ///< it belongs to no single lift
  /// The unit for a dictionary, with memory for it.
  template <const auto& layout>
  using UnitOn = OwnSensorUnit<count_in_groups(layout.tables(), sensor_group_object.index)>;

  static constexpr DeviceInfo info = {.name = "lift-sensors",
                                      .title = "sensor unit: glass, smoke, damage, temperature",
                                      .product = "Canvoy CiA 417 sensor unit",
                                      .product_code = 41711,
                                      .node_id = 14,
                                      .hardware = "contacts and measured values"};
  static constexpr auto description = describe(
      lift_device<VirtualDevice::sensor_unit, options>(
          {0x6012, {0x6500, sensors}, {0x6520, sensors}, {0x6540, sensors}, {0x6560, sensors}}),
      lift_basics(info, 1000));

  template <class Made, class Services>
  static Made make(Services& services, const NoHardware& /*none*/, const SensorSettings& settings) {
    return Made(services.node(), services.tpdos(), settings);
  }
};

/// `layout` has a description with sensor groups and 6012h in a TPDO.
template <std::uint8_t sensors, LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = layout_of<SensorKind<sensors, options>>, std::size_t own_routes = 0>
using SensorUnitDevice = Device<SensorKind<sensors, options>, layout, own_routes>;

}  // namespace canvoy::cia417
