// Interface for hands that act behind a module, a device of a lift, a charger or a battery: on the
// plants of `canvoy device`, or on those of a simulated world.
//
//     class DeviceWires : public WiredThings { ... };
//     order.hand->act({.unit = &things, .now = now}, order.value);   // a WiredThings*
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/sim/plants/charging.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/door_plant.hpp"

namespace canvoy::tools {

/// Implementations override what their devices have; the rest returns false or null.
class WiredThings {
 public:
  WiredThings() = default;
  WiredThings(const WiredThings&) = delete;
  WiredThings& operator=(const WiredThings&) = delete;
  virtual ~WiredThings() = default;

  // Inputs of a module; both numbers count from 1.
  virtual bool set_input(unsigned /*number*/, bool /*is_on*/) { return false; }
  virtual bool set_analogue_input(unsigned /*number*/, std::int16_t /*value*/) { return false; }

  // A door and its light barrier.
  virtual bool set_door_fault(bool lift::DoorFaults::* /*fault*/, bool /*is_there*/, Time /*now*/) {
    return false;
  }
  virtual bool put_in_door(bool /*is_there*/, Time /*now*/) { return false; }
  virtual bool approach_door(bool /*is_near*/) { return false; }
  virtual bool touch_door(bool /*is_touched*/) { return false; }

  // A car.
  virtual bool set_load(double /*kilograms*/) { return false; }
  virtual bool break_rope_sensor(bool /*is_broken*/) { return false; }
  virtual lift::CarPlant* car() { return nullptr; }
  virtual bool open_safety_chain(bool /*is_open*/) { return false; }
  virtual bool catch_safety_gear(bool /*is_caught*/) { return false; }

  /// The button of a panel with this function.
  virtual bool press(cia417::BasicFunction /*function*/, std::uint8_t /*sub_function*/,
                     const HandValue& /*value*/, Time /*now*/) {
    return false;
  }
  virtual bool set_sensor(cia417::SensorFunction /*sensor*/, const HandValue& /*value*/,
                          Time /*now*/) {
    return false;
  }

  virtual ChargingPlant* charging() { return nullptr; }
};

}  // namespace canvoy::tools
