// The panel of a landing at its site, for the rows of the catalogue.
//
//     landing_inputs(landing_at(environment), inputs)
#pragma once

#include "canvoy/devices/cia417/panel/lift_panels.hpp"
#include "canvoy/devices/kit/environment.hpp"

namespace canvoy::cia417 {

/// Panel of the floor, lift and door that an environment names.
inline LandingPanel landing_at(const Environment& environment) {
  return {.lifts = lift_bit(environment.lift),
          .floor = static_cast<std::uint8_t>(environment.floor),
          .highest_floor = static_cast<std::uint8_t>(environment.floors)};
}

}  // namespace canvoy::cia417
