// Contents of the panels of a lift controller.
#include "canvoy/devices/cia417/controller/lift_controller.hpp"

namespace canvoy::cia417 {

void LiftController::show() {
  LiftDisplay& display = calls_.display();
  display.floor = motion_.available ? floors().nearest(motion_.position_micrometre) : 0;
  display.moving = phase_ == LiftPhase::driving || hand_.direction() != 0;
  display.direction = direction_;
  const bool stops = phase_ == LiftPhase::opening || phase_ == LiftPhase::open;
  display.lantern_floor = stops ? floor_ : promised_.floor;
  display.lantern_doors = stops ? open_doors_ : promised_.doors;
  const Direction departs = stops ? direction_ : promised_.departure;
  display.lantern = service_.accepted() == all_calls ? departs : Direction::none;
  display.specials = special_indications();
  calls_.show();
}

SpecialIndications LiftController::special_indications() const {
  SpecialIndications specials = 0;
  const auto add = [&](bool is_case, SpecialIndication indication) {
    if (is_case) specials |= indication_bit(indication);
  };
  const bool takes_time =
      calls_.is_on(SpecialFunction::load_time_1) || calls_.is_on(SpecialFunction::load_time_2);
  add(load_.zero && load_.known, SpecialIndication::no_load);
  add(load_.full && !load_.overload, SpecialIndication::full_load);
  add(load_.overload, SpecialIndication::overload);
  add(service_.is_in_fire(), SpecialIndication::fire);
  add(service_.is(LiftService::fire_brigade), SpecialIndication::fire_brigade_service);
  add(calls_.is_help_coming(), SpecialIndication::help_is_coming);
  add(service_.is(LiftService::special) || service_.is_manual(),
      SpecialIndication::special_service);
  add(takes_time, SpecialIndication::load_time);
  add(service_.is_occupied(), SpecialIndication::occupied);
  add(service_.is(LiftService::out_of_order) || faults_.is_there(),
      SpecialIndication::out_of_order);
  return specials;
}

}  // namespace canvoy::cia417
