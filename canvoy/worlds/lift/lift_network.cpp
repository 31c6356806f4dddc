#include "canvoy/worlds/lift/lift_network.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "canvoy/sim/fault_engine.hpp"
#include "canvoy/worlds/lift/fault_consequences.hpp"
#include "canvoy/worlds/lift/lift_devices.hpp"
#include "canvoy/worlds/lift/lift_event.hpp"
#include "canvoy/worlds/lift/lift_people.hpp"
#include "canvoy/worlds/lift/lift_referees.hpp"
#include "canvoy/worlds/lift/present_faults.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift {

// The faults of a plan in a building: it makes them in the devices and by fire brigades, mends
// them, and reports them as events and to the referee, with their required consequences.
//
//     LiftFaults faults(world, description, devices, people, referee, events);   // plans them all

class LiftFaults {
 public:
  /// All must outlive the last run of `world`; faults are noted in `events`.
  LiftFaults(World& world, const LiftNetworkDescription& description, LiftDevices& devices,
             LiftPeople& people, FaultReferee& referee, std::vector<LiftEvent>& events);
  LiftFaults(const LiftFaults&) = delete;
  LiftFaults& operator=(const LiftFaults&) = delete;

 private:
  using Engine = FaultEngine<FaultKind>;
  friend Engine;
  void began(std::size_t fault);
  void ended(std::size_t fault);
  void set(std::size_t fault, bool present);
  void set_one(const ScheduledFault& fault, bool present);
  template <class Act>
  void for_each_lift(ScheduledFault fault, const Act& act) const;

  World* world_;
  LiftDevices* devices_;
  LiftPeople* people_;
  FaultReferee* referee_;
  std::vector<LiftEvent>* events_;
  PresentFaults present_;
  FaultConsequences consequences_;
  Engine faults_;
};

LiftFaults::LiftFaults(World& world, const LiftNetworkDescription& description,
                       LiftDevices& devices, LiftPeople& people, FaultReferee& referee,
                       std::vector<LiftEvent>& events)
    : world_(&world),
      devices_(&devices),
      people_(&people),
      referee_(&referee),
      events_(&events),
      present_(description.faults.faults, devices),
      consequences_(world, description, devices, present_),
      faults_(description.faults.faults, Engine::of(*this), FaultMaking::by_world) {
  faults_.plan(world);
}

/// A fire alarm of all lifts counts as one of each; any other fault stays as it is.
template <class Act>
void LiftFaults::for_each_lift(ScheduledFault fault, const Act& act) const {
  if (fault.kind != FaultKind::fire_alarm || fault.part != 0) return act(fault);
  for (fault.part = 1; fault.part <= devices_->count(); ++fault.part) act(fault);
}

void LiftFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, devices_->place_of(it)}});
  for_each_lift(
      it, [&](const ScheduledFault& each) { referee_->began(now, fault, consequences_.of(each)); });
}

void LiftFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, devices_->place_of(it)}});
  referee_->ended(now, fault);
  present_.remove(fault);
}

void LiftFaults::set(std::size_t fault, bool present) {
  for_each_lift(faults_[fault], [&](const ScheduledFault& each) { set_one(each, present); });
  if (present) present_.add(fault);
}

void LiftFaults::set_one(const ScheduledFault& fault, bool present) {
  if (present_.has_like(fault)) return;
  const bool is_of_people = fault.kind == FaultKind::fire_brigade && fault.part != 0;
  if (is_of_people) return people_->call_brigade(fault.part, present);
  devices_->set_fault(fault, present);
}

namespace {

LiftSummary::Times times_of(const DurationSample& sample) {
  return {
      .mean = sample.mean(), .percentile_90 = sample.percentile(90), .longest = sample.longest()};
}

LandingSnapshot landing_of(const Crowd& crowd, FloorNumber floor, const CallLamps& lamps) {
  LandingSnapshot view;
  for (const PassengerId who : crowd.waiting(floor)) {
    ++(crowd.passengers()[who].wish.to > floor ? view.waiting_up : view.waiting_down);
  }
  view.lamp_up = lamps.is_lit({.floor = floor, .direction = Direction::up});
  view.lamp_down = lamps.is_lit({.floor = floor, .direction = Direction::down});
  return view;
}

/// For a pure up-peak of identical lifts from the lowest floor; 0: it is another one.
double formula_interval_s(const LiftNetworkDescription& description, double persons) {
  const Building& building = description.building;
  const bool is_up_peak = description.arrivals.empty() &&
                          description.traffic.pattern == TrafficPattern::up_peak &&
                          !description.people.destination_control;
  const LiftDesign& first = building.lifts.front();
  const bool are_alike =
      std::all_of(building.lifts.begin(), building.lifts.end(), [&](const LiftDesign& lift) {
        return lift.speed_m_s == first.speed_m_s && lift.jerk_m_s3 == first.jerk_m_s3 &&
               lift.acceleration_m_s2 == first.acceleration_m_s2 &&
               lift.door.open_time_s == first.door.open_time_s &&
               lift.door.close_time_s == first.door.close_time_s;
      });
  const bool is_plain = building.main_floor == 1 && building.floor_count() > 1 && are_alike;
  if (!is_up_peak || !is_plain || persons <= 0) return 0;
  return round_trip_time(round_trip_options(building, persons)).interval_s;
}

}  // namespace

/// Connects the parts: devices report events to referees and people, people report their actions to
/// referees, and faults act on devices and people. No other class knows all of them.
struct LiftNetwork::Parts {
  explicit Parts(LiftNetworkDescription wanted);

  LiftDevicesHooks of_devices();
  LiftPeopleHooks of_people();
  void car_changed(LiftNumber lift);
  void heard(Time now, const BusEvent& event);
  void look(Time now);

  LiftNetworkDescription description;
  World world;
  std::vector<LiftEvent> events;
  LiftDevices devices;
  LiftReferees referees;
  LiftPeople people;
  PlantIndex looking;
  LiftFaults faults;
};

LiftNetwork::Parts::Parts(LiftNetworkDescription wanted)
    : description(std::move(wanted)),
      devices(world, description, of_devices()),
      referees(description, devices, events),
      people(world, description, devices, of_people()),
      looking(world.add_plant(callback<&Parts::look>(*this), LiftReferees::look_period)),
      faults(world, description, devices, people, referees.faults(), events) {
  devices.start();
}

LiftDevicesHooks LiftNetwork::Parts::of_devices() {
  return {.shaft = {.changed = [this](LiftNumber lift) { car_changed(lift); },
                    .lamp =
                        [this](LiftNumber lift, const CallKey& call, bool is_lit) {
                          using enum CallLamps::Change;
                          const auto change =
                              referees.lamp_changed(world.now(), lift, call, is_lit);
                          if (change != none) people.lamp_changed(call, change == lit);
                        },
                    .assigned =
                        [this](LiftNumber panel, const DestinationButton& button, LiftNumber lift) {
                          referees.assigned(world.now(), panel, button, lift);
                          people.assigned(panel, button, lift);
                        },
                    .tripped =
                        [this](LiftNumber lift, SafetyChain::Trip trip) {
                          events.push_back({world.now(), ChainTripped{lift, trip}});
                          if (trip != SafetyChain::Trip::none) people.call_technician(lift);
                        }},
          .heard = [this](Time now, const BusEvent& event) { heard(now, event); }};
}

LiftPeopleHooks LiftNetwork::Parts::of_people() {
  return {.pressed = [this](const CallKey& call) { referees.pressed(world.now(), call); },
          .carried = [this](LiftNumber lift) { referees.carried(world.now(), lift); },
          .gave_up = [this](Time since) { referees.gave_up(world.now(), since); },
          .technician =
              [this](LiftNumber lift, TechnicianStep step, FloorNumber floor) {
                events.push_back({world.now(), TechnicianDid{lift, step, floor}});
                if (step == TechnicianStep::arrives)
                  referees.set_technician(world.now(), lift, true);
                if (step == TechnicianStep::leaves)
                  referees.set_technician(world.now(), lift, false);
              }};
}

void LiftNetwork::Parts::car_changed(LiftNumber lift) {
  const auto persons = static_cast<unsigned>(people.crowd().riding(lift).size());
  referees.car_changed(world.now(), lift, persons);
  people.car_changed(lift);
}

void LiftNetwork::Parts::heard(Time now, const BusEvent& event) {
  const auto note = [&]<class Seen>(const Seen& seen) {
    // The commands of the controllers show in the states that follow.
    if constexpr (!std::is_same_v<Seen, NmtCommandSeen>) events.push_back({now, seen});
  };
  std::visit(note, event);
  if (const auto* told = std::get_if<EmergencySeen>(&event)) referees.emergency_seen(now, *told);
}

void LiftNetwork::Parts::look(Time now) {
  people.look_for_brigades();
  people.look_for_technicians();
  const bool is_hindered = referees.is_anything_hindered(now);
  for (LiftNumber lift = 1; lift <= devices.count(); ++lift) car_changed(lift);
  referees.look(now, people, is_hindered);
  for (const LiftNumber lift : referees.take_complaints()) people.complain(lift);
}

LiftNetwork::LiftNetwork(const LiftNetworkDescription& description)
    : parts_(std::make_unique<Parts>(description)) {}

LiftNetwork::~LiftNetwork() = default;

void LiftNetwork::run_until(Time until) {
  parts_->world.run_until(until);
}
Time LiftNetwork::now() const {
  return parts_->world.now();
}
bool LiftNetwork::visit(FloorNumber from, FloorNumber to) {
  return parts_->people.visit(from, to);
}
bool LiftNetwork::observe(std::size_t bus, const BusTap& tap) {
  return parts_->devices.bus(bus).observe(tap);
}
std::optional<RefusedValue> LiftNetwork::refused() const {
  return parts_->devices.refused();
}
std::span<const LiftEvent> LiftNetwork::events() const {
  return parts_->events;
}
const LiftNetworkDescription& LiftNetwork::description() const {
  return parts_->description;
}
World& LiftNetwork::world() {
  return parts_->world;
}
LiftShaft& LiftNetwork::shaft(LiftNumber lift) {
  return parts_->devices.shaft(lift);
}
void LiftNetwork::note_hand(const HandActed& acted) {
  parts_->events.push_back({now(), acted});
}
std::vector<Invariant> LiftNetwork::invariants() const {
  return parts_->referees.invariants(now());
}

bool LiftNetwork::all_hold() const {
  const std::vector<Invariant> all = invariants();
  return std::all_of(all.begin(), all.end(),
                     [](const Invariant& invariant) { return invariant.held; });
}

LiftNetworkSnapshot LiftNetwork::snapshot() const {
  LiftDevices& devices = parts_->devices;
  const LiftReferees& seen = parts_->referees;
  const Crowd& crowd = parts_->people.crowd();
  LiftNetworkSnapshot view{.at = now()};
  for (LiftNumber lift = 1; lift <= devices.count(); ++lift) {
    LiftSnapshot look = devices.shaft(lift).snapshot(now());
    look.persons = static_cast<unsigned>(crowd.riding(lift).size());
    look.starts = seen.cars().starts(lift);
    look.car_calls = seen.lamps().car_calls(lift);
    view.lifts.push_back(std::move(look));
  }
  for (std::size_t i = 1; i <= description().building.floors.size(); ++i) {
    view.landings.push_back(landing_of(crowd, static_cast<FloorNumber>(i), seen.lamps()));
  }
  view.buses = devices.bus_snapshots();
  view.nodes = devices.node_snapshots();
  view.waiting = crowd.waiting_count();
  view.riding = crowd.riding_count();
  view.served = crowd.statistics().served_count();
  return view;
}

LiftSummary LiftNetwork::summary() const {
  const Crowd& crowd = parts_->people.crowd();
  const PassengerStatistics& people = crowd.statistics();
  LiftSummary account{.run = now() - Time{},
                      .arrived = crowd.passengers().size(),
                      .served = people.served_count(),
                      .gave_up = people.gave_up_count(),
                      .waiting = times_of(people.waiting()),
                      .to_destination = times_of(people.to_destination()),
                      .most_in_5_minutes = people.most_in_5_minutes(),
                      .interval_s = crowd.departures().interval_s(),
                      .persons_of_car = crowd.departures().persons_mean(),
                      .is_saturated = parts_->referees.is_saturated()};
  account.formula_interval_s = formula_interval_s(description(), account.persons_of_car);
  const LiftNetworkSnapshot view = snapshot();
  for (const LiftSnapshot& lift : view.lifts) {
    const LiftStatistics each{lift.starts, lift.distance_m, lift.energy_wh};
    const auto number = static_cast<LiftNumber>(account.lifts.size() + 1);
    const auto since = parts_->referees.cars().stands_since(number);
    account.lifts.push_back({.starts = each.starts,
                             .starts_an_hour = each.starts_an_hour(account.run),
                             .distance_m = each.distance_m,
                             .energy_wh = each.energy_wh,
                             .stands = since ? now() - *since : Duration{0},
                             .is_hindered = parts_->referees.is_out_of_use(now(), number)});
  }
  account.buses = view.buses;
  for (std::size_t bus = 0; bus < account.buses.size(); ++bus) {
    account.buses[bus].load = parts_->devices.bus(bus).load_total();
  }
  return account;
}

}  // namespace canvoy::lift
