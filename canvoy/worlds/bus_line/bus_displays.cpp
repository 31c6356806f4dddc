#include "canvoy/worlds/bus_line/bus_displays.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/plants/sign_reader.hpp"

namespace canvoy::bus_line {

using cia407::ShownElement;

cia407::DisplayHardware ShownDisplay::hardware() {
  cia407::DisplayHardware wires = display_.hardware();
  wires.show = callback<&ShownDisplay::show>(*this);
  wires.show_stop_request = callback<&ShownDisplay::show_stop_request>(*this);
  wires.test = callback<&ShownDisplay::test>(*this);
  return wires;
}

void ShownDisplay::power_off() {
  if (sabotage_.is_frozen) return;
  show({});
  show_stop_request(false);
}

void ShownDisplay::show(std::span<const ShownElement> elements) {
  if (sabotage_.is_frozen && !text_.empty()) return;
  std::vector<ShownElement> lit;
  if (!sabotage_.is_cut) lit.assign(elements.begin(), elements.end());
  for (ShownElement& element : lit) {
    element.octets = element.octets.first(std::min(element.octets.size(), sabotage_.octets_max));
  }
  display_.hardware().show(lit);
  look();
}

void ShownDisplay::test(bool is_on) {
  display_.hardware().test(is_on && !sabotage_.is_cut);
  look();
}

void ShownDisplay::look() {
  std::string text;
  for (const std::string& element : display_.texts()) {
    if (!element.empty()) text += (text.empty() ? "" : "\n") + element;
  }
  std::u32string reading;
  for (std::size_t page = 0; page < display_.pages(); ++page) {
    const std::u32string lines = read_sign(display_.picture_of(page));
    if (!lines.empty()) reading += (reading.empty() ? U"" : U"\n") + lines;
  }
  if (text == text_ && reading == reading_) return;
  text_ = std::move(text);
  reading_ = std::move(reading);
  changed_();
}

void ShownDisplay::show_stop_request(bool is_on) {
  if (is_on == display_.is_stop_requested()) return;
  display_.hardware().show_stop_request(is_on);
  changed_();
}

namespace {

/// Usual sizes in and on buses: 192 by 32 dots; the display with the route is a screen.
constexpr BusDisplay::Size sign_size = {.columns = 24, .lines = 2};
constexpr BusDisplay::Size screen_size = {.columns = 40, .lines = 4};

}  // namespace

void BusDisplays::add(NodeId id, const ShownDisplay::Sabotage& sabotage) {
  displays_.at(id) = std::make_unique<ShownDisplay>(
      size_of(id), callback<&BusDisplays::clock>(*this), changed_, sabotage);
  Environment& environment = nodes_.add_site();
  environment.provide(callback<&ShownDisplay::hardware>(*displays_.at(id)));
  nodes_.add(id, environment);
}

BusDisplay::Size usual_size(NodeId id) {
  return id == information_id ? screen_size : sign_size;
}

BusDisplay::Size BusDisplays::size_of(NodeId id) const {
  const auto& sizes = nodes_.design().displays;
  const auto own = sizes.find(id);
  return own == sizes.end() ? usual_size(id) : own->second;
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

void BusDisplays::add_second_car() {
  add(second_destination_id, {});
  add(second_next_stop_id, {.is_cut = sabotage_.cuts_second_car,
                            .is_frozen = sabotage_.freezes_second_car,
                            .has_no_sign = sabotage_.no_second_sign_lamp});
}

void BusDisplays::lose_power(NodeId id) {
  if (displays_.at(id)) displays_.at(id)->power_off();
}

bool BusDisplays::is_sign_lit(unsigned car) const {
  if (car == 2) return at(second_next_stop_id).is_sign_lit();
  return at(next_stop_id).is_sign_lit() || at(information_id).display().is_stop_requested();
}

}  // namespace canvoy::bus_line
