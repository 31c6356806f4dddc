// A whole call controller, without other functions: its dictionary, its node with all services, and
// its behaviour. Another device answers the calls; LiftControllerDevice is a controller with all of
// it.
//
//     CallControllerDevice<> device(port, 1, {.served = {FloorSet::between(1, 20)}}, lamps);
//     device.calls().on_change(...);
#pragma once

#include <array>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/call/call_panels.hpp"
#include "canvoy/devices/cia417/call/returned_panels.hpp"
#include "canvoy/devices/cia417/controller/lift_units.hpp"
#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417 {

/// Of the catalogue.
inline constexpr DeviceInfo call_controller_info = {.name = "lift-call-controller",
                                                    .title = "call controller",
                                                    .product = "Canvoy CiA 417 call controller",
                                                    .product_code = 41701,
                                                    .node_id = 1};

/// It receives panels with node-IDs up to 127, monitors the recommended ones (1016h), lists the
/// records of 254 outputs (6200h), and sends a heartbeat every 300 ms.
inline constexpr auto full_call_controller = describe(
    lift_device<VirtualDevice::call_controller, LiftDeviceOptions{}>(
        {0x6010, 0x6011, WantedObject{0x6200, last_of_many}}),
    virtual_input_rpdos<node_id_max>(), lift_basics(call_controller_info, 300),
    cia301::heartbeat_consumers(node_id_max), cia301::error_behavior().initial(1, keeps_state));
/// Tables of full_call_controller, for any of the 8 lifts.
inline constexpr auto full_call_controller_layout =
    in_any_lift(lay_out_device<full_call_controller>());

/// Like full_call_controller, but also receives panels by multiplexed PDOs, and lists no outputs.
template <MpdoMode mode>
inline constexpr auto multiplexed_call_controller = describe(
    lift_device<VirtualDevice::call_controller, LiftDeviceOptions{}>({0x6010, 0x6011}),
    virtual_input_rpdos<node_id_max>(), multiplexed_panels<mode, node_id_max>(),
    cia301::identity({.product_code = 41701}), cia301::sync_consumer(),
    cia301::heartbeat_producer(300), cia301::heartbeat_consumers(node_id_max), cia301::emergency(),
    cia301::error_history(8), cia301::error_behavior().initial(1, keeps_state));
/// Tables of multiplexed_call_controller.
template <MpdoMode mode>
inline constexpr auto multiplexed_call_controller_layout =
    lay_out_device<multiplexed_call_controller<mode>>();

/// `destinations` is the maximum number of waiting destination calls.
template <const auto& layout = full_call_controller_layout,
          std::size_t destinations = destinations_default, std::size_t own_routes = 0>
class CallControllerDevice
    : public DeviceValues<CallControllerDevice<layout, destinations, own_routes>, layout> {
 public:
  /// `outputs` are those of the panels that 6200h lists; they must outlive the device.
  CallControllerDevice(const Port& port, NodeId node_id, const CallControllerSettings& settings,
                       std::span<const VirtualOutput> outputs = {})
      : lift_(settings.lift),
        device_(port, node_id),
        client_(node()),
        calls_(node(), device_.tpdos(), destinations_, settings),
        panels_(node(), calls_, outputs),
        returned_(node(), client_, calls_) {
    device_.heartbeat_consumer().on_change(callback<&ReturnedPanels::heard>(returned_));
    node().on_defaults_restored(callback<&CallControllerDevice::restored>(*this));
  }

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Behaviour of the call controller.
  CallController& calls() { return calls_; }
  /// Behaviour of the call controller.
  const CallController& calls() const { return calls_; }

 private:
  void restored(ResetScope scope) {
    panels_.use(node_id_max);
    watch(node().dictionary(), panels_alone);
    if (scope == ResetScope::communication) return;
    node().dictionary().set_number(lift_number_object.index, 0, lift_bit(lift_));
  }

  /// It uses no unit.
  static constexpr LiftUnits panels_alone{
      .drive = 0, .position_unit = 0, .door_units = {}, .load_unit = 0};

  unsigned lift_;  ///< after power-on
  DeviceNode<layout, 1 + own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  LiftNumber lift_number_{device_.node(),
                          {.changed = callback<&CallController::set_lift_mask>(calls_)}};
  std::array<CallController::Destination, destinations> destinations_;
  SdoClient client_;
  CallController calls_;
  CallPanels<layout> panels_;
  ReturnedPanels returned_;
  GapWatch gaps_{node(), callback<&ReturnedPanels::ask_anew>(returned_)};
};

}  // namespace canvoy::cia417
