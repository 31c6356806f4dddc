// A lift of four floors, for tests of lift controllers.
//
//     DeviceOnCable<LiftControllerDevice<>> sut(NodeId{1}, lift_of_four_floors());
#pragma once

#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"

namespace canvoy::cia417 {

inline constexpr std::int32_t four_floors[] = {0, 4'000'000, 7'000'000, 10'000'000};

inline LiftControllerDeviceSettings lift_of_four_floors(
    std::span<const VirtualOutput> outputs = {}) {
  return {.calls = {.served = {FloorSet::between(1, 4)}},
          .lift = {.floors = four_floors},
          .outputs = outputs};
}

}  // namespace canvoy::cia417
