// A whole car drive controller of CiA 417-4. A lift controller has a separate CarDriveController
// beside its other virtual devices.
//
//     CarDriveControllerDevice<> drive(port, 1);
//     drive.unit().controller().travel_to(12'500'000);
//
// Overspeed, unintended car movement, and other errors that make a trip unsafe stop the drive fast
// and hold it while a node in 1028h reports them (see UnitErrors): by default drive and position
// unit.
//
// After a sign of lost frames (GapWatch), the state of both is requested.
#pragma once

#include <utility>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/controller/unit_errors.hpp"
#include "canvoy/devices/cia417/drive/car_drive_controller.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// A controller without other functions, and the errors to which it reacts.
class LoneDriveController {
 public:
  /// Makes the controller with the services of its node, which must outlive it.
  template <class Services>
  LoneDriveController(Services& services, const CarDriveControllerSettings& settings)
      : client_(services.node()),
        register_client_(services.node()),
        controller_(services.node(),
                    {.rpdos = &services.rpdos(), .tpdos = &services.tpdos(), .client = &client_},
                    settings),
        units_(units_of(settings)),
        errors_(services.node(), services.emergency_consumer(), register_client_, units_),
        dictionary_(services.node().dictionary()),
        lift_(lift_bit(settings.lift)),
        gaps_(services.node(), callback<&LoneDriveController::ask_anew>(*this)) {
    using Self = LoneDriveController;
    errors_.on_emergency(callback<&Self::told>(*this));
    errors_.on_change(callback<&Self::errors_changed>(*this));
    services.heartbeat_consumer().on_change(callback<&Self::unit_changed>(*this));
    services.node().on_defaults_restored(callback<&Self::restored>(*this));
  }

  /// Behaviour of the controller.
  CarDriveController& controller() { return controller_; }
  /// Behaviour of the controller.
  const CarDriveController& controller() const { return controller_; }

  /// Refuses while a car moves.
  AbortCode refuses_lift_number() { return controller_.refuses_lift_number(); }
  /// Call it when 6001h was written or restored.
  void lift_changed(std::uint8_t lift) {
    if (std::exchange(lift_, lift) != lift) controller_.begin_anew();
  }

 private:
  /// It commands only the drive: no door, no load.
  static constexpr LiftUnits units_of(const CarDriveControllerSettings& settings) {
    return {.drive = settings.drive,
            .position_unit = settings.position_unit,
            .door_units = {},
            .load_unit = 0,
            .others = {}};
  }
  void restored(ResetScope) { watch(dictionary_, units_); }
  void unit_changed(NodeId unit, RemoteState state) {
    if (state == RemoteState::boot_up) errors_.booted(unit);
    controller_.heard(unit, state);
  }
  void told(NodeId unit, const Emergency& emergency) { gaps_.heard(unit, emergency); }
  void ask_anew(NodeId /*unit*/) {
    controller_.ask_anew();
    errors_.ask_anew();
  }
  void errors_changed() { controller_.hold(errors_.has_any_error()); }

  SdoClient client_;
  SdoClient register_client_;
  CarDriveController controller_;
  LiftUnits units_;
  UnitErrors errors_;
  Dictionary& dictionary_;
  std::uint8_t lift_;
  GapWatch gaps_;
};

/// The messages of a drive and a position unit, a heartbeat every 300 ms, these two monitored, and
/// room to receive the emergencies of all nodes.
template <LiftDeviceOptions options = LiftDeviceOptions{}>
struct CarDriveControllerKind
    : LiftKind<LoneDriveController, NoHardware, CarDriveControllerSettings> {
  static constexpr DeviceInfo info = {.name = "lift-drive-controller",
                                      .title = "car drive controller",
                                      .product = "Canvoy CiA 417 drive controller",
                                      .product_code = 41708,
                                      .node_id = 1};
  static constexpr auto description = describe(
      lift_device<VirtualDevice::car_drive_controller, options>(
          {0x6383, 0x6400, 0x6401, 0x6403, 0x6404, 0x6406, 0x6420, 0x6430, 0x6431, 0x6432, 0x6433}),
      lift_basics(info, 300), watched_nodes<1500, 2, 4, 0, 0>,
      cia301::emergency_consumers(node_id_max), cia301::error_behavior().initial(1, keeps_state));
  static constexpr std::size_t routes = 2;  ///< one for each SDO client

  /// The lift is that of `options`.
  static constexpr CarDriveControllerSettings fit(CarDriveControllerSettings settings) {
    settings.lift = options.lift;
    return settings;
  }
  template <class Made, class Services>
  static Made make(Services& services, const NoHardware& /*none*/,
                   const CarDriveControllerSettings& settings) {
    return Made(services, settings);
  }
};

/// `layout` has a description with the objects of a car drive controller for `options`.
template <LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = layout_of<CarDriveControllerKind<options>>,
          std::size_t own_routes = 0>
using CarDriveControllerDevice = Device<CarDriveControllerKind<options>, layout, own_routes>;

}  // namespace canvoy::cia417
