// Making the faults of the plan, mending them, and what each must bring about.
#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <utility>

#include "canvoy/canopen/emergency/error.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/sim/lift/lift_network_state.hpp"
#include "canvoy/sim/lift/lift_panel.hpp"
#include "canvoy/sim/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

using canvoy::emergency_code::heartbeat;
constexpr std::uint16_t hardware_error = 0x5000;  ///< of an encoder
using cia417::emergency_code::application_error;
using cia417::emergency_code::finger_protector_defect;
using cia417::emergency_code::light_barrier_defect;
using cia417::emergency_code::motion_detection_defect;
using cia417::emergency_code::overspeed;
using cia417::emergency_code::unintended_car_movement;
/// Of heartbeats 1.5 s; the rest is the way to a stop.
constexpr Duration stands_most = 10s;
/// After a fault: the devices boot, the car finds out where it is, and goes to a floor.
constexpr Duration gets_ready_most = 60s;
/// So many get in or out where a car stops that people have waited for.
constexpr double transfers_of_stop = 4;
/// In a group others may bring them, and one that is not needed is idle for a while.
constexpr Duration idle_most = 30min;
/// Nobody can know of a lost node before its heartbeat is late.
constexpr Duration loss_noticed = 2s;
/// Panels send the first one so late.
constexpr Duration first_heartbeat = 2s;
/// What a unit tells by itself takes a moment of sensing, a frame, and the end of a start.
constexpr Duration error_noticed = 300ms;
/// The safety chain acts at once, and a safety gear takes a second at most.
constexpr Duration chain_stops_most = 2s;
/// A drive finds out that the car moves where it should not, or too fast.
constexpr Duration movement_noticed = 2s;
/// What shows where a car arrives takes a trip: that ropes have slipped, or that no brake holds it.
constexpr Duration arrives_first = 60s;
/// Surely not levelling, and with so much way left that a tenth of it is more than a tolerance.
constexpr double travelling_m_s = 0.5;
/// Of the rated speed: from here a motor that runs away is too fast before it is off its profile.
constexpr double nearly_rated = 0.95;

/// Lifts that have lost their group serve alone; a call that was on its way to it is made anew.
constexpr Duration regroups_within = 10s;
/// Terminals show it to who asks anew alone, where he is told another lift than theirs.
constexpr Duration regroups_at_terminals_within = 3min;

/// A hall call of no lift.
const Frame group_babble = Frame::data_frame(0x480, {0, 0, 0, 0, 0, 0});

/// What a lift cannot do without: these units, and its controller.
bool is_needed(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::lift_controller:
    case DeviceKind::drive:
    case DeviceKind::position:
    case DeviceKind::door:
    case DeviceKind::load:
      return true;
    default:
      return false;
  }
}

void must_stand(FaultExpectation& expected, Duration noticed_within) {
  expected.stands_within = stands_most;
  expected.noticed_within = noticed_within;
}

}  // namespace

/// Of one instant, what begins comes before what ends: a fault that takes over from one of its kind
/// leaves no pause, in which nobody could notice anything.
void LiftNetwork::State::plan_faults() {
  for (std::size_t i = 0; i < description.faults.size(); ++i) {
    world.at(description.faults[i].start, [this, i](Time) { set_fault(i, true); });
  }
  for (std::size_t i = 0; i < description.faults.size(); ++i) {
    const Time end = description.faults[i].end();
    if (end != never) world.at(end, [this, i](Time) { set_fault(i, false); });
  }
}

void LiftNetwork::State::set_fault(std::size_t number, bool present) {
  const ScheduledFault& fault = description.faults[number];
  const Time now = world.now();
  if (present) {
    events.push_back({now, FaultBegan{number, fault.kind, place_of(fault)}});
    expect(number);
  } else {
    events.push_back({now, FaultEnded{number, fault.kind, place_of(fault)}});
    fault_referee.ended(now, number);
    std::erase(present_faults, number);
  }
  make_fault(fault, present);
  if (present) present_faults.push_back(number);
}

/// What is broken already does not break once more, and is not mended before the last of these
/// faults is over.
void LiftNetwork::State::make_fault(ScheduledFault fault, bool present) {
  if (fault.kind == FaultKind::fire_alarm && fault.lift == 0) {
    for (fault.lift = 1; fault.lift <= shafts.size(); ++fault.lift) make_fault(fault, present);
    return;
  }
  if (is_there(fault)) return;
  if (fault.lift == 0) return set_group_fault(fault, present);
  if (fault.kind == FaultKind::fire_brigade) {
    FireBrigade& brigade = *brigades[fault.lift - std::size_t{1}];
    return present ? brigade.begin(world.now()) : brigade.end();
  }
  shaft(fault.lift).set_fault(fault, present);
}

/// By another fault of the plan. A cable has one cut at a time, wherever it is.
bool LiftNetwork::State::is_there(const ScheduledFault& fault) const {
  return std::ranges::any_of(present_faults, [&](std::size_t number) {
    const ScheduledFault& other = description.faults[number];
    if (other.kind != fault.kind) return false;
    if (fault.kind == FaultKind::fire_alarm) return other.lift == 0 || other.lift == fault.lift;
    if (other.lift != fault.lift) return false;
    if (fault.kind == FaultKind::cable_cut) return true;
    return place_of(other).node == place_of(fault).node && other.floor == fault.floor;
  });
}

/// Nobody can miss the heartbeats that this fault takes: none has come yet (CiA 301, 7.2.8.3.2.2),
/// or another fault of the plan has taken them already, from all, from the nodes behind a cut, or
/// from who would tell.
bool LiftNetwork::State::is_silenced(const ScheduledFault& fault) const {
  const auto takes_heartbeats = [](FaultKind kind) {
    return kind == FaultKind::lost_node || kind == FaultKind::cable_cut ||
           kind == FaultKind::babbling_node;
  };
  if (!takes_heartbeats(fault.kind)) return false;
  if (fault.start < Time(first_heartbeat)) return true;
  return std::ranges::any_of(present_faults, [&](std::size_t number) {
    const ScheduledFault& other = description.faults[number];
    if (other.lift != fault.lift || !takes_heartbeats(other.kind)) return false;
    if (fault.lift == 0 || other.kind == FaultKind::babbling_node) return true;
    if (other.kind == FaultKind::lost_node) return place_of(other).node == node_id::lift_controller;
    return fault.kind == FaultKind::lost_node && is_behind(place_of(fault).node, other);
  });
}

/// A motor that should run away, or ropes that should slip, and the plan takes the current before
/// anybody can have noticed.
bool LiftNetwork::State::has_no_current(const ScheduledFault& fault) const {
  if (fault.kind != FaultKind::runaway && fault.kind != FaultKind::rope_slip) return false;
  return std::ranges::any_of(description.faults, [&](const ScheduledFault& other) {
    const bool takes_it =
        other.kind == FaultKind::door_lock || other.kind == FaultKind::safety_contact ||
        (other.kind == FaultKind::lost_node && place_of(other).node == place_of(fault).node);
    return takes_it && other.lift == fault.lift && other.start <= fault.start + movement_noticed &&
           other.end() > fault.start;
  });
}

/// Nodes stand on the cable in the order of their description; the real bus is at its end.
bool LiftNetwork::State::is_behind(NodeId node, const ScheduledFault& cut) const {
  bool is_behind = false;
  for (const NodeDescription& each : description.nodes) {
    if (each.lift != cut.lift || each.kind == DeviceKind::group_controller) continue;
    if (each.id == node) return is_behind || !each.played;
    is_behind = is_behind || each.id == cut.node;
  }
  return false;
}

void LiftNetwork::State::expect(std::size_t number) {
  ScheduledFault fault = description.faults[number];
  const auto began = [&] {
    FaultExpectation expected = expectation_of(fault);
    // Nobody tells twice of what is there.
    if (is_there(fault) || is_silenced(fault)) expected.emergencies.clear();
    // A second cut does not come about: the first one may have left all that a car needs.
    if (is_there(fault) && fault.kind == FaultKind::cable_cut) {
      expected.stands_within = expected.noticed_within = std::nullopt;
    }
    if (has_no_current(fault)) {
      expected.emergencies.clear();
      expected.stands_within = expected.noticed_within = std::nullopt;
    }
    fault_referee.began(world.now(), number, expected);
  };
  const bool is_of_all = fault.kind == FaultKind::fire_alarm && fault.lift == 0;
  if (!is_of_all) return began();
  for (fault.lift = 1; fault.lift <= shafts.size(); ++fault.lift) began();
}

FaultPlace LiftNetwork::State::place_of(const ScheduledFault& fault) const {
  FaultPlace place{.part = fault.lift};
  if (fault.kind == FaultKind::fire_alarm && fault.lift == 0) return place;
  if (fault.lift != 0) place.node = shaft(fault.lift).node_of(fault);
  for (const NodeDescription& node : description.nodes) {
    const bool is_of_group = node.kind == DeviceKind::group_controller;
    if (is_of_group != (fault.lift == 0) || (!is_of_group && node.lift != fault.lift)) continue;
    place.bus = node.bus;
    if (is_of_group) place.node = fault.node != 0 ? fault.node : node.id;
  }
  return place;
}

/// A node on the bus of the group: its controller (0 as well), or the second one of a lift.
std::optional<SlotIndex> LiftNetwork::State::group_slot(NodeId node) const {
  if (!group) return std::nullopt;
  if (node >= 1 && node <= shafts.size()) return shaft(node).group_slot();
  return group->slot();
}

void LiftNetwork::State::set_group_fault(const ScheduledFault& fault, bool present) {
  const std::optional<SlotIndex> slot = group_slot(fault.node);
  if (!slot) return;
  SimulatedBus& bus = world.bus(group->bus());
  const ControllerId controller = world.controller(*slot);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return present ? world.stop(group->slot()) : world.start(group->slot());
    case FaultKind::cable_cut:
      return present ? bus.cut_cable(controller) : bus.mend_cable();
    case FaultKind::babbling_node:
      if (present) {
        bus.babble(controller, group_babble);
      } else {
        bus.stop_babbling(controller);
      }
      return;
    default:
      return;
  }
}

/// Of the nodes that this fault takes from the lift.
LiftNetwork::State::Loss LiftNetwork::State::loss_of(const ScheduledFault& fault) const {
  if (fault.node == 0) return Loss::needed;
  Loss loss = Loss::none;
  for (const NodeDescription& node : description.nodes) {
    if (node.lift != fault.lift || node.kind == DeviceKind::group_controller) continue;
    const bool is_cut = fault.kind == FaultKind::cable_cut;
    const bool is_lost = is_cut ? is_behind(node.id, fault) : node.id == fault.node;
    if (is_lost && is_needed(node.kind)) return Loss::needed;
    if (is_lost) loss = Loss::bearable;
  }
  return loss;
}

/// Nobody needs a group to be carried: no car has to stand.
FaultExpectation LiftNetwork::State::group_expectation_of(const ScheduledFault& fault) const {
  FaultExpectation expected{.lift = 0, .hinders_for = regroups_within};
  // Its controller stands at the end of the cable, lifts come after it.
  const bool is_cut = fault.kind == FaultKind::cable_cut && fault.node != shafts.size();
  const bool is_silent = fault.kind == FaultKind::lost_node || is_cut;
  if (!is_silent && fault.kind != FaultKind::babbling_node) return expected;
  expected.emergencies = {heartbeat};
  expected.serves_within =
      description.people.destination_control ? regroups_at_terminals_within : regroups_within;
  return expected;
}

/// The panels of several lifts show one call: who is alone shows those of its own panels.
bool LiftNetwork::State::serves_as_group() const {
  return std::ranges::any_of(
      lit, [](const auto& call) { return call.first.lift == 0 && std::popcount(call.second) > 1; });
}

/// What opens the safety chain of a car on its way, and what makes it move as it should not.
void LiftNetwork::State::expect_of_motion(FaultExpectation& expected,
                                          const ScheduledFault& fault) const {
  const LiftShaft& lift = shaft(fault.lift);
  const double speed = std::abs(lift.snapshot(world.now()).speed_m_s);
  const bool travels = speed >= travelling_m_s;
  const auto stops = [&](std::vector<std::uint16_t> codes, Duration noticed) {
    expected.emergencies = std::move(codes);
    expected.stands_within = chain_stops_most;
    expected.noticed_within = noticed;
  };
  switch (fault.kind) {
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
      expected.stands_within = chain_stops_most;
      expected.noticed_within = error_noticed;
      if (travels) expected.emergencies = {application_error};
      break;
    case FaultKind::brake:
      if (!lift.would_drift()) break;
      // A drive that boots in a car that moves already has not seen it stand.
      stops({unintended_car_movement, overspeed}, movement_noticed);
      // A motor that levels the car, or goes on, holds it meanwhile.
      expected.noticed_when_told = true;
      expected.told_within = arrives_first;
      break;
    case FaultKind::runaway:
      if (speed >= nearly_rated * description.building.lift(fault.lift).speed_m_s) {
        stops({overspeed}, movement_noticed);
      }
      break;
    default:
      if (!travels) break;
      expected.emergencies = {application_error};
      expected.told_within = arrives_first;
      break;
  }
}

/// Of the time in which people want it, until the first of them has got to where he wants: whoever
/// it is has boarded and left within a round with a stop at each floor, up and down.
Duration LiftNetwork::State::serves_most(LiftNumber lift) const {
  const Building& building = description.building;
  const LiftDesign& design = building.lift(lift);
  const unsigned ways = building.floor_count() - 1U;
  const Flight flight{design.speed_m_s, design.acceleration_m_s2, design.jerk_m_s3};
  const double stop_s = flight_time_s(flight, building.top_m() / ways) + design.door.open_time_s +
                        design.door.close_time_s +
                        transfers_of_stop * in_seconds(description.people.transfer);
  return gets_ready_most + std::chrono::seconds(std::lround(2 * ways * stop_s));
}

FaultExpectation LiftNetwork::State::expectation_of(const ScheduledFault& fault) const {
  if (fault.lift == 0) return group_expectation_of(fault);
  FaultExpectation expected{
      .lift = fault.lift, .serves_within = shafts.size() > 1 ? idle_most : serves_most(fault.lift)};
  switch (fault.kind) {
    case FaultKind::lost_node:
    case FaultKind::cable_cut: {
      const Loss loss = loss_of(fault);
      if (loss != Loss::none) expected.emergencies = {heartbeat};
      if (loss == Loss::needed) must_stand(expected, loss_noticed);
      break;
    }
    case FaultKind::dead_encoder:
      expected.emergencies = {hardware_error};
      must_stand(expected, error_noticed);
      break;
    case FaultKind::light_barrier:
      expected.emergencies = {light_barrier_defect};
      break;
    case FaultKind::finger_protector:
      expected.emergencies = {finger_protector_defect};
      break;
    case FaultKind::motion_detector:
      expected.emergencies = {motion_detection_defect};
      break;
    case FaultKind::rope_sensor:
      expected.emergencies = {application_error};
      must_stand(expected, error_noticed);
      break;
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
    case FaultKind::brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      expect_of_motion(expected, fault);
      break;
    case FaultKind::smoke:
    case FaultKind::fire_alarm:
    case FaultKind::fire_brigade:
      expected.is_fire = true;
      break;
    // Its frames leave no room for heartbeats: the lift stands.
    case FaultKind::babbling_node:
      expected.emergencies = {heartbeat};
      expected.stands_within = stands_most;
      break;
    case FaultKind::stuck_button:
      if (!shaft(fault.lift).has_stuck_button(fault)) break;
      expected.emergencies = {application_error};
      expected.told_within = stuck_after + 1s;
      break;
  }
  return expected;
}

LiftNumber LiftNetwork::State::lift_of(std::size_t bus) const {
  for (const NodeDescription& node : description.nodes) {
    if (node.bus == bus) return node.lift;
  }
  return 0;
}

void LiftNetwork::State::heard(Time now, const BusEvent& event) {
  const auto note = [&]<class Seen>(const Seen& seen) {
    // What the controllers command shows in the states that follow.
    if constexpr (!std::is_same_v<Seen, NmtCommandSeen>) events.push_back({now, seen});
  };
  std::visit(note, event);
  if (const auto* told = std::get_if<EmergencySeen>(&event)) {
    fault_referee.emergency_seen(now, lift_of(told->bus), told->code);
  }
}

bool LiftNetwork::State::is_hindered(LiftNumber lift) const {
  const Time now = world.now();
  if (fault_referee.is_hindered(now, lift)) return true;
  // A hand on a real key is no fault of the plan.
  const Time until = lift == 0 ? Time{} : shaft(lift).in_real_service_until(now);
  return until != Time{} && now - until < serves_most(lift);
}

bool LiftNetwork::State::is_anything_hindered() const {
  for (std::size_t i = 0; i <= shafts.size(); ++i) {
    if (is_hindered(static_cast<LiftNumber>(i))) return true;
  }
  return false;
}

}  // namespace canvoy::lift
