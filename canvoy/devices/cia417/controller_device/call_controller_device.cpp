#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

namespace {

class SitedCallController {
 public:
  SitedCallController(const Port& port, NodeId node_id, const Environment& environment)
      : device_(port, node_id,
                {.lift = environment.lift,
                 .served = {FloorSet::between(1, static_cast<std::uint8_t>(environment.floors))}}) {
    environment.made(device_.calls(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  CallControllerDevice<full_call_controller_layout, destinations_default, catalogue_routes> device_;
};

constexpr DeviceForm call_controller_forms[] = {form_of<SitedCallController, full_call_controller>};

}  // namespace

const DeviceKind call_controller_kind = {
    .info = call_controller_info, .profile = &profile, .forms = call_controller_forms};

}  // namespace canvoy::cia417
