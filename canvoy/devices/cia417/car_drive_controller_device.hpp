// A whole car drive controller of CiA 417-4: its dictionary, its node with all services, and its
// behaviour. A lift controller has a CarDriveController of its own beside its other virtual
// devices.
//
//     CarDriveControllerDevice<> drive(port, 1);
//     drive.controller().travel_to(12'500'000);
//
// Overspeed, unintended car movement, and what else makes a trip unsafe stop the drive fast and
// hold it while a node tells of them that 1028h names (see UnitErrors): by default drive and
// position unit.
#pragma once

#include <utility>

#include "canvoy/canopen/device_node.hpp"
#include "canvoy/devices/cia417/bus_warning.hpp"
#include "canvoy/devices/cia417/car_drive_controller.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/devices/cia417/unit_errors.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/layout.hpp"

namespace canvoy::cia417 {

/// What a drive and a position unit tell, a heartbeat each 300 ms, these two watched, and room to
/// hear the emergencies of all nodes.
template <LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_car_drive_controller = describe(
    lift_device<VirtualDevice::car_drive_controller, options>(
        {0x6383, 0x6400, 0x6401, 0x6403, 0x6404, 0x6406, 0x6420, 0x6430, 0x6431, 0x6432, 0x6433}),
    cia301::identity({.product_code = 41708}),
    cia301::names({.device = "Canvoy CiA 417 drive controller",
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::sync_consumer(), cia301::heartbeat_producer(300), watched_nodes<1500, 2, 4, 0, 0>,
    cia301::emergency(), cia301::emergency_consumers(node_id_max), cia301::error_history(8),
    cia301::error_behavior().initial(1, keeps_state));
template <LiftDeviceOptions options = LiftDeviceOptions{}>
inline constexpr auto full_car_drive_controller_layout =
    in_any_lift(lay_out_device<full_car_drive_controller<options>>());

/// `layout` is that of a description with the objects of a car drive controller for `options`.
template <LiftDeviceOptions options = LiftDeviceOptions{},
          const auto& layout = full_car_drive_controller_layout<options>,
          std::size_t own_routes = 0>
class CarDriveControllerDevice {
 public:
  /// The lift in `settings` is that of `options`.
  CarDriveControllerDevice(const Port& port, NodeId node_id,
                           const CarDriveControllerSettings& settings = {})
      : device_(port, node_id),
        client_(device_.node()),
        register_client_(device_.node()),
        controller_(device_.node(),
                    {.rpdos = &device_.rpdos(), .tpdos = &device_.tpdos(), .client = &client_},
                    settings_of(settings)),
        units_(units_of(settings)),
        errors_(device_.node(), device_.emergency_consumer(), register_client_, units_) {
    using Self = CarDriveControllerDevice;
    errors_.on_change(Callback<void()>::template to<&Self::errors_changed>(*this));
    device_.heartbeat_consumer().on_change(
        Callback<void(NodeId, RemoteState)>::template to<&Self::unit_changed>(*this));
    node().on_defaults_restored(Callback<void(ResetScope)>::template to<&Self::restored>(*this));
  }

  Node& node() { return device_.node(); }
  const Node& node() const { return device_.node(); }
  CarDriveController& controller() { return controller_; }
  const CarDriveController& controller() const { return controller_; }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  static constexpr CarDriveControllerSettings settings_of(CarDriveControllerSettings settings) {
    settings.lift = options.lift;
    return settings;
  }

  /// It commands the drive alone: no door, no load.
  static constexpr LiftUnits units_of(const CarDriveControllerSettings& settings) {
    return {.drive = settings.drive,
            .position_unit = settings.position_unit,
            .door_units = {},
            .load_unit = 0,
            .others = {}};
  }
  void restored(ResetScope) { watch(node().dictionary(), units_); }
  void lift_changed(std::uint8_t lift) {
    if (std::exchange(lift_, lift) != lift) controller_.begin_anew();
  }
  void unit_changed(NodeId unit, RemoteState state) {
    if (state == RemoteState::boot_up) errors_.booted(unit);
    controller_.heard(unit, state);
  }
  void errors_changed() { controller_.hold(errors_.has_any_error()); }

  std::uint8_t lift_ = lift_bit(options.lift);
  DeviceNode<layout, own_routes + 2> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{
      device_.node(),
      {.refuses = Callback<AbortCode()>::to<&CarDriveController::refuses_lift_number>(controller_),
       .changed =
           Callback<void(std::uint8_t)>::template to<&CarDriveControllerDevice::lift_changed>(
               *this)}};
  SdoClient client_;
  SdoClient register_client_;
  CarDriveController controller_;
  LiftUnits units_;
  UnitErrors errors_;
};

}  // namespace canvoy::cia417
