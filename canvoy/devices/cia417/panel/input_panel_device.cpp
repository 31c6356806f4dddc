#include "canvoy/devices/cia417/panel/input_panel_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/panel/landing_site.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"

namespace canvoy::cia417 {

namespace {

constexpr DeviceInfo input_panel_info = {.name = "lift-input-panel",
                                         .title = "input panel unit: buttons of a landing",
                                         .product = "Canvoy CiA 417 input panel",
                                         .product_code = 41712,
                                         .node_id = 22,
                                         .hardware = "buttons and keys"};
constexpr std::uint16_t inputs_max = landing_inputs_max(0, false);
constexpr auto input_panel =
    describe(panel<PanelOptions{.inputs = inputs_max}>(), lift_basics(input_panel_info, 1000, 4));
constexpr auto input_panel_layout = lay_out_device<input_panel>();

class SitedInputPanel {
 public:
  SitedInputPanel(const Port& port, NodeId node_id, const Environment& environment)
      : inputs_used_(landing_inputs(landing_at(environment), inputs_)),
        device_(port, node_id, {.inputs = inputs_used_}) {
    environment.made(device_.unit(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  std::array<VirtualInput, inputs_max> inputs_{};
  std::span<const VirtualInput> inputs_used_;
  InputPanelDevice<input_panel_layout, 16, catalogue_routes> device_;
};

constexpr DeviceForm input_panel_forms[] = {form_of<SitedInputPanel, input_panel>};

}  // namespace

const DeviceKind input_panel_kind = {
    .info = input_panel_info, .profile = &profile, .forms = input_panel_forms};

}  // namespace canvoy::cia417
