// A whole panel with inputs and outputs: its dictionary, its node with all services, and both panel
// units.
//
//     constexpr auto my_panel = describe(panel<PanelOptions{.inputs = 2, .outputs = 4}>(),
//                                        cia301::identity({.vendor_id = 0x123}),
//                                        cia301::heartbeat_producer(1000));
//     constexpr auto layout = lay_out_device<my_panel>();
//
//     PanelDevice<layout> panel(port, 21, hardware, {.inputs = buttons}, {.outputs = lamps});
//     panel.node().start(now);
//     panel.inputs().set_level(0, true, now);
//
// For the inputs and outputs of a landing and a car, see LandingPanelDevice and CarPanelDevice.
#pragma once

#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/output_panel_device.hpp"
#include "canvoy/profiles/model/device_values.hpp"

namespace canvoy::cia417 {

/// `layout` has groups of inputs and outputs, a TPDO with 6010h and an RPDO with 6011h; `queue_max`
/// changes may wait for the bus; `own_routes` are as in DeviceNode.
template <const auto& layout, std::size_t queue_max = 16, std::size_t own_routes = 0>
class PanelDevice : public DeviceValues<PanelDevice<layout, queue_max, own_routes>, layout> {
 public:
  /// See InputPanelUnit and OutputPanelUnit. The context of `port`, and everything to which
  /// `hardware` refers, must outlive the device.
  PanelDevice(const Port& port, NodeId node_id, const OutputHardware& hardware,
              const InputPanelSettings& inputs, const OutputPanelSettings& outputs)
      : device_(port, node_id),
        inputs_(device_.node(), device_.tpdos(), arrays_.spans(), inputs),
        outputs_(device_.node(), states_, hardware, outputs) {}
  /// The same for hardware that is a plain class, whose members are found by their names.
  template <PlainHardware<OutputHardware> Plain>
  PanelDevice(const Port& port, NodeId node_id, Plain& hardware, const InputPanelSettings& inputs,
              const OutputPanelSettings& outputs)
      : PanelDevice(port, node_id, hardware_of<OutputHardware>(hardware), inputs, outputs) {}

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the inputs.
  InputPanelUnit& inputs() { return inputs_; }
  /// Behaviour of the inputs.
  const InputPanelUnit& inputs() const { return inputs_; }
  /// Behaviour of the outputs.
  OutputPanelUnit& outputs() { return outputs_; }
  /// Behaviour of the outputs.
  const OutputPanelUnit& outputs() const { return outputs_; }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  InputPanelArrays<layout, queue_max> arrays_;
  OutputStates<layout> states_{};
  InputPanelUnit inputs_;
  OutputPanelUnit outputs_;
};

}  // namespace canvoy::cia417
