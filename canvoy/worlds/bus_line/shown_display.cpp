#include "canvoy/worlds/bus_line/shown_display.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/plants/sign_reader.hpp"

namespace canvoy::bus_line {

using cia407::ShownElement;

cia407::DisplayHardware ShownDisplay::hardware() {
  cia407::DisplayHardware wires = display_.hardware();
  wires.show = Callback<void(std::span<const ShownElement>)>::to<&ShownDisplay::show>(*this);
  wires.show_stop_request = Callback<void(bool)>::to<&ShownDisplay::show_stop_request>(*this);
  wires.test = Callback<void(bool)>::to<&ShownDisplay::test>(*this);
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

}  // namespace canvoy::bus_line
