#include "canvoy/worlds/lift/lift_people.hpp"

#include <algorithm>
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
      plant_(world.add_sleeping_plant(callback<&LiftTechnicians::step>(*this))) {
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

namespace {

Traffic traffic_of(const LiftNetworkDescription& description) {
  if (!description.arrivals.empty()) return Traffic(description.arrivals);
  return {description.building, description.traffic};
}

}  // namespace

LiftPeople::LiftPeople(World& world, const LiftNetworkDescription& description,
                       LiftDevices& devices, LiftPeopleHooks hooks)
    : world_(&world),
      description_(&description),
      devices_(&devices),
      hooks_(std::move(hooks)),
      crowd_(description.building, traffic_of(description), hands(), description.people),
      plant_(world.add_sleeping_plant(callback<&LiftPeople::run>(*this))),
      technicians_(world, description, devices, crowd_, hooks_.technician) {
  wake();
  add_brigades();
}

PassengerHands LiftPeople::hands() {
  return {
      .hall_button =
          [this](const HallButton& button, bool pressed) {
            press({.floor = button.floor, .direction = button.direction}, pressed, button.to);
          },
      .car_button =
          [this](const CarButton& button, bool pressed) {
            press({.lift = button.lift, .floor = button.floor}, pressed);
          },
      .destination_button =
          [this](const DestinationButton& button, bool pressed) {
            press({.floor = button.floor, .to = button.to}, pressed, button.to);
          },
      .door_open_button = [this](LiftNumber lift,
                                 bool pressed) { devices_->shaft(lift).press_door_open(pressed); },
      .doorway =
          [this](LiftNumber lift, DoorNumber door, bool is_in_the_way) {
            devices_->shaft(lift).stand_in_door(door, is_in_the_way);
          },
      .carried = [this](LiftNumber lift) { hooks_.carried(lift); },
      .gave_up = [this](Time since) { hooks_.gave_up(since); },
      .load = [this](LiftNumber lift, double mass_kg) { devices_->shaft(lift).set_load(mass_kg); },
  };
}

void LiftPeople::add_brigades() {
  for (LiftNumber number = 1; number <= devices_->count(); ++number) {
    LiftShaft& lift = devices_->shaft(number);
    brigades_.push_back(std::make_unique<FireBrigade>(
        FireBrigadeHands{.alarm_key = [&lift](bool on) { lift.turn_fire_key(on); },
                         .car_key = [&lift](bool on) { lift.turn_brigade_key(on); },
                         .call =
                             [&lift, number](FloorNumber floor, bool pressed) {
                               lift.press({.lift = number, .floor = floor}, pressed);
                             },
                         .door_open = [&lift](bool pressed) { lift.press_door_open(pressed); },
                         .door_close = [&lift](bool pressed) { lift.press_door_close(pressed); }},
        FireBrigadeOptions{.fire_floor = description_->service.fire_floor,
                           .floors = description_->building.floor_count(),
                           .seed = description_->faults.seed + number}));
  }
}

void LiftPeople::run(Time now) {
  crowd_.advance(now);
  wake();
}

void LiftPeople::wake() {
  world_->wake(plant_, crowd_.deadline());
}

bool LiftPeople::visit(FloorNumber from, FloorNumber to) {
  const Building& building = description_->building;
  const auto is_floor = [&](FloorNumber floor) {
    return floor >= 1 && floor <= building.floor_count();
  };
  if (!is_floor(from) || !is_floor(to) || from == to || !building.has_way(from, to)) return false;
  const Time now = world_->now();
  crowd_.come(now, {.at = now, .from = from, .to = to});
  wake();
  return true;
}

/// A real panel has its buttons as well.
bool LiftPeople::has_button(const CallKey& call) const {
  return std::ranges::any_of(description_->nodes, [&](const NodeDescription& node) {
    if (call.lift != 0) return node.kind == DeviceKind::car_panel && node.lift == call.lift;
    return node.kind == DeviceKind::landing_panel &&
           std::ranges::find(node.floors, call.floor) != node.floors.end();
  });
}

void LiftPeople::press(const CallKey& call, bool pressed, FloorNumber to) {
  // Who finds no button wants a lift as well, and no lamp ever answers.
  if (!has_button(call)) {
    if (pressed) hooks_.pressed(call);
    return;
  }
  if (call.lift != 0) {
    if (devices_->shaft(call.lift).press(call, pressed) && pressed) hooks_.pressed(call);
    return;
  }
  if (!pressed) {
    const auto found = pressed_on_.find(call);
    if (found != pressed_on_.end()) devices_->shaft(found->second).press(call, false);
    return;
  }
  const LiftNumber lift = next_panel(call, to);
  pressed_on_[call] = lift;
  if (devices_->shaft(lift).press(call, true)) hooks_.pressed(call);
}

/// The next lift in turn, of those that go to the passenger's destination.
LiftNumber LiftPeople::next_panel(const CallKey& call, FloorNumber to) {
  const Building& building = description_->building;
  const LiftNumber lifts = devices_->count();
  for (unsigned i = 0; i < lifts; ++i) {
    const auto lift = static_cast<LiftNumber>(1 + presses_++ % lifts);
    const bool goes_there = to == no_floor || building.serves(lift, to);
    if (goes_there && building.serves(lift, call.floor)) return lift;
  }
  return static_cast<LiftNumber>(1 + presses_++ % lifts);
}

void LiftPeople::car_changed(LiftNumber lift) {
  const Time now = world_->now();
  crowd_.car_changed(now, lift, devices_->shaft(lift).view(now));
  wake();
}

/// The lamp of a destination has no effect: a passenger who has entered it looks for the lift.
void LiftPeople::lamp_changed(const CallKey& call, bool is_lit) {
  if (call.to != no_floor) return;
  if (call.lift != 0) {
    crowd_.car_lamp({call.lift, call.floor}, is_lit);
  } else {
    crowd_.hall_lamp({call.floor, call.direction}, is_lit);
  }
}

void LiftPeople::assigned(LiftNumber panel, const DestinationButton& button, LiftNumber lift) {
  const auto asked_at = pressed_on_.find({.floor = button.floor, .to = button.to});
  const bool is_seen = asked_at == pressed_on_.end() || asked_at->second == panel;
  if (is_seen) crowd_.assigned(button, lift);
}

void LiftPeople::call_brigade(LiftNumber lift, bool is_there) {
  FireBrigade& brigade = *brigades_[lift - std::size_t{1}];
  is_there ? brigade.begin(world_->now()) : brigade.end(world_->now());
}

void LiftPeople::look_for_brigades() {
  const Time now = world_->now();
  for (LiftNumber lift = 1; lift <= devices_->count(); ++lift) {
    FireBrigade& brigade = *brigades_[lift - std::size_t{1}];
    if (!brigade.is_there()) continue;
    const LiftShaft& shaft = devices_->shaft(lift);
    const LiftFacts facts = shaft.facts(now);
    const FloorNumber here = floor_at(description_->building, facts.position_m);
    brigade.look(now, {.floor = stands(facts) ? here : no_floor,
                       .is_open = shaft.view(now).door == DoorView::open,
                       .is_empty = crowd_.is_empty(lift)});
  }
}

bool LiftPeople::is_wanted(LiftNumber lift) const {
  if (lift != 0 && technicians_.is_called(lift)) return false;
  if (lift != 0 && brigades_[lift - std::size_t{1}]->is_there()) return false;
  const bool is_waited_for = crowd_.waiting_count() > 0;
  return is_waited_for || (lift != 0 && !crowd_.riding(lift).empty());
}

}  // namespace canvoy::lift
