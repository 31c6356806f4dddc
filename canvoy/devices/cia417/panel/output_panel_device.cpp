#include "canvoy/devices/cia417/panel/output_panel_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/kit/lift_kind.hpp"
#include "canvoy/devices/cia417/panel/landing_site.hpp"

namespace canvoy::cia417 {

namespace {

constexpr DeviceInfo output_panel_info = {.name = "lift-output-panel",
                                          .title = "output panel unit: lamps of a landing",
                                          .product = "Canvoy CiA 417 output panel",
                                          .product_code = 41713,
                                          .node_id = 23,
                                          .hardware = "lamps, displays, a gong"};
constexpr std::uint16_t outputs_max = landing_outputs_max(0, false);
constexpr auto output_panel = describe(panel<PanelOptions{.outputs = outputs_max}>(),
                                       lift_basics(output_panel_info, 1000, 4));
constexpr auto output_panel_layout = lay_out_device<output_panel>();

class SitedOutputPanel {
 public:
  SitedOutputPanel(const Port& port, NodeId node_id, const Environment& environment)
      : outputs_used_(landing_outputs(landing_at(environment), outputs_)),
        device_(port, node_id, environment.get<OutputHardware>(), {.outputs = outputs_used_}) {
    environment.made(device_.unit(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  std::array<VirtualOutput, outputs_max> outputs_{};
  std::span<const VirtualOutput> outputs_used_;
  OutputPanelDevice<output_panel_layout, catalogue_routes> device_;
};

constexpr DeviceForm output_panel_forms[] = {form_of<SitedOutputPanel, output_panel>};

}  // namespace

const DeviceKind output_panel_kind = {
    .info = output_panel_info, .profile = &profile, .forms = output_panel_forms};

}  // namespace canvoy::cia417
