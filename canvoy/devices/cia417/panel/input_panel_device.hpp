// A whole input panel: its dictionary, its node with all services, and its input panel unit.
//
//     constexpr auto my_panel = describe(
//         lift_device<VirtualDevice::input_panel_unit>({{0x6100, 4}, {0x6120, 4}}),
//         cia301::identity({.vendor_id = 0x123}), cia301::emergency(), ...);
//     constexpr auto layout = lay_out_device<my_panel>();
//     InputPanelDevice<layout> panel(port, 21, {.inputs = buttons});
//     panel.node().start(now);
//     panel.unit().set_level(0, true, now);
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417 {

/// The memory of an input panel unit for all inputs of a dictionary, and `queue_max` changes that
/// wait for the bus.
template <const auto& layout, std::size_t queue_max = 16>
struct InputPanelArrays {
  /// One for each input.
  std::array<InputState, count_in_groups(layout.tables(), input_group_object.index)> states{};
  std::array<std::uint32_t, queue_max> queue{};  ///< of inputs that wait

  /// For InputPanelUnit; valid as long as this object.
  InputPanelMemory spans() { return {states, queue}; }
};

/// `layout` has input groups and a TPDO with 6010h; `own_routes` are as in DeviceNode.
template <const auto& layout, std::size_t queue_max = 16, std::size_t own_routes = 0>
class InputPanelDevice
    : public DeviceValues<InputPanelDevice<layout, queue_max, own_routes>, layout> {
 public:
  /// See InputPanelUnit. The context of `port` must outlive the device.
  InputPanelDevice(const Port& port, NodeId node_id, const InputPanelSettings& settings)
      : device_(port, node_id), unit_(device_.node(), device_.tpdos(), arrays_.spans(), settings) {}

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the inputs.
  InputPanelUnit& unit() { return unit_; }
  /// Behaviour of the inputs.
  const InputPanelUnit& unit() const { return unit_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  InputPanelArrays<layout, queue_max> arrays_;
  InputPanelUnit unit_;
};

}  // namespace canvoy::cia417
