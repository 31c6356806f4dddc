// A whole car door controller of CiA 417-4. A lift controller has a separate CarDoorController
// beside its other virtual devices.
//
//     CarDoorControllerDevice<> doors(port, 1, {.doors = 0b0011});
//     doors.unit().open(0b01);
#pragma once

#include "canvoy/devices/cia417/door/car_door_controller.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// A controller without other functions. After a sign of lost frames it requests the state of its
/// doors.
class LoneDoorController : public CarDoorController {
 public:
  /// Makes the controller; all arguments must outlive it.
  LoneDoorController(Node& node, const CarDoorControllerSettings& settings, Rpdos& rpdos)
      : CarDoorController(node, settings, &rpdos),
        gaps_(node, callback<&LoneDoorController::ask_all>(*this)) {}

 private:
  void ask_all(NodeId /*door*/) { ask_anew(); }

  GapWatch gaps_;
};

/// Every object of the virtual device, a heartbeat every 300 ms, three monitored doors, and room to
/// monitor all possible nodes.
template <LiftDeviceOptions options = LiftDeviceOptions{}>
struct CarDoorControllerKind : LiftKind<LoneDoorController, NoHardware, CarDoorControllerSettings> {
  static constexpr DeviceInfo info = {.name = "lift-door-controller",
                                      .title = "car door controller",
                                      .product = "Canvoy CiA 417 door controller",
                                      .product_code = 41704,
                                      .node_id = 1};
  static constexpr auto description = describe(
      lift_device<VirtualDevice::car_door_controller, options>({0x6300, 0x6301, 0x6302, 0x6310}),
      lift_basics(info, 300), watched_nodes<1500, 6, 7, 8, 0, 0, 0, 0, 0>,
      cia301::error_behavior().initial(1, keeps_state));

  /// The lift is that of `options`.
  static constexpr CarDoorControllerSettings fit(CarDoorControllerSettings settings) {
    settings.lift = options.lift;
    return settings;
  }
  template <class Made, class Services>
  static Made make(Services& services, const NoHardware& /*none*/,
                   const CarDoorControllerSettings& settings) {
    return Made(services.node(), settings, services.rpdos());
  }
  template <class Services>
  static void connect(Services& services, CarDoorController& controller) {
    services.heartbeat_consumer().on_change(callback<&CarDoorController::heard>(controller));
  }
};

/// `layout` has a description with the objects of a car door controller for `options`.
template <LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = layout_of<CarDoorControllerKind<options>>,
          std::size_t own_routes = 0>
using CarDoorControllerDevice = Device<CarDoorControllerKind<options>, layout, own_routes>;

}  // namespace canvoy::cia417
