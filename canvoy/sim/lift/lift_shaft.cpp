#include "canvoy/sim/lift/lift_shaft.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "canvoy/sim/lift/lift_shaft_parts.hpp"

namespace canvoy::lift {

namespace {

using cia417::BasicFunction;
using cia417::Detection;
using cia417::SpecialFunction;

/// What moves is looked at so often.
constexpr Duration moving_period = 100ms;
/// A car that was told to move waits for its brake.
constexpr Duration watched_period = 1s;
/// People step in as soon as the door is open by so much of its width.
constexpr double walkable_share = 0.8;
constexpr double near_floor_m = 0.05;
constexpr double joule_per_wh = 3600;

Direction direction_of(const cia417::OutputView& view) {
  const unsigned both = cia417::arrow_up | cia417::arrow_down;
  const unsigned arrows = view.sub_function & both;
  if (!view.on || arrows == both || arrows == 0) return Direction::none;
  return arrows == cia417::arrow_up ? Direction::up : Direction::down;
}

std::size_t bus_of(const LiftNetworkDescription& description, LiftNumber lift) {
  for (const NodeDescription& node : description.nodes) {
    if (node.lift == lift) return node.bus;
  }
  return 0;
}

}  // namespace

LiftShaft::Parts::Parts(World& its_world, const LiftNetworkDescription& wanted, LiftNumber number,
                        ShaftHooks its_hooks)
    : world(its_world),
      description(wanted),
      lift(number),
      design(wanted.building.lift(number)),
      hooks(std::move(its_hooks)),
      bus(bus_of(wanted, number)),
      car(car_design(), Callback<Time()>::to<&Parts::now>(*this)),
      chain({.rated_speed_m_s = design.speed_m_s,
             .door_zone_m = design.door_zone_m,
             .final_limit_m = design.overtravel_m / 3,
             .is_bridged = !design.has_safety_chain}),
      real_car(1, Callback<Time()>::to<&Parts::now>(*this)),
      cell({.car_mass_kg = design.car.mass_kg}),
      lanterns(wanted.building.floors.size()) {
  plant = world.add_sleeping_plant(Callback<void(Time)>::to<&Parts::step>(*this));
  for (std::size_t i = 0; i < doors.size(); ++i) {
    const DoorDesign& door = design.door;
    doors.at(i) =
        std::make_unique<Door>(*this, DoorPlantOptions{.width_m = door.width_m,
                                                       .open_time_s = door.open_time_s,
                                                       .close_time_s = door.close_time_s});
    doors.at(i)->is_there = (design.doors >> i & 1U) != 0;
  }
  car.on_change(Callback<void()>::to<&Parts::kick>(*this));
  add_nodes();
  is_put_together = true;
}

CarPlantDesign LiftShaft::Parts::car_design() const {
  const CarDesign& of_car = design.car;
  return {.car_kg = of_car.mass_kg,
          .counterweight_kg = of_car.mass_kg + design.balance * of_car.rated_load_kg,
          .travel_m = description.building.top_m(),
          .overtravel_m = design.overtravel_m,
          .stretch_um_per_kg = of_car.rope_stretch_um_per_kg};
}

/// Something begins to move in another way, or will soon: all is looked at, now.
void LiftShaft::Parts::kick() {
  if (!is_put_together) return;
  looked_at_until = now() + watched_period;
  world.wake_before(plant, now());
}

SafetySight LiftShaft::Parts::safety_sight(Time at) {
  const CarPlant::Truth truth = car.truth();
  const double top_m = description.building.top_m();
  const double below_m = description.building.height_m(1) - truth.position_m;
  SafetySight sight{.from_floor_m = 1e9,
                    .beyond_m = std::max(below_m, truth.position_m - top_m),
                    .speed_m_s = std::abs(truth.velocity_m_s),
                    .gear_is_caught = truth.gear_is_caught};
  for (const Floor& floor : description.building.floors) {
    sight.from_floor_m = std::min(sight.from_floor_m, std::abs(floor.height_m - truth.position_m));
  }
  for (const auto& door : doors) {
    if (!door->is_there) continue;
    const bool is_closed = door->plant.contact_is_closed(at);
    if (!is_closed || !door->plant.is_locked(at)) sight.doors_are_locked = false;
    if (!is_closed) sight.is_a_door_open = true;
  }
  return sight;
}

/// What the safety chain lets the drive do from now on.
void LiftShaft::Parts::close_or_cut(Time at) {
  chain.look(safety_sight(at));
  const bool is_caught = car.truth().gear_is_caught;
  if (chain.wants_gear() && !is_caught) car.arrest();
  if (car.is_cut() == !chain.is_closed()) return;
  car.cut(!chain.is_closed());
  look_again(drive, drive_changed);
}

void LiftShaft::Parts::step(Time at) {
  close_or_cut(at);
  Time next = never;
  if (car.truth().velocity_m_s != 0 || at < looked_at_until) next = at + moving_period;
  for (const auto& door : doors) {
    if (door->plant.is_moving(at)) next = std::min(next, at + moving_period);
    next = std::min(next, door->plant.next_change(at));
  }
  if (next != never) world.wake_before(plant, next);
  if (hooks.changed) hooks.changed(lift);
}

/// A device is told that what it senses has changed.
void LiftShaft::Parts::look_again(std::size_t node, const std::function<void()>& changed) {
  if (node == no_node || !world.is_running(nodes[node].slot)) return;
  changed();
  world.touched(nodes[node].slot);
}

cia417::Detection LiftShaft::Parts::see(unsigned door) {
  const Door& seen = *doors.at(door - 1);
  if (!seen.is_there) return Detection::not_available;
  if (barrier_is_broken) return Detection::error;
  return seen.has_somebody || barrier_is_covered ? Detection::yes : Detection::no;
}

cia417::DoorHardware LiftShaft::Parts::Door::hardware() {
  cia417::DoorHardware made = behind;
  made.drive = Callback<void(const cia417::DoorDrive&, Time)>::to<&Door::drive>(*this);
  made.lock = Callback<void(bool, Time)>::to<&Door::lock>(*this);
  return made;
}

void LiftShaft::Parts::Door::drive(const cia417::DoorDrive& order, Time at) {
  behind.drive(order, at);
  shaft.kick();
}

void LiftShaft::Parts::Door::lock(bool locks, Time at) {
  behind.lock(locks, at);
  shaft.kick();
}

/// A lamp or display has changed.
void LiftShaft::Parts::shown(const NodeDescription& panel, const cia417::VirtualOutput& output,
                             const cia417::OutputView& view) {
  if (panel.kind == DeviceKind::landing_panel) return shown_at_landing(output, view);
  if (output.function == BasicFunction::standard_car_call) {
    const CallKey call{.lift = lift, .floor = view.sub_function};
    if (hooks.lamp) hooks.lamp(lift, call, view.on);
  }
  if (output.function == BasicFunction::special_indication) {
    constexpr std::uint8_t overload = cia417::sub_function_of(cia417::SpecialIndication::overload);
    // One display for all indications shows the last one that was told.
    if (output.sub_function != overload && output.sub_function != 0) return;
    overload_is_shown = view.on && view.sub_function == overload;
    kick();
  }
}

void LiftShaft::Parts::shown_at_landing(const cia417::VirtualOutput& output,
                                        const cia417::OutputView& view) {
  const std::size_t floor = output.floor;
  if (floor < 1 || floor > lanterns.size()) return;
  if (output.function == BasicFunction::hall_lantern) {
    lanterns[floor - 1] = direction_of(view);
    return kick();
  }
  if (output.function == BasicFunction::standard_destination_call && view.on && hooks.assigned) {
    // Several lifts: it will be one of them.
    const bool is_known = std::popcount(output.lifts) == 1;
    const int told = is_known ? std::countr_zero(output.lifts) + 1 : 0;
    return hooks.assigned(lift, {output.floor, output.sub_function}, static_cast<LiftNumber>(told));
  }
  if (output.function == BasicFunction::standard_hall_call && hooks.lamp) {
    const Direction direction =
        output.sub_function == cia417::hall_up ? Direction::up : Direction::down;
    hooks.lamp(lift, {.floor = output.floor, .direction = direction}, view.on);
  }
}

FloorNumber LiftShaft::Parts::floor_here() {
  return description.building.floor_near(car.truth().position_m, near_floor_m);
}

PanelInput LiftShaft::Parts::input_of(const CallKey& button) const {
  if (button.lift != 0) return {BasicFunction::standard_car_call, button.floor};
  if (button.to != no_floor) {
    return {BasicFunction::standard_destination_call, button.to, button.floor};
  }
  const bool is_up = button.direction == Direction::up;
  return {BasicFunction::standard_hall_call, is_up ? cia417::hall_up : cia417::hall_down,
          button.floor};
}

const LiftShaft::Parts::Panel* LiftShaft::Parts::panel_of(const CallKey& button) const {
  const auto found = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) {
    return panel.panel->find(input_of(button)).has_value();
  });
  return found == panels.end() ? nullptr : &*found;
}

/// By people on a played panel, or by a hand on a real one.
bool LiftShaft::Parts::is_turned(bool by_people, SpecialFunction key) const {
  return by_people || (real && real->keys().is_on(key));
}

LiftMode LiftShaft::Parts::mode() const {
  return controller == nullptr ? LiftMode::normal : controller->mode();
}

LiftShaft::LiftShaft(World& world, const LiftNetworkDescription& description, LiftNumber lift,
                     ShaftHooks hooks)
    : parts_(std::make_unique<Parts>(world, description, lift, std::move(hooks))) {}

LiftShaft::~LiftShaft() = default;

void LiftShaft::start() {
  for (const auto& node : parts_->nodes) parts_->world.start(node.slot);
  for (const auto& panel : parts_->panels) parts_->world.start(panel.panel->slot());
  const std::optional<SlotIndex> of_group = parts_->group_slot;
  if (of_group) parts_->world.start(*of_group);
}

bool LiftShaft::press(const CallKey& button, bool pressed) {
  const Parts::Panel* const panel = parts_->panel_of(button);
  if (panel == nullptr) return false;
  // Who may go there has the key, and holds it turned meanwhile.
  const std::optional<std::size_t> key = parts_->key_for(button);
  if (key) parts_->press_special(key_lock(*key), pressed);
  // A finger is on or off the contact whether there is power or not.
  panel->panel->press(panel->panel->find(parts_->input_of(button)).value_or(0), pressed);
  return parts_->world.is_running(panel->panel->slot());
}

/// Of a car call to a floor that is locked.
std::optional<std::size_t> LiftShaft::Parts::key_for(const CallKey& button) const {
  if (button.lift == 0) return std::nullopt;
  for (std::size_t key = 0; key < design.locked_by_key.size(); ++key) {
    if (has_floor(design.locked_by_key.at(key), button.floor)) return key;
  }
  return std::nullopt;
}

void LiftShaft::press_door_open(bool pressed) {
  parts_->door_open_is_held = pressed;
  parts_->press_special(cia417::SpecialFunction::door_open, pressed);
}

void LiftShaft::press_door_close(bool pressed) {
  parts_->press_special(cia417::SpecialFunction::door_close, pressed);
}

void LiftShaft::turn_fire_key(bool on) {
  parts_->fire_alarm = on;
  parts_->press_special(cia417::SpecialFunction::fire_service_enable, on);
  parts_->kick();
}

void LiftShaft::turn_brigade_key(bool on) {
  parts_->fire_brigade = on;
  parts_->press_special(cia417::SpecialFunction::fire_service, on);
  parts_->kick();
}

/// A button or key of the car, or of the fire floor.
void LiftShaft::Parts::press_special(cia417::SpecialFunction function, bool on) {
  const std::uint8_t number = cia417::sub_function_of(function);
  const FloorNumber fire_floor = description.service.fire_floor;
  for (const Panel& panel : panels) {
    auto input = panel.panel->find({BasicFunction::special_function, number});
    if (!input) input = panel.panel->find({BasicFunction::special_function, number, fire_floor});
    if (input) return panel.panel->press(*input, on);
  }
}

void LiftShaft::stand_in_door(DoorNumber number, bool is_in_the_way) {
  parts_->doors.at(number - std::size_t{1})->has_somebody = is_in_the_way;
  parts_->see_again(number);
}

/// Who stands in the doorway: people, or whoever a real light barrier sees.
void LiftShaft::Parts::see_again(DoorNumber number) {
  Door& door = *doors.at(number - std::size_t{1});
  door.plant.stand_in_way(now(), door.has_somebody || door.is_barred);
  look_again(door.unit, door.unit_changed);
  look_again(barrier, barrier_changed);
}

void LiftShaft::set_load(double mass_kg) {
  parts_->people_kg = mass_kg;
  parts_->weigh_again();
}

void LiftShaft::Parts::weigh_again() {
  const double mass_kg = weighed_kg();
  car.set_load(mass_kg);
  cell.set_load(mass_kg);
  look_again(load, load_changed);
  if (real_load) kick();
}

/// What people weigh, within what the signals of a real scale say of it.
double LiftShaft::Parts::weighed_kg() const {
  if (!real_load) return people_kg;
  const double rated_kg = design.car.rated_load_kg;
  const double overload_kg = rated_kg * design.car.overload_share;
  if (real_load->overload) return std::max(people_kg, overload_kg);
  const double least_kg = real_load->full ? rated_kg * full_share : 0;
  return std::clamp(people_kg, least_kg, overload_kg - 1);
}

Time LiftShaft::in_real_service_until(Time now) const {
  return parts_->real ? parts_->real->in_service_until(now) : Time{};
}

LiftFacts LiftShaft::facts(Time now) const {
  Parts& parts = *parts_;
  const CarPlant::Truth car = parts.car.truth();
  const CarPlantFaults& broken = parts.car.faults();
  const bool drifts = car.brake_is_closed && car.velocity_m_s != 0;
  LiftFacts facts{
      .position_m = car.position_m,
      .speed_m_s = car.velocity_m_s,
      .acceleration_m_s2 = car.acceleration_m_s2,
      .load_kg = parts.car.load_kg(),
      .emergency_stop = car.gear_is_caught || drifts,
      .is_cut = car.is_cut,
      .drifts = drifts,
      .is_unheld = broken.motor_runs_away || broken.brake_share == 0,
      .opens_by_hand = parts.is_turned(parts.door_open_is_held, SpecialFunction::door_open),
      .fire_floor = parts.description.service.fire_floor};
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const DoorPlant& door = parts.doors.at(i)->plant;
    facts.doors.at(i) = {.open_m = door.open_m(now), .locked = door.is_locked(now)};
    if (!parts.doors.at(i)->is_there) facts.doors.at(i) = {};
  }
  if (parts.is_turned(parts.fire_alarm, SpecialFunction::fire_service_enable)) {
    facts.fire = FireMode::recall;
  }
  if (parts.is_turned(parts.fire_brigade, SpecialFunction::fire_service)) {
    facts.fire = FireMode::brigade;
  }
  return facts;
}

CarView LiftShaft::view(Time now) const {
  Parts& parts = *parts_;
  CarView view{.overload = parts.overload_is_shown};
  const FloorNumber floor = parts.floor_here();
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const DoorPlant& door = parts.doors.at(i)->plant;
    const double open_m = door.open_m(now);
    if (!parts.doors.at(i)->is_there || open_m < open_least_m || floor == no_floor) continue;
    const bool is_wide = open_m >= walkable_share * parts.design.door.width_m;
    view.floor = floor;
    view.doorway = static_cast<DoorNumber>(i + 1);
    view.door = is_wide ? DoorView::open : DoorView::opening;
    if (door.speed_m_s(now) < 0) view.door = DoorView::closing;
    break;
  }
  if (floor != no_floor) view.direction = parts.lanterns[floor - std::size_t{1}];
  // People hear the alarm, and see the fire brigade; what a controller makes of it they do not
  // know.
  // That it is out of order its display shows.
  const bool is_out = parts.mode() == LiftMode::fault;
  view.accepts = !parts.fire_alarm && !parts.fire_brigade && !is_out;
  view.evacuates = parts.fire_alarm && !parts.fire_brigade;
  return view;
}

LiftSnapshot LiftShaft::snapshot(Time now) const {
  Parts& parts = *parts_;
  const CarPlant::Truth car = parts.car.truth();
  LiftSnapshot view{.position_m = car.position_m,
                    .speed_m_s = car.velocity_m_s,
                    .mode = parts.mode(),
                    .load_kg = parts.car.load_kg(),
                    .overload = parts.overload_is_shown,
                    .distance_m = car.way_m,
                    .energy_wh = (car.energy_in_joule - car.energy_out_joule) / joule_per_wh};
  double least_m = 1e9;
  for (std::size_t i = 1; i <= parts.description.building.floors.size(); ++i) {
    const auto floor = static_cast<FloorNumber>(i);
    const double away_m = std::abs(parts.description.building.height_m(floor) - car.position_m);
    if (away_m < least_m) view.nearest_floor = floor;
    least_m = std::min(least_m, away_m);
  }
  if (parts.controller != nullptr) view.direction = parts.controller->direction();
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const Parts::Door& door = *parts.doors.at(i);
    view.doors.at(i) = {.is_there = door.is_there,
                        .open_share = door.plant.open_m(now) / parts.design.door.width_m,
                        .locked = door.plant.is_locked(now),
                        .blocked = door.has_somebody || door.is_barred};
  }
  return view;
}

}  // namespace canvoy::lift
