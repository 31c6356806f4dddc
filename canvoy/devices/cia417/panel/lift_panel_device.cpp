#include "canvoy/devices/cia417/panel/lift_panel_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/panel/landing_site.hpp"

namespace canvoy::cia417 {

namespace {

template <auto options>
class SitedPanel {
 public:
  template <class Panel>
  SitedPanel(const Port& port, NodeId node_id, const Environment& environment, const Panel& what)
      : device_(port, node_id, environment.get<OutputHardware>(), what) {
    environment.made(device_.inputs(), device_.node());
    environment.made(device_.outputs(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  LiftPanelDevice<options, 16, catalogue_routes> device_;
};

constexpr LandingPanelOptions landing_options{};
constexpr CarPanelOptions car_options{};

struct SitedLandingPanel : SitedPanel<landing_options> {
  SitedLandingPanel(const Port& port, NodeId node_id, const Environment& environment)
      : SitedPanel(port, node_id, environment, landing_at(environment)) {}
};
struct SitedCarPanel : SitedPanel<car_options> {
  SitedCarPanel(const Port& port, NodeId node_id, const Environment& environment)
      : SitedPanel(port, node_id, environment,
                   CarPanel{.lift = environment.lift,
                            .highest_floor = static_cast<std::uint8_t>(environment.floors)}) {}
};

constexpr DeviceForm landing_forms[] = {
    form_of<SitedLandingPanel, full_lift_panel<landing_options>>};
constexpr DeviceForm car_forms[] = {form_of<SitedCarPanel, full_lift_panel<car_options>>};

}  // namespace

const DeviceKind landing_panel_kind = {
    .info = landing_panel_info, .profile = &profile, .forms = landing_forms};
const DeviceKind car_panel_kind = {.info = car_panel_info, .profile = &profile, .forms = car_forms};

}  // namespace canvoy::cia417
