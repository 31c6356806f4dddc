#include "canvoy/worlds/police/supply_device.hpp"

namespace canvoy::police {

void SupplyDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(callback<&SupplyDevice::hardware>(*this));
  environment.provide(callback<&SupplyDevice::settings>(*this));
  environment.watch(unit_);
  bus_.add(car::units_of<PowerSupplyKind>, environment);
}

cia447::PowerSupplyHardware SupplyDevice::hardware() {
  return {.switch_power = callback<&SupplyDevice::switch_power>(*this)};
}

void SupplyDevice::switch_power(cia447::Supply supply, bool is_on) {
  const bool is_radio = supply == cia447::Supply::radio;
  bool& has_power = is_radio ? radio_has_power_ : periphery_has_power_;
  const bool is_welded = is_radio && options_.sabotage.welded_supply;
  if (has_power == is_on || (!is_on && is_welded)) return;
  has_power = is_on;
  events_.note(bus_.world().now(), PowerSwitched{is_radio, is_on});
}

void SupplyDevice::lose_power(NodeId id) {
  if (id != power_supply_id) return;
  switch_power(cia447::Supply::radio, false);
  switch_power(cia447::Supply::periphery, false);
}

void SupplyDevice::sense(NodeId id) {
  if (id == power_supply_id && is_overloaded_) {
    unit_->report_overload(cia447::Supply::radio, true);
  }
}

void SupplyDevice::overload(bool is_overloaded) {
  is_overloaded_ = is_overloaded;
  if (!bus_.has_power(power_supply_id)) return;
  unit_->report_overload(cia447::Supply::radio, is_overloaded);
  bus_.touched(power_supply_id);
}

}  // namespace canvoy::police
