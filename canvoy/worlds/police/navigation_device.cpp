#include "canvoy/worlds/police/navigation_device.hpp"

#include <cmath>
#include <cstdio>

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

constexpr std::size_t digits_max = 3;

}  // namespace

constexpr ServiceHandlers NavigationControl::service_calls = {
    .reset = method<&NavigationControl::reset>};
constexpr AccessHandlers NavigationControl::greedy_hooks[] = {
    after_write<&NavigationControl::key_written, number_pad_user_interaction_object>};
constexpr ServiceHandlers NavigationControl::greedy_calls = {.hooks = greedy_hooks};

NavigationControl::NavigationControl(CarNetwork& network, const NavigationControlHardware& hardware,
                                     const NavigationControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      terminal_(network, {.terminal = settings.terminal}),
      menu_(network, terminal_, title_of(Client::navigation)) {
  terminal_.on_number_key(callback<&NavigationControl::number_pressed>(*this));
  network.node().attach(service_);
  if (settings.is_greedy) network.node().attach(greed_);
}

void NavigationControl::reset(ResetScope) {
  menu_.close();
  typed_.clear();
}

void NavigationControl::press_button() {
  if (menu_.is_open()) return;
  typed_.clear();
  menu_.open("to ?");
}

void NavigationControl::number_pressed(NumberPadKey key) {
  if (hardware_.acted) {
    hardware_.acted({.client = Client::navigation, .key = static_cast<std::uint8_t>(key)});
  }
  if (!menu_.is_open()) return;
  const int digit = digit_of(key);
  if (key == NumberPadKey::star) {
    typed_.clear();
  } else if (digit >= 0 && typed_.size() < digits_max) {
    typed_ += static_cast<char>('0' + digit);
  } else if (key == NumberPadKey::hash && !typed_.empty()) {
    const auto destination = static_cast<unsigned>(std::stoul(typed_));
    const double metres = hardware_.guide ? hardware_.guide(destination) : 0;
    char distance[16];
    std::snprintf(distance, sizeof distance, "%.1f km", metres / 1000);
    return menu_.finish("to " + typed_ + ": " + distance, 3s);
  }
  menu_.show("to " + (typed_.empty() ? "?" : typed_));
}

void NavigationControl::key_written(const Entry&, Source) {
  const auto key = static_cast<NumberPadKey>(
      read_field(network_.node().dictionary(), place_of(number_pad_user_interaction)));
  if (key != NumberPadKey::none && !menu_.is_open()) number_pressed(key);
}

namespace {

constexpr double metres_a_degree = 111'200;
constexpr cia447::GeoPosition station = {48.137, 11.575};

}  // namespace

void NavigationDevice::add_node() {
  using namespace cia447;
  Environment& environment = bus_.add_site();
  environment.provide(callback<&NavigationDevice::gps_hardware>(*this));
  environment.provide(callback<&NavigationDevice::hardware>(*this));
  environment.watch(unit_);
  environment.provide(callback<&NavigationDevice::control_hardware>(*this));
  environment.provide(callback<&NavigationDevice::control_settings>(*this));
  environment.watch(control_);
  bus_.add(car::units_of<GpsKind, NavigationKind, NavigationControlKind>, environment);
}

void NavigationDevice::press_button() {
  if (bus_.has_power(navigation_id)) control_->press_button();
  bus_.touched(navigation_id);
}

cia447::GpsHardware NavigationDevice::gps_hardware() {
  return {.read = callback<&NavigationDevice::gps_reading>(*this)};
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
  hardware.position = callback<&NavigationDevice::position>(*this);
  hardware.road = callback<&NavigationDevice::road>(*this);
  return hardware;
}

NavigationControlHardware NavigationDevice::control_hardware() {
  return {.acted = acted_, .guide = callback<&NavigationDevice::guide>(*this)};
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
