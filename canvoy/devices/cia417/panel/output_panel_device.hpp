// A whole output panel: its dictionary, its node with all services, and its output panel unit.
//
//     constexpr auto my_panel = describe(panel<PanelOptions{.outputs = 4}>(),
//                                        cia301::identity({.vendor_id = 0x123}),
//                                        cia301::heartbeat_producer(1000));
//     constexpr auto layout = lay_out_device<my_panel>();
//
//     OutputPanelDevice<layout> panel(port, 21, hardware, {.outputs = lamps});
//     panel.node().start(now);
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/panel/output_panel_unit.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"
#include "canvoy/devices/kit/plain_hardware.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417 {

/// The memory of an output panel unit for all outputs of a dictionary.
template <const auto& layout>
using OutputStates =
    std::array<OutputState, count_in_groups(layout.tables(), output_group_object.index)>;

/// `layout` has output groups and an RPDO with 6011h; `own_routes` are as in DeviceNode.
template <const auto& layout, std::size_t own_routes = 0>
class OutputPanelDevice : public DeviceValues<OutputPanelDevice<layout, own_routes>, layout> {
 public:
  /// See OutputPanelUnit. The context of `port`, and everything to which `hardware` refers, must
  /// outlive the device.
  OutputPanelDevice(const Port& port, NodeId node_id, const OutputHardware& hardware,
                    const OutputPanelSettings& settings)
      : device_(port, node_id), unit_(device_.node(), states_, hardware, settings) {}
  /// The same for hardware that is a plain class, whose members are found by their names.
  template <PlainHardware<OutputHardware> Plain>
  OutputPanelDevice(const Port& port, NodeId node_id, Plain& hardware,
                    const OutputPanelSettings& settings)
      : OutputPanelDevice(port, node_id, hardware_of<OutputHardware>(hardware), settings) {}

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the outputs.
  OutputPanelUnit& unit() { return unit_; }
  /// Behaviour of the outputs.
  const OutputPanelUnit& unit() const { return unit_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  OutputStates<layout> states_{};
  OutputPanelUnit unit_;
};

}  // namespace canvoy::cia417
