#include "canvoy/worlds/lift/lift_technicians.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "canvoy/worlds/lift/car_watch.hpp"

namespace canvoy::lift {

namespace {

/// Time after which people press the alarm button.
constexpr Duration alarms_after = 1min;
/// Time for which a lift reports a fault before its technician is called: most end by themselves.
constexpr Duration reports_after = 2min;
/// The first of the seeds of a building for technicians.
constexpr std::uint64_t first_seed = 1000;

}  // namespace

LiftTechnicians::LiftTechnicians(World& world, const LiftNetworkDescription& description,
                                 LiftDevices& devices, const Crowd& crowd, Told told)
    : world_(&world),
      description_(&description),
      devices_(&devices),
      crowd_(&crowd),
      told_(std::move(told)),
      plant_(world.add_sleeping_plant(Callback<void(Time)>::to<&LiftTechnicians::step>(*this))) {
  if (!description.service.technician) return;
  for (LiftNumber lift = 1; lift <= devices.count(); ++lift) {
    technicians_.push_back(
        {std::make_unique<Technician>(hands(lift), description.faults.seed + first_seed + lift)});
  }
}

TechnicianHands LiftTechnicians::hands(LiftNumber lift) {
  LiftShaft& shaft = devices_->shaft(lift);
  return {
      .stop_switch = [&shaft](bool is_pressed) { shaft.press_stop(is_pressed); },
      .crank = [&shaft](double speed) { return shaft.crank(speed); },
      .hold_door = [&shaft](bool is_held) { shaft.hold_door(is_held); },
      .reset = [&shaft] { shaft.reset_by_hand(); },
      .inspection = [&shaft](bool is_on) { shaft.turn_inspection(Station::roof, is_on); },
      .drive = [&shaft](Direction way) { shaft.hold_inspection(Station::roof, way); },
      .restart = [&shaft] { shaft.restart(); },
      .tell = [this, lift](TechnicianStep step, FloorNumber floor) { told_(lift, step, floor); }};
}

TechnicianView LiftTechnicians::view(LiftNumber lift) const {
  const LiftShaft& shaft = devices_->shaft(lift);
  const Time now = world_->now();
  const LiftFacts facts = shaft.facts(now);
  const bool has_riders = !crowd_->riding(lift).empty();
  const bool is_open = shaft.view(now).door == DoorView::open;
  TechnicianView seen{.is_tripped = shaft.trip() != SafetyChain::Trip::none,
                      .is_shut_in = has_riders && stands(facts) && !is_open,
                      .is_out = shaft.is_out_of_order(),
                      .stands = stands(facts),
                      .is_low = facts.position_m < description_->building.top_m() / 2,
                      .is_whole = shaft.is_whole(),
                      .is_empty = crowd_->is_empty(lift)};
  const Building& building = description_->building;
  double least_m = std::numeric_limits<double>::max();
  for (FloorNumber floor = 1; floor <= building.floor_count(); ++floor) {
    const double way_m = building.height_m(floor) - facts.position_m;
    if (building.doors_at(lift, floor) == 0 || std::abs(way_m) >= least_m) continue;
    least_m = std::abs(way_m);
    seen.to_floor_m = way_m;
    seen.nearest = floor;
  }
  return seen;
}

void LiftTechnicians::tripped(LiftNumber lift) {
  if (!technicians_.empty()) at(lift).technician->call(world_->now(), TechnicianCause::trip);
}

void LiftTechnicians::complain(LiftNumber lift) {
  if (!technicians_.empty()) at(lift).technician->call(world_->now(), TechnicianCause::complaint);
}

void LiftTechnicians::look() {
  for (std::size_t i = 1; i <= technicians_.size(); ++i) look_at(static_cast<LiftNumber>(i));
}

void LiftTechnicians::look_at(LiftNumber lift) {
  Place& place = at(lift);
  const Time now = world_->now();
  const TechnicianView car = view(lift);
  if (!car.is_shut_in) place.shut_in_since = never;
  if (car.is_shut_in && place.shut_in_since == never) place.shut_in_since = now;
  const bool is_alarm = car.is_shut_in && now - place.shut_in_since >= alarms_after;
  if (is_alarm) place.technician->call(now, TechnicianCause::trapped);
  if (!car.is_out) place.out_since = never;
  if (car.is_out && place.out_since == never) place.out_since = now;
  const bool stays_out = car.is_out && now - place.out_since >= reports_after;
  // One who has left it so has ordered a part.
  if (stays_out && !place.technician->has_given_up()) {
    place.technician->call(now, TechnicianCause::fault);
  }
  place.technician->look(now, car);
  const Time next = place.technician->deadline();
  if (next != never) world_->wake_before(plant_, next);
}

void LiftTechnicians::step(Time) {
  look();
}

}  // namespace canvoy::lift
