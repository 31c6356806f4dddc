#include "canvoy/tools/device/bus/device_bus_displays.hpp"

namespace canvoy::tools {

std::vector<std::string_view> display_names(std::span<const cia407::BusUnit* const> units) {
  std::vector<std::string_view> names;
  for (const cia407::BusUnit* unit : units) {
    const bool has_display =
        unit->provides->code == code_of(cia407::DeviceCode::passenger_information);
    if (has_display) names.push_back(unit->info.name);
  }
  return names;
}

void DeviceBusDisplays::join(Environment& environment) {
  environment.provide(Callback<cia407::DisplayHardware()>::to<&DeviceBusDisplays::next>(*this));
}

void DeviceBusDisplays::look() {
  for (DeviceBusDisplay& display : displays_) display.look();
}

/// Displays are requested in the order of the units.
cia407::DisplayHardware DeviceBusDisplays::next() {
  const std::size_t before = displays_.size();
  const std::string_view name = before < names_.size() ? names_[before] : "display";
  return displays_.emplace_back(std::string(name), size_, png_, clock_, output_).hardware();
}

}  // namespace canvoy::tools
