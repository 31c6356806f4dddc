// The inspection control of a lift: a station on the roof of the car and one in the pit, each with
// a switch and a button for each direction (EN 81-20, 5.12.1.5). A station that the network has is
// a panel with the special functions 13h, 15h and 16h of CiA 417-4, 4.3.1; one that it does not
// have is wired to the controller.
//
//     InspectionStations stations(panels, units);
//     stations.turn(Station::roof, true);
//     stations.hold(Station::roof, Direction::up);
//
// With both stations on, the car moves while the same button is held at both.
#pragma once

#include <array>

#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/shaft_panels.hpp"
#include "canvoy/worlds/lift/shaft_units.hpp"

namespace canvoy::lift {

/// Place of a station.
enum class Station : std::uint8_t { roof, pit };

class InspectionStations {
 public:
  /// Both must outlive this object.
  InspectionStations(ShaftPanels& panels, ShaftUnits& units) : panels_(&panels), units_(&units) {}
  InspectionStations(const InspectionStations&) = delete;
  InspectionStations& operator=(const InspectionStations&) = delete;

  /// Turns its switch.
  void turn(Station station, bool on);
  /// Holds a button; none: releases both.
  void hold(Station station, Direction way);
  /// Call it when the controller has power again: its inputs are as the hands have left them.
  void report_again();
  /// True if at least one is on.
  bool is_on() const { return of(Station::roof).is_on || of(Station::pit).is_on; }
  /// Direction in which the car may move; none: it must stand.
  Direction held() const;

 private:
  struct State {
    bool is_on = false;
    Direction held = Direction::none;
  };
  State& of(Station station) { return states_.at(static_cast<std::size_t>(station)); }
  const State& of(Station station) const { return states_.at(static_cast<std::size_t>(station)); }
  void press(Station station, cia417::SpecialFunction function, bool on);

  ShaftPanels* panels_;
  ShaftUnits* units_;
  std::array<State, 2> states_{};
};

}  // namespace canvoy::lift
