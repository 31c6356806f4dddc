// The texts that a display shows, for wire tests.
//
//     ShownTexts shown;
//     environment.provide(Callback<DisplayHardware()>::to<&ShownTexts::hardware>(shown));
#pragma once

#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"

namespace canvoy::cia407 {

struct ShownTexts {
  std::vector<std::string> texts;

  void show(std::span<const ShownElement> elements) {
    texts.clear();
    for (const ShownElement& element : elements) {
      texts.emplace_back(element.octets.begin(), element.octets.end());
    }
  }
  DisplayHardware hardware() { return {.show = callback<&ShownTexts::show>(*this)}; }
};

}  // namespace canvoy::cia407
