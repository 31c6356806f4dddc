// The emergency fresh-air system: reports its state, and takes no commands (606Ch; CiA 447-3,
// 4.2.6).
//
//     EmergencyFreshAirUnit air(network, {}, {});
//     air.switching().report(emergency_fresh_air_system_status, FreshAir::automatic_activated);
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

/// It starts with a self-test.
inline constexpr Rest fresh_air_rests[] = {
    rest(emergency_fresh_air_system_status, FreshAir::initialization, FreshAir::standby, 3s)};
inline constexpr SwitchedTable fresh_air_table = {.rests = fresh_air_rests};

/// The unit is its table.
using EmergencyFreshAirUnit = SwitchedUnit<fresh_air_table>;

/// Catalogue row of the emergency fresh-air system (4.2.6); car_unit makes it a part of a device.
struct EmergencyFreshAirKind : CarKind<EmergencyFreshAirUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "emergency-fresh-air",
                                      .title = "emergency fresh-air system",
                                      .product = "Canvoy CiA 447 fresh air",
                                      .product_code = 44703,
                                      .node_id = 9,
                                      .hardware = "fresh-air supply: what it does"};
  static constexpr const VirtualDeviceInfo& provides = emergency_fresh_air_system_device;
};

}  // namespace canvoy::cia447
