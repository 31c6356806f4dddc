#include "canvoy/worlds/lift/lift_shaft.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "canvoy/worlds/lift/real_devices.hpp"
#include "canvoy/worlds/lift/shaft_panels.hpp"
#include "canvoy/worlds/lift/shaft_units.hpp"

namespace canvoy::lift {

namespace {

using cia417::SpecialFunction;

/// Period of looks at what moves.
constexpr Duration moving_period = 100ms;
/// A car with a command to move waits for its brake.
constexpr Duration watched_period = 1s;
/// People step in as soon as the door is open by this share of its width.
constexpr double walkable_share = 0.8;
constexpr double joule_per_wh = 3600;
/// Age of the position of a moving car when all devices have received it.
constexpr double position_age_s = 0.25;

}  // namespace

/// The plants, and the devices on them. It looks in time at what moves, and has the plants follow
/// real devices.
struct LiftShaft::Parts {
  Parts(World& its_world, const LiftNetworkDescription& description, LiftNumber number,
        ShaftHooks hooks);

  Time now() { return world.now(); }
  void follow_real_devices();
  RealDevices::Hands led_by_real_devices();
  void kick();
  void step(Time at);
  void watch_trip();
  bool is_whole() const;
  void reset_by_hand();
  void mend();
  void count_missing(const ScheduledFault& fault, bool present);
  void power(NodeId id, bool is_on);
  void set_door_fault(FaultKind kind, NodeId unit, bool present);
  ShaftDoor& door(DoorNumber number) { return *doors.at(number - std::size_t{1}); }
  /// By people on a simulated panel, or by a hand on a real one.
  bool is_turned(SpecialFunction key) const {
    return panels.is_held(key) || (real && real->keys().is_on(key));
  }
  LiftMode mode() const {
    return units.controller() == nullptr ? LiftMode::normal : units.controller()->mode();
  }

  World& world;
  ShaftPlan plan;
  std::function<void(LiftNumber)> changed;
  std::function<void(LiftNumber, SafetyChain::Trip)> reported_of_trip;
  PlantIndex plant;
  ShaftCar car;
  ShaftDoors doors;
  ShaftLightBarrier barrier;
  ShaftLoad load;
  ShaftNodes nodes;
  ShaftPanels panels;
  ShaftUnits units;
  InspectionStations stations{panels, units};
  std::unique_ptr<RealDevices> real{};
  Time looked_at_until{};                            ///< something has just changed
  SafetyChain::Trip trip = SafetyChain::Trip::none;  ///< last reported one
  bool has_technician = false;
  bool is_door_held = false;
  unsigned fire_alarms = 0;
  unsigned missing_parts = 0;        ///< faults of parts without which it cannot run
  std::set<NodeId> without_power{};  ///< by faults
  std::optional<double> said_m{};    ///< position of the car by a real position unit
  bool is_put_together = false;
};

LiftShaft::Parts::Parts(World& its_world, const LiftNetworkDescription& description,
                        LiftNumber number, ShaftHooks hooks)
    : world(its_world),
      plan(description, number),
      changed(std::move(hooks.changed)),
      reported_of_trip(std::move(hooks.tripped)),
      plant(world.add_sleeping_plant(callback<&Parts::step>(*this))),
      car(description.building, number, callback<&Parts::now>(*this)),
      doors(doors_of(plan.design(), callback<&Parts::kick>(*this))),
      barrier(doors),
      load(plan.design().car, car.plant()),
      nodes(world, plan.bus()),
      panels(world, plan, nodes, {std::move(hooks.lamp), std::move(hooks.assigned)},
             callback<&Parts::kick>(*this)),
      units(world, plan, {car, doors, barrier, load}, nodes) {
  car.plant().on_change(callback<&Parts::kick>(*this));
  for (const NodeDescription* node : plan.nodes()) {
    if (!node->played) continue;
    is_panel(node->kind) ? panels.add(*node) : units.add(*node);
  }
  follow_real_devices();
  is_put_together = true;
}

/// The plants follow the reports of real devices: the car moves as the drive reports.
void LiftShaft::Parts::follow_real_devices() {
  const RealDevices::Wanted wanted = plan.real_devices();
  if (!wanted.any()) return;
  real = std::make_unique<RealDevices>(wanted, led_by_real_devices());
  const SlotIndex slot = world.add_slot(plan.bus(), {.accept_all = true});
  world.occupy(slot, *real);
  world.start(slot);
  if (wanted.drive) car.follow_real_drive();
}

RealDevices::Hands LiftShaft::Parts::led_by_real_devices() {
  return {.door =
              [this](DoorNumber number, const cia417::DoorReport& said,
                     std::optional<std::uint16_t> position_mm) {
                door(number).lead(now(), said, position_mm);
                kick();
              },
          .light_barrier =
              [this](DoorNumber number, cia417::Detection seen) {
                door(number).bar(now(), seen == cia417::Detection::yes);
                barrier.look_again();
              },
          .load =
              [this](const LoadSaid& said) {
                load.lead(said);
                kick();
              },
          .position = [this](double position_m) { said_m = position_m; },
          .drive =
              [this](const Frame& frame) {
                if (car.hear(frame)) kick();
              },
          .keys = [this] { kick(); }};
}

/// A motion changes, or will soon: all is looked at, at once.
void LiftShaft::Parts::kick() {
  if (!is_put_together) return;
  looked_at_until = now() + watched_period;
  world.wake_before(plant, now());
}

void LiftShaft::Parts::step(Time at) {
  car.look_at_chain(at, doors);
  watch_trip();
  Time next = never;
  if (car.plant().truth().velocity_m_s != 0 || at < looked_at_until) next = at + moving_period;
  for (const auto& each : doors) {
    if (each->plant().is_moving(at)) next = std::min(next, at + moving_period);
    next = std::min(next, each->plant().next_change(at));
  }
  if (next != never) world.wake_before(plant, next);
  if (changed) changed(plan.lift());
}

void LiftShaft::Parts::watch_trip() {
  if (std::exchange(trip, car.trip()) == car.trip()) return;
  if (reported_of_trip) reported_of_trip(plan.lift(), trip);
}

bool LiftShaft::Parts::is_whole() const {
  return car.is_whole() &&
         std::ranges::all_of(doors, [](const auto& each) { return each->is_whole(); });
}

/// The person who mends the last defect is at the car, and resets what has caught it; for a final
/// limit, or a brake that has slipped, a technician is called.
void LiftShaft::Parts::mend() {
  if (car.trip() != SafetyChain::Trip::final_limit) return reset_by_hand();
  kick();
}

void LiftShaft::Parts::count_missing(const ScheduledFault& fault, bool present) {
  const bool is_of_part =
      fault.kind == FaultKind::dead_encoder || fault.kind == FaultKind::rope_sensor ||
      fault.kind == FaultKind::cable_cut || fault.kind == FaultKind::babbling_node;
  const NodeId id = plan.node_of(fault);
  const bool is_lost = fault.kind == FaultKind::lost_node && plan.needs(id);
  if (is_of_part || is_lost) present ? ++missing_parts : --missing_parts;
}

void LiftShaft::Parts::power(NodeId id, bool is_on) {
  nodes.power(id, is_on);
  if (is_on && nodes.is_a(DeviceKind::lift_controller, id)) stations.report_again();
  if (is_on) return;
  panels.go_dark(id);
  if (nodes.is_a(DeviceKind::drive, id)) car.lose_drive();
}

void LiftShaft::Parts::reset_by_hand() {
  if (is_whole()) car.reset_by_hand();
  kick();
}

LiftShaft::LiftShaft(World& world, const LiftNetworkDescription& description, LiftNumber lift,
                     ShaftHooks hooks)
    : parts_(std::make_unique<Parts>(world, description, lift, std::move(hooks))) {}

LiftShaft::~LiftShaft() = default;

void LiftShaft::join_group(BusIndex group_bus, NodeId group_controller) {
  parts_->units.join_group(group_bus, group_controller);
}

void LiftShaft::start() {
  parts_->nodes.start();
}

bool LiftShaft::press(const CallKey& button, bool pressed) {
  return parts_->panels.press(button, pressed);
}

void LiftShaft::press_door_open(bool pressed) {
  parts_->panels.press(SpecialFunction::door_open, pressed);
}

void LiftShaft::press_door_close(bool pressed) {
  parts_->panels.press(SpecialFunction::door_close, pressed);
}

void LiftShaft::turn_fire_key(bool on) {
  on ? ++parts_->fire_alarms : --parts_->fire_alarms;
  parts_->panels.press(SpecialFunction::fire_service_enable, parts_->fire_alarms != 0);
  parts_->kick();
}

void LiftShaft::turn_brigade_key(bool on) {
  parts_->panels.press(SpecialFunction::fire_service, on);
  parts_->kick();
}

void LiftShaft::stand_in_door(DoorNumber door, bool is_in_the_way) {
  parts_->door(door).stand_in_way(parts_->now(), is_in_the_way);
  parts_->barrier.look_again();
}

void LiftShaft::set_load(double mass_kg) {
  parts_->load.set_people(mass_kg);
  if (parts_->load.is_led()) parts_->kick();
}

void LiftShaft::press_stop(bool is_pressed) {
  parts_->has_technician = is_pressed;
  parts_->car.press_stop(is_pressed);
  parts_->kick();
}

bool LiftShaft::crank(double metre_per_second) {
  const bool is_moved = parts_->car.crank(metre_per_second);
  parts_->kick();
  return is_moved;
}

void LiftShaft::hold_door(bool is_held) {
  parts_->is_door_held = is_held;
  parts_->kick();
}

void LiftShaft::reset_by_hand() {
  if (parts_->is_whole()) parts_->car.reset_brake();
  parts_->reset_by_hand();
}

void LiftShaft::turn_inspection(Station station, bool on) {
  parts_->stations.turn(station, on);
  parts_->kick();
}

void LiftShaft::hold_inspection(Station station, Direction way) {
  parts_->stations.hold(station, way);
  parts_->kick();
}

void LiftShaft::restart() {
  constexpr Duration off_time = 2s;
  for (const DeviceKind kind : {DeviceKind::lift_controller, DeviceKind::drive}) {
    const std::optional<NodeId> id = parts_->plan.id_of(kind);
    if (!id) continue;
    parts_->power(*id, false);
    parts_->world.at(parts_->now() + off_time, [this, id](Time) {
      if (!parts_->without_power.contains(*id)) parts_->power(*id, true);
    });
  }
  parts_->kick();
}

bool LiftShaft::is_whole() const {
  return parts_->is_whole() && parts_->missing_parts == 0;
}

LiftMode LiftShaft::snapshot_mode() const {
  return parts_->mode();
}

SafetyChain::Trip LiftShaft::trip() const {
  return parts_->car.trip();
}

Time LiftShaft::in_real_service_until(Time now) const {
  return parts_->real ? parts_->real->in_service_until(now) : Time{};
}

LiftFacts LiftShaft::facts(Time now) const {
  Parts& parts = *parts_;
  const CarPlant::Truth car = parts.car.plant().truth();
  const bool drifts = ShaftCar::drifts(car);
  LiftFacts facts{.position_m = car.position_m,
                  .speed_m_s = car.velocity_m_s,
                  .acceleration_m_s2 = car.acceleration_m_s2,
                  .load_kg = parts.car.plant().load_kg(),
                  .emergency_stop = car.gear_is_caught || drifts,
                  .is_cut = car.is_cut,
                  .drifts = drifts,
                  .is_unheld = parts.car.is_unheld(),
                  .is_cranked = car.is_cranked,
                  .brake_slips = car.brake_slips,
                  .is_inspected = parts.stations.is_on(),
                  .inspection_way = parts.stations.held(),
                  .opens_by_hand = parts.is_turned(SpecialFunction::door_open),
                  .fire_floor = parts.plan.service().fire_floor};
  const FloorNumber floor =
      parts.plan.building().floor_near(car.position_m, parts.plan.design().door_zone_m);
  if (floor != no_floor) facts.misnamed_since = parts.panels.misnamed_since(floor);
  if (parts.said_m) {
    const double away_m = std::abs(*parts.said_m - car.position_m);
    facts.position_lie_m = std::max(0.0, away_m - position_age_s * std::abs(car.velocity_m_s));
  }
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const ShaftDoor& door = *parts.doors.at(i);
    if (!door.is_there()) continue;
    facts.doors.at(i) = {.open_m = door.plant().open_m(now), .locked = door.plant().is_locked(now)};
  }
  if (parts.is_turned(SpecialFunction::fire_service_enable)) facts.fire = FireMode::recall;
  if (parts.is_turned(SpecialFunction::fire_service)) facts.fire = FireMode::brigade;
  return facts;
}

CarView LiftShaft::view(Time now) const {
  Parts& parts = *parts_;
  CarView view{.overload = parts.panels.shows_overload()};
  const FloorNumber floor = parts.car.floor();
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const ShaftDoor& door = *parts.doors.at(i);
    const double open_m = door.plant().open_m(now);
    if (!door.is_there() || open_m < open_least_m || floor == no_floor) continue;
    const bool is_wide = open_m >= walkable_share * parts.plan.design().door.width_m;
    view.floor = floor;
    view.doorway = static_cast<DoorNumber>(i + 1);
    view.door = is_wide ? DoorView::open : DoorView::opening;
    if (door.plant().speed_m_s(now) < 0) view.door = DoorView::closing;
    break;
  }
  if (parts.is_door_held && floor != no_floor) {
    view.floor = floor;
    view.doorway = parts.plan.lowest_door();
    view.door = DoorView::open;
  }
  if (floor != no_floor) view.direction = parts.panels.lantern(floor);
  // People hear the alarm, and see the fire brigade, but not the state of the controller.
  const bool is_alarm = parts.panels.is_held(SpecialFunction::fire_service_enable);
  const bool is_brigade_there = parts.panels.is_held(SpecialFunction::fire_service);
  // Its display shows that it is out of order.
  const bool is_out = parts.mode() == LiftMode::fault;
  const bool has_technician = parts.has_technician || parts.stations.is_on();
  view.accepts = !is_alarm && !is_brigade_there && !is_out && !has_technician;
  view.evacuates = (is_alarm && !is_brigade_there) || has_technician;
  return view;
}

LiftSnapshot LiftShaft::snapshot(Time now) const {
  Parts& parts = *parts_;
  const CarPlant::Truth car = parts.car.plant().look();
  LiftSnapshot view{.position_m = car.position_m,
                    .speed_m_s = car.velocity_m_s,
                    .mode = parts.mode(),
                    .load_kg = parts.car.plant().load_kg(),
                    .overload = parts.panels.shows_overload(),
                    .distance_m = car.way_m,
                    .energy_wh = (car.energy_in_joule - car.energy_out_joule) / joule_per_wh};
  const Building& building = parts.plan.building();
  double least_m = 1e9;
  for (std::size_t i = 1; i <= building.floors.size(); ++i) {
    const auto floor = static_cast<FloorNumber>(i);
    const double away_m = std::abs(building.height_m(floor) - car.position_m);
    if (away_m < least_m) view.nearest_floor = floor;
    least_m = std::min(least_m, away_m);
  }
  const ShaftController* const controller = parts.units.controller();
  if (controller != nullptr) view.direction = controller->direction();
  for (std::size_t i = 0; i < parts.doors.size(); ++i) {
    const ShaftDoor& door = *parts.doors.at(i);
    view.doors.at(i) = {.is_there = door.is_there(),
                        .open_share = door.plant().open_m(now) / parts.plan.design().door.width_m,
                        .locked = door.plant().is_locked(now),
                        .blocked = door.is_blocked()};
  }
  return view;
}

void LiftShaft::set_fault(const ScheduledFault& fault, bool present) {
  Parts& parts = *parts_;
  const NodeId id = node_of(fault);
  parts.count_missing(fault, present);
  switch (fault.kind) {
    case FaultKind::lost_node:
      present ? void(parts.without_power.insert(id)) : void(parts.without_power.erase(id));
      return parts.power(id, !present);
    case FaultKind::cable_cut:
      return present ? parts.nodes.cut_cable(id) : parts.nodes.mend_cable();
    case FaultKind::babbling_node:
      return parts.nodes.babble(id, present);
    case FaultKind::stuck_button:
      return parts.panels.stick(parts.plan.stuck_button(fault), present);
    case FaultKind::light_barrier:
      return parts.barrier.break_down(present);
    case FaultKind::smoke:
      parts.barrier.cover(present);
      return parts.units.smoke_in_car(present);
    case FaultKind::rope_sensor:
      return parts.load.break_sensor(present);
    case FaultKind::fire_alarm:
      return turn_fire_key(present);
    case FaultKind::dead_encoder:
      return parts.car.set_fault(fault.kind, present);
    case FaultKind::finger_protector:
    case FaultKind::motion_detector:
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
      return parts.set_door_fault(fault.kind, id, present);
    case FaultKind::brake:
    case FaultKind::weak_brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      parts.car.set_fault(fault.kind, present);
      return present ? parts.kick() : parts.mend();
    case FaultKind::fire_brigade:  // done by people, with the keys
      return;
  }
}

/// An opened safety chain of a door is reset by the person who mends it.
void LiftShaft::Parts::set_door_fault(FaultKind kind, NodeId unit, bool present) {
  const auto found = std::ranges::find_if(
      doors, [unit](const auto& each) { return unit != 0 && each->unit() == unit; });
  if (found != doors.end()) (*found)->set_fault(now(), kind, present);
  const bool is_of_chain = kind == FaultKind::door_lock || kind == FaultKind::safety_contact;
  if (is_of_chain) present ? kick() : mend();
}

bool LiftShaft::would_drift() const {
  return parts_->car.plant().would_drift();
}

NodeId LiftShaft::node_of(const ScheduledFault& fault) const {
  if (fault.kind != FaultKind::stuck_button) return parts_->plan.node_of(fault);
  return parts_->panels.with(parts_->plan.stuck_button(fault));
}

bool LiftShaft::has_stuck_button(const ScheduledFault& fault) const {
  return parts_->panels.with(parts_->plan.stuck_button(fault)) != 0;
}

std::optional<SlotIndex> LiftShaft::group_slot() const {
  return parts_->nodes.group_slot();
}

std::optional<SlotIndex> LiftShaft::slot(NodeId node) const {
  return parts_->nodes.slot(node);
}

ShaftPlants LiftShaft::plants() {
  return {parts_->car, parts_->doors, parts_->barrier, parts_->load};
}

void LiftShaft::look() {
  parts_->kick();
}

LiftPanel* LiftShaft::panel(NodeId id) {
  return parts_->panels.panel(id);
}

ShaftSensors* LiftShaft::sensors(NodeId id) {
  return parts_->units.sensors(id);
}

Node* LiftShaft::node(NodeId id) {
  return parts_->nodes.node(id);
}

}  // namespace canvoy::lift
