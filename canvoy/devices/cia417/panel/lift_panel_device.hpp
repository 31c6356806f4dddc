// Complete panels of a lift: of a landing, or several landings in one device, and of a car.
//
//     LandingPanelDevice<> landing(port, 23, hardware, {.floor = 3, .highest_floor = 10});
//     CarPanelDevice<> car(port, 16, hardware, {.highest_floor = 10});
//     landing.node().start(now);
//     landing.inputs().set_level(0, true, now);   // up, or the first that there is
//     landing.outputs().view(0).on;               // its lamp
//
// lift_panels.hpp describes their inputs and outputs and the order of these. They send a heartbeat
// every second, and their PDOs have the CAN-IDs of part 3 from power-on on.
#pragma once

#include <array>

#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/panel/lift_panels.hpp"
#include "canvoy/devices/cia417/panel/panel_device.hpp"
#include "canvoy/profiles/model/device_values.hpp"

namespace canvoy::cia417 {

/// Size of a panel of landings.
struct LandingPanelOptions {
  unsigned panels = 1;        ///< number of landings
  unsigned destinations = 0;  ///< number of buttons for floors at each; 0: up and down
  /// See PanelOptions.
  bool low_pdo_numbers = false;

  /// Inputs that such a panel needs.
  constexpr std::uint16_t inputs() const {
    const std::size_t each = landing_inputs_max(destinations, destinations != 0);
    return static_cast<std::uint16_t>(panels * each);
  }
  /// Outputs that such a panel needs.
  constexpr std::uint16_t outputs() const {
    const std::size_t each = landing_outputs_max(destinations, destinations != 0);
    return static_cast<std::uint16_t>(panels * each);
  }
};
/// Size of a panel of a car.
struct CarPanelOptions {
  unsigned floors = 64;          ///< maximum number of floors
  bool low_pdo_numbers = false;  ///< TPDO 1 and RPDO 1 in place of the profile's

  /// Inputs that such a panel needs.
  constexpr std::uint16_t inputs() const {
    return static_cast<std::uint16_t>(car_inputs_max(floors));
  }
  /// Outputs that such a panel needs.
  constexpr std::uint16_t outputs() const {
    return static_cast<std::uint16_t>(car_outputs_max(floors));
  }
};

/// Of the catalogue.
inline constexpr DeviceInfo landing_panel_info = {.name = "lift-landing-panel",
                                                  .title = "panel of a landing: buttons, lamps",
                                                  .product = "Canvoy CiA 417 panel",
                                                  .product_code = 41703,
                                                  .node_id = 21,
                                                  .hardware = "buttons, lamps, displays, a gong"};
/// Of the catalogue: the same product in a car.
inline constexpr DeviceInfo car_panel_info = {.name = "lift-car-panel",
                                              .title = "panel of a car: buttons, keys, lamps",
                                              .product = landing_panel_info.product,
                                              .product_code = landing_panel_info.product_code,
                                              .node_id = 16,
                                              .hardware = landing_panel_info.hardware};

/// All parameters; identity and heartbeat. A maker has a separate description.
template <auto options>
inline constexpr auto full_lift_panel =
    describe(panel<PanelOptions{.inputs = options.inputs(),
                                .outputs = options.outputs(),
                                .low_pdo_numbers = options.low_pdo_numbers}>(),
             lift_basics(landing_panel_info, 1000, 4));
/// Tables of full_lift_panel.
template <auto options>
inline constexpr auto full_lift_panel_layout = lay_out_device<full_lift_panel<options>>();

/// The number of inputs and outputs, known at compile time.
template <auto options>
class LiftPanelRecords {
 public:
  /// Records of a car panel.
  explicit LiftPanelRecords(const CarPanel& panel)
      : inputs_used_(car_inputs(panel, inputs_)), outputs_used_(car_outputs(panel, outputs_)) {}
  /// Records of the panel of one landing.
  explicit LiftPanelRecords(const LandingPanel& panel) : LiftPanelRecords(std::span(&panel, 1)) {}
  /// Records of the panels of several landings.
  explicit LiftPanelRecords(std::span<const LandingPanel> panels) {
    std::size_t inputs = 0;
    std::size_t outputs = 0;
    for (const LandingPanel& panel : panels) {
      inputs += landing_inputs(panel, std::span(inputs_).subspan(inputs)).size();
      outputs += landing_outputs(panel, std::span(outputs_).subspan(outputs)).size();
    }
    inputs_used_ = std::span(inputs_).first(inputs);
    outputs_used_ = std::span(outputs_).first(outputs);
  }

  /// Records of the inputs; valid as long as this object.
  InputPanelSettings inputs() const { return {inputs_used_}; }
  /// Records of the outputs; valid as long as this object.
  OutputPanelSettings outputs() const { return {outputs_used_}; }

 private:
  std::array<VirtualInput, options.inputs()> inputs_{};
  std::array<VirtualOutput, options.outputs()> outputs_{};
  std::span<const VirtualInput> inputs_used_;
  std::span<const VirtualOutput> outputs_used_;
};

/// `options` are LandingPanelOptions or CarPanelOptions; `own_routes` are as in DeviceNode.
template <auto options, std::size_t queue_max = 16, std::size_t own_routes = 0,
          const auto& layout = full_lift_panel_layout<options>>
class LiftPanelDevice
    : public DeviceValues<LiftPanelDevice<options, queue_max, own_routes, layout>, layout> {
 public:
  /// `what` is a LandingPanel, a span of them, or a CarPanel; inputs and outputs without room are
  /// left out. See OutputPanelUnit. The context of `port`, and everything to which `hardware`
  /// refers, must outlive the device.
  template <class Panel>
  LiftPanelDevice(const Port& port, NodeId node_id, const OutputHardware& hardware,
                  const Panel& what)
      : records_(what), device_(port, node_id, hardware, records_.inputs(), records_.outputs()) {}
  /// The same for hardware that is a plain class, whose members are found by their names.
  template <PlainHardware<OutputHardware> Plain, class Panel>
  LiftPanelDevice(const Port& port, NodeId node_id, Plain& hardware, const Panel& what)
      : LiftPanelDevice(port, node_id, hardware_of<OutputHardware>(hardware), what) {}
  LiftPanelDevice(const LiftPanelDevice&) = delete;
  LiftPanelDevice& operator=(const LiftPanelDevice&) = delete;

  /// The node of the device: frames and points in time are handed to it.
  Node& node() { return device_.node(); }
  /// The node, for its states and counters.
  const Node& node() const { return device_.node(); }
  /// Behaviour of the inputs.
  InputPanelUnit& inputs() { return device_.inputs(); }
  /// Behaviour of the inputs.
  const InputPanelUnit& inputs() const { return device_.inputs(); }
  /// Behaviour of the outputs.
  OutputPanelUnit& outputs() { return device_.outputs(); }
  /// Behaviour of the outputs.
  const OutputPanelUnit& outputs() const { return device_.outputs(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  LiftPanelRecords<options> records_;
  PanelDevice<layout, queue_max, own_routes> device_;
};

/// A panel of one landing or several.
template <LandingPanelOptions options = LandingPanelOptions{}>
using LandingPanelDevice = LiftPanelDevice<options>;
/// A panel of a car.
template <CarPanelOptions options = CarPanelOptions{}>
using CarPanelDevice = LiftPanelDevice<options>;

}  // namespace canvoy::cia417
