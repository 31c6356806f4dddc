#include "canvoy/worlds/lift/fault_consequences.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "canvoy/canopen/protocol/error.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/worlds/lift/fire_brigade.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"

namespace canvoy::lift {

namespace {

using canvoy::emergency_code::heartbeat;
constexpr std::uint16_t hardware_error = 0x5000;      ///< of an encoder
constexpr std::uint16_t additional_modules = 0x7000;  ///< a brake
using cia417::emergency_code::application_error;
using cia417::emergency_code::finger_protector_defect;
using cia417::emergency_code::light_barrier_defect;
using cia417::emergency_code::motion_detection_defect;
using cia417::emergency_code::overspeed;
using cia417::emergency_code::unintended_car_movement;
/// For heartbeats of 1.5 s; the rest is the time for the stop.
constexpr Duration stands_most = 10s;
/// Time after a fault in which the devices boot, the car finds its position, and goes to a floor.
constexpr Duration gets_ready_most = 60s;
/// Number of people who get in or out where a car stops after they have waited.
constexpr double transfers_of_stop = 4;
/// In a group other lifts may carry people, and a lift that is not needed is idle for a while.
constexpr Duration idle_most = 30min;
/// A lost node cannot be detected before its heartbeat is late.
constexpr Duration loss_noticed = 2s;
/// A report of a unit itself takes a moment of sensing, a frame, and the end of a start.
constexpr Duration error_noticed = 300ms;
/// The safety chain acts at once, and a safety gear within a second.
constexpr Duration chain_stops_most = 2s;
/// Time in which a drive detects that the car moves where it should not, or too fast.
constexpr Duration movement_noticed = 2s;
/// Errors that show only where a car arrives take a trip: ropes that have slipped, or a brake that
/// does not hold.
constexpr Duration arrives_first = 60s;
/// Faster than levelling, and with so much way left that a tenth of it exceeds a tolerance.
constexpr double travelling_m_s = 0.5;
/// Share of the rated speed: from there on, a motor that runs away is too fast before it is off its
/// profile.
constexpr double nearly_rated = 0.95;

/// Lifts that have lost their group serve alone; a call that was on its way to the group is made
/// again.
constexpr Duration regroups_within = 10s;
/// Terminals show a new lift only to people who make their request again.
constexpr Duration regroups_at_terminals_within = 3min;

void must_stand(FaultExpectation& expected, Duration noticed_within) {
  expected.stands_within = stands_most;
  expected.noticed_within = noticed_within;
}

}  // namespace

Duration serves_most(const LiftNetworkDescription& description, LiftNumber lift) {
  const Building& building = description.building;
  const LiftDesign& design = building.lift(lift);
  const unsigned ways = building.floor_count() - 1U;
  const Flight flight{design.speed_m_s, design.acceleration_m_s2, design.jerk_m_s3};
  const double stop_s = flight_time_s(flight, building.top_m() / ways) + design.door.open_time_s +
                        design.door.close_time_s +
                        transfers_of_stop * in_seconds(description.people.transfer);
  return gets_ready_most + std::chrono::seconds(std::lround(2 * ways * stop_s));
}

FaultExpectation FaultConsequences::of(const ScheduledFault& fault) const {
  FaultExpectation expected = alone(fault);
  const bool is_there = present_->has_like(fault);
  // A present error is not reported twice.
  if (is_there || present_->silences(fault)) expected.emergencies.clear();
  // A second cut has no effect: the first one may have left all that a car needs.
  if (is_there && fault.kind == FaultKind::cable_cut) {
    expected.stands_within = expected.noticed_within = std::nullopt;
  }
  if (has_no_current(fault)) {
    expected.emergencies.clear();
    expected.stands_within = expected.noticed_within = std::nullopt;
  }
  return expected;
}

FaultExpectation FaultConsequences::alone(const ScheduledFault& fault) const {
  if (fault.part == 0) return of_group(fault);
  FaultExpectation expected{
      .lift = fault.part,
      .serves_within = devices_->count() > 1 ? idle_most : serves_most(*description_, fault.part)};
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
    case FaultKind::weak_brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      expect_of_motion(expected, fault);
      break;
    case FaultKind::fire_brigade:
      expected.recovers_within += FireBrigade::gives_back_within;
      [[fallthrough]];
    case FaultKind::smoke:
    case FaultKind::fire_alarm:
      expected.is_fire = true;
      break;
    // Its frames leave no room for heartbeats: the lift stands.
    case FaultKind::babbling_node:
      expected.emergencies = {heartbeat};
      expected.stands_within = stands_most;
      break;
    case FaultKind::stuck_button:
      if (!devices_->shaft(fault.part).has_stuck_button(fault)) break;
      expected.emergencies = {application_error};
      expected.told_within = stuck_after + 1s;
      break;
  }
  return expected;
}

/// People can be carried without a group: no car must stand.
FaultExpectation FaultConsequences::of_group(const ScheduledFault& fault) const {
  FaultExpectation expected{.lift = 0, .hinders_for = regroups_within};
  // Its controller is at the end of the cable, before the lifts.
  const bool is_cut = fault.kind == FaultKind::cable_cut && fault.node != devices_->count();
  const bool is_silent = fault.kind == FaultKind::lost_node || is_cut;
  if (!is_silent && fault.kind != FaultKind::babbling_node) return expected;
  expected.emergencies = {heartbeat};
  expected.serves_within =
      description_->people.destination_control ? regroups_at_terminals_within : regroups_within;
  return expected;
}

/// Faults that open the safety chain of a moving car, and those that move it without a command.
void FaultConsequences::expect_of_motion(FaultExpectation& expected,
                                         const ScheduledFault& fault) const {
  const LiftShaft& lift = devices_->shaft(fault.part);
  const double speed = std::abs(lift.snapshot(world_->now()).speed_m_s);
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
      // A drive that boots in a moving car has no standstill to compare with.
      stops({unintended_car_movement, overspeed}, movement_noticed);
      // A motor that levels the car, or continues, holds it meanwhile.
      expected.noticed_when_told = true;
      expected.told_within = arrives_first;
      break;
    case FaultKind::runaway:
      if (speed >= nearly_rated * description_->building.lift(fault.part).speed_m_s) {
        stops({overspeed}, movement_noticed);
      }
      break;
    // Its self-test comes at the end of the trip.
    case FaultKind::weak_brake:
      if (!travels) break;
      expected.emergencies = {additional_modules};
      expected.told_within = arrives_first;
      break;
    default:
      if (!travels) break;
      expected.emergencies = {application_error};
      expected.told_within = arrives_first;
      break;
  }
}

/// Loss of the nodes that this fault takes from the lift.
FaultConsequences::Loss FaultConsequences::loss_of(const ScheduledFault& fault) const {
  if (fault.node == 0) return Loss::needed;
  Loss loss = Loss::none;
  for (const NodeDescription& node : description_->nodes) {
    if (node.lift != fault.part || node.kind == DeviceKind::group_controller) continue;
    const bool is_cut = fault.kind == FaultKind::cable_cut;
    const bool is_lost = is_cut ? devices_->is_behind(node.id, fault) : node.id == fault.node;
    if (is_lost && is_needed(node.kind)) return Loss::needed;
    if (is_lost) loss = Loss::bearable;
  }
  return loss;
}

/// True if the plan cuts the current of a motor that should run away, or of ropes that should slip,
/// before this can be detected.
bool FaultConsequences::has_no_current(const ScheduledFault& fault) const {
  if (fault.kind != FaultKind::runaway && fault.kind != FaultKind::rope_slip) return false;
  return std::ranges::any_of(description_->faults.faults, [&](const ScheduledFault& other) {
    const bool takes_it = other.kind == FaultKind::door_lock ||
                          other.kind == FaultKind::safety_contact ||
                          (other.kind == FaultKind::lost_node &&
                           devices_->place_of(other).node == devices_->place_of(fault).node);
    return takes_it && other.part == fault.part && other.start <= fault.start + movement_noticed &&
           other.end() > fault.start;
  });
}

}  // namespace canvoy::lift
