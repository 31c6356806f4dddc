#include "canvoy/worlds/lift/inspection_stations.hpp"

namespace canvoy::lift {

namespace {

using cia417::SpecialFunction;

/// Floor in the records of a station: that of a panel in the car, or of the landing above the pit.
FloorNumber floor_of(Station station) {
  return station == Station::roof ? cia417::floor_of_car : FloorNumber{1};
}

}  // namespace

void InspectionStations::turn(Station station, bool on) {
  of(station).is_on = on;
  press(station, SpecialFunction::service_run, on);
}

void InspectionStations::hold(Station station, Direction way) {
  of(station).held = way;
  press(station, SpecialFunction::dogging_service_up, way == Direction::up);
  press(station, SpecialFunction::dogging_service_down, way == Direction::down);
}

void InspectionStations::report_again() {
  for (const Station station : {Station::roof, Station::pit}) {
    if (!of(station).is_on) continue;
    turn(station, true);
    hold(station, of(station).held);
  }
}

Direction InspectionStations::held() const {
  const State& roof = of(Station::roof);
  const State& pit = of(Station::pit);
  if (roof.is_on && pit.is_on) return roof.held == pit.held ? roof.held : Direction::none;
  if (!is_on()) return Direction::none;
  return roof.is_on ? roof.held : pit.held;
}

/// Wires tell what both stations want together.
void InspectionStations::press(Station station, SpecialFunction function, bool on) {
  if (panels_->press_at(floor_of(station), function, on)) return;
  const bool wants = function == SpecialFunction::service_run          ? is_on()
                     : function == SpecialFunction::dogging_service_up ? held() == Direction::up
                                                                       : held() == Direction::down;
  units_->set_special(function, wants);
}

}  // namespace canvoy::lift
