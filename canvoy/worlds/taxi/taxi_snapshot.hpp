// State of a taxi at one instant: its bus and devices, meter, driver, lights, displays and paper,
// and the true distance of the car.
//
//     const TaxiSnapshot look = network.snapshot();
//     print(look.screens[0].text);
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/taxi/shift.hpp"
#include "canvoy/worlds/taxi/terminal_screens.hpp"

namespace canvoy::taxi {

/// State of everything.
struct TaxiSnapshot {
  Time at{};                            ///< since the start of the run
  BusSnapshot bus;                      ///< of the car, with its load since the start
  std::vector<NodeSnapshot> nodes;      ///< in the order of their node-IDs
  std::vector<std::string_view> names;  ///< of the nodes

  cia447::Taximeter meter = cia447::Taximeter::signed_off;     ///< state of the taximeter
  cia447::TripData trip;                                       ///< as the meter shows it
  Activity driver = Activity::off_duty;                        ///< what the driver does
  bool is_asleep = false;                                      ///< all devices sleep
  unsigned carried = 0;                                        ///< trips that were paid
  double paid = 0;                                             ///< total in currency units
  std::array<cia447::Lamp, cia447::tariff_lamps_max> lamps{};  ///< on the roof, from lamp 1 on
  std::array<Screen, 2> screens;                               ///< of the terminal
  std::vector<std::string> paper;                              ///< its last lines

  // true values
  double metres = 0;  ///< m driven since the start
  double speed = 0;   ///< m/s
};

}  // namespace canvoy::taxi
