#include "canvoy/worlds/police/navigation_device.hpp"

#include <cmath>

namespace canvoy::police {

namespace {

constexpr double metres_a_degree = 111'200;
constexpr cia447::GeoPosition station = {48.137, 11.575};

}  // namespace

void NavigationDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(Callback<GpsHardware()>::to<&NavigationDevice::gps_hardware>(*this));
  environment.provide(Callback<NavigationHardware()>::to<&NavigationDevice::hardware>(*this));
  environment.watch(Callback<void(NavigationUnit&, Node&)>::to<&NavigationDevice::is_unit>(*this));
  environment.provide(
      Callback<NavigationControlHardware()>::to<&NavigationDevice::control_hardware>(*this));
  environment.provide(
      Callback<NavigationControlSettings()>::to<&NavigationDevice::control_settings>(*this));
  environment.watch(
      Callback<void(NavigationControl&, Node&)>::to<&NavigationDevice::is_control>(*this));
  bus_.add(car::units_of<GpsKind, NavigationKind, NavigationControlKind>, environment);
}

void NavigationDevice::press_button() {
  if (bus_.has_power(navigation_id)) control_->press_button();
  bus_.touched(navigation_id);
}

cia447::GpsHardware NavigationDevice::gps_hardware() {
  return {.read = Callback<cia447::GpsReading()>::to<&NavigationDevice::gps_reading>(*this)};
}
cia447::GpsReading NavigationDevice::gps_reading() {
  return {.fix = cia447::GpsFix::fix_3d,
          .latitude = here().latitude,
          .longitude = station.longitude,
          .altitude = 519,
          .velocity = drive_.speed(),
          .heading = 0,
          .visible_satellites = 11,
          .tracked_satellites = 9};
}

cia447::GeoPosition NavigationDevice::here() const {
  return {station.latitude + drive_.metres() / metres_a_degree, station.longitude};
}
double NavigationDevice::road(const cia447::GeoPosition& from, const cia447::GeoPosition& to) {
  return std::abs(to.latitude - from.latitude) * metres_a_degree;
}

cia447::NavigationHardware NavigationDevice::hardware() {
  using cia447::GeoPosition;
  cia447::NavigationHardware hardware;
  hardware.position =
      Callback<std::optional<GeoPosition>()>::to<&NavigationDevice::position>(*this);
  hardware.road =
      Callback<double(const GeoPosition&, const GeoPosition&)>::to<&NavigationDevice::road>(*this);
  return hardware;
}

NavigationControlHardware NavigationDevice::control_hardware() {
  return {.acted = acted_,
          .guide = Callback<double(unsigned)>::to<&NavigationDevice::guide>(*this)};
}
NavigationControlSettings NavigationDevice::control_settings() {
  return {.terminal = terminal_id, .is_greedy = sabotage_.greedy_navigation};
}

double NavigationDevice::guide(unsigned destination) {
  if (destination_ != destination) return 0;
  const cia447::GeoPosition scene = {station.latitude + scene_at_ / metres_a_degree,
                                     station.longitude};
  unit_->select(scene);
  return road(here(), scene);
}

}  // namespace canvoy::police
