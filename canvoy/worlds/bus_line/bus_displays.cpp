#include "canvoy/worlds/bus_line/bus_displays.hpp"

namespace canvoy::bus_line {

namespace {

/// Usual sizes in and on buses: 192 by 32 dots; the display with the route is a screen.
constexpr BusDisplay::Size sign_size = {.columns = 24, .lines = 2};
constexpr BusDisplay::Size screen_size = {.columns = 40, .lines = 4};

}  // namespace

void BusDisplays::add(DeviceKey key, const ShownDisplay::Sabotage& sabotage) {
  displays_.at(key) = std::make_unique<ShownDisplay>(
      size_of(key), Callback<Time()>::to<&BusDisplays::clock>(*this), changed_, sabotage);
  Environment& environment = nodes_.add_site();
  environment.provide(
      Callback<cia407::DisplayHardware()>::to<&ShownDisplay::hardware>(*displays_.at(key)));
  nodes_.add(key, environment);
}

BusDisplay::Size usual_size(DeviceKey key) {
  return key == information_id ? screen_size : sign_size;
}

BusDisplay::Size BusDisplays::size_of(DeviceKey key) const {
  const auto& sizes = nodes_.design().displays;
  const auto own = sizes.find(key);
  return own == sizes.end() ? usual_size(key) : own->second;
}

void BusDisplays::add_first_car() {
  constexpr std::size_t few_octets = 40;
  add(front_display_id, {.is_cut = sabotage_.cuts_destination});
  add(side_display_id, {.is_frozen = sabotage_.freezes_destination});
  add(next_stop_id, {.is_cut = sabotage_.cuts_next_stop,
                     .has_no_sign = sabotage_.no_sign_lamp,
                     .has_stuck_sign = sabotage_.stuck_sign});
  ShownDisplay::Sabotage memory{.is_cut = sabotage_.cuts_information};
  if (sabotage_.short_memory) memory.octets_max = few_octets;
  add(information_id, memory);
}

void BusDisplays::add_following_car(unsigned car) {
  add(destination_of(car), {});
  add(next_stop_of(car), {.is_cut = sabotage_.cut_car == car,
                          .is_frozen = sabotage_.frozen_car == car,
                          .has_no_sign = sabotage_.unlit_car == car});
}

void BusDisplays::lose_power(DeviceKey key) {
  const bool is_display = key < displays_.size() && displays_[key] != nullptr;  // none is added
  if (is_display) displays_[key]->power_off();
}

bool BusDisplays::is_sign_lit(unsigned car) const {
  return at(next_stop_of(car)).is_sign_lit() ||
         (car == 1 && at(information_id).display().is_stop_requested());
}

}  // namespace canvoy::bus_line
