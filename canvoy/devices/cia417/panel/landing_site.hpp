// The panel of a landing as its site has it, for the rows of the catalogue.
//
//     landing_inputs(landing_at(site), inputs)
#pragma once

#include "canvoy/devices/cia417/controller/lift_panels.hpp"
#include "canvoy/devices/site.hpp"

namespace canvoy::cia417 {

inline LandingPanel landing_at(const Site& site) {
  return {.lifts = lift_bit(site.lift),
          .floor = static_cast<std::uint8_t>(site.floor),
          .highest_floor = static_cast<std::uint8_t>(site.floors)};
}

}  // namespace canvoy::cia417
