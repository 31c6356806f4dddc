#include "canvoy/devices/cia417/group/group_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

namespace {

class SitedGroupController {
 public:
  SitedGroupController(const Port& port, NodeId node_id, const Environment& environment)
      : device_(port, environment.get<GroupControllerSettings>(), node_id) {
    environment.made(device_.group(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  GroupControllerDevice<full_group_controller_layout, 512, 512, 64, catalogue_routes> device_;
};

constexpr DeviceForm group_controller_forms[] = {
    form_of<SitedGroupController, full_group_controller>};

}  // namespace

const DeviceKind group_controller_kind = {
    .info = group_controller_info, .profile = &profile, .forms = group_controller_forms};

}  // namespace canvoy::cia417
