#include "canvoy/devices/cia419/charger_device.hpp"

#include "canvoy/devices/cia419/kinds.hpp"

namespace canvoy::cia419 {

namespace {

template <const auto& layout>
class SitedCharger {
 public:
  SitedCharger(const Port& port, NodeId node_id, const Environment& environment)
      : device_(port, node_id, environment.get<ChargerHardware>(),
                {.limits = {}, .manage_network = environment.manages_network}) {
    environment.made(device_.charger(), device_.node());
  }
  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  ChargerDevice<layout, catalogue_routes> device_;
};

constexpr auto keeping_charger = describe(full_charger, cia301::storage(storage_groups));
constexpr auto keeping_charger_layout = lay_out_device<keeping_charger>();
constexpr DeviceForm forms[] = {form_of<SitedCharger<full_charger_layout>, full_charger>};
constexpr DeviceForm keeping_forms[] = {
    form_of<SitedCharger<keeping_charger_layout>, keeping_charger>};

}  // namespace

const DeviceKind charger_kind = {
    .info = charger_info, .profile = &profile, .forms = forms, .keeping_forms = keeping_forms};

}  // namespace canvoy::cia419
