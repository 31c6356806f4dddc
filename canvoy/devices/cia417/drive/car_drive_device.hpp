// A whole car drive unit of CiA 417-4.
//
//     CarDriveDevice<> drive(port, 2, hardware);
//     drive.node().start(now);
#pragma once

#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

namespace detail {

/// A copy of the device with another power-on value of an object of lift `lift`.
template <std::size_t capacity>
constexpr DeviceDescription<capacity> with_initial(const DeviceDescription<capacity>& device,
                                                   unsigned lift, const ObjectInfo& object,
                                                   unsigned sub, Default value) {
  const Part* part = device.find(object.index + (lift - 1) * block_pitch);
  return device.with(part->initial(sub, value));
}

/// Millimetres, mm/s, mm/s2 and mm/s3, ten increments to the millimetre, 1.6 m/s.
template <std::size_t capacity>
constexpr DeviceDescription<capacity> with_drive_defaults(DeviceDescription<capacity> device,
                                                          unsigned lift) {
  struct Value {
    const ObjectInfo* object;
    std::uint8_t sub;
    std::int64_t value;
  };
  constexpr std::int64_t milli = -3;
  constexpr std::int64_t metre = 0x01;
  constexpr Value values[] = {{&modes_of_operation_object, 0, 1},
                              {&modes_of_operation_display_object, 0, 1},
                              {&motion_profile_type_object, 0, 3},
                              {&max_velocity_object, 1, 1600},
                              {&max_acceleration_object, 1, 2000},
                              {&max_acceleration_object, 2, 2000},
                              {&quick_stop_deceleration_object, 0, 2000},
                              {&profile_acceleration_object, 1, 1000},
                              {&profile_acceleration_object, 2, 1000},
                              {&profile_jerk_use_object, 0, 1},
                              {&profile_jerk_object, 1, 1200},
                              {&position_dimension_object, 1, milli},
                              {&position_dimension_object, 2, metre},
                              {&velocity_dimension_object, 1, milli},
                              {&acceleration_dimension_object, 1, milli},
                              {&jerk_dimension_object, 1, milli},
                              {&position_encoder_resolution_object, 1, 10'000},
                              {&velocity_encoder_resolution_object, 1, 10'000},
                              {&feed_constant_object, 1, 1000},
                              {&profile_velocity_object, 0, 1600},
                              {&velocity_window_object, 1, 20},
                              {&velocity_window_object, 2, 50},
                              {&velocity_threshold_object, 1, 10},
                              {&velocity_threshold_object, 2, 50},
                              {&max_slippage_object, 0, 200}};
  for (const Value& value : values) {
    device = with_initial(device, lift, *value.object, value.sub, value.value);
  }
  return device;
}

}  // namespace detail

/// Every object of a drive, a heartbeat every 500 ms, a monitored controller, and room to receive
/// the emergencies of node-IDs 1 to 20.
template <unsigned lift = 1>
struct CarDriveKind : LiftKind<CarDriveUnit, CarDriveHardware, CarDriveSettings> {
  static constexpr DeviceInfo info = {.name = "lift-drive",
                                      .title = "car drive unit",
                                      .product = "Canvoy CiA 417 car drive unit",
                                      .product_code = 41709,
                                      .node_id = 2,
                                      .hardware = "a converter with its motor, brake and encoder"};
  static constexpr auto description = detail::with_drive_defaults(
      describe(lift_device<VirtualDevice::car_drive_unit, LiftDeviceOptions{.lift = lift}>(
                   {0x6400, 0x6401, 0x6402, 0x6403, 0x6404, 0x6405, 0x6406,     0x6408, 0x6409,
                    0x640A, 0x640B, 0x640C, 0x640D, 0x6410, 0x6411, 0x6412,     0x6413, 0x6414,
                    0x6415, 0x6416, 0x6417, 0x6418, 0x6419, 0x641A, 0x641B,     0x641C, 0x641D,
                    0x641E, 0x6420, 0x6421, 0x6422, 0x6423, 0x6424, 0x6428,     0x6430, 0x6431,
                    0x6432, 0x6433, 0x6434, 0x6435, 0x6436, 0x6437, {0x6438, 2}}),
               lift_basics(info, 500), watched_nodes<1000, 1, 0>, cia301::emergency_consumers(20),
               cia301::error_behavior().initial(1, keeps_state)),
      lift);
  static constexpr std::size_t routes = 4;  ///< for the boot-up of nodes that hold the drive

  template <class Made, class Services>
  static Made make(Services& services, const CarDriveHardware& hardware,
                   const CarDriveSettings& settings) {
    return Made(services.node(), {.emergencies = &services.emergency_consumer()}, hardware,
                settings);
  }
};

/// `layout` has a description with a car drive unit of lift `settings.lift`, and 1028h.
template <const auto& layout = layout_of<CarDriveKind<>>, std::size_t own_routes = 0>
using CarDriveDevice = Device<CarDriveKind<>, layout, own_routes>;

}  // namespace canvoy::cia417
