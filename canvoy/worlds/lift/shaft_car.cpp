#include "canvoy/worlds/lift/shaft_car.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::lift {

namespace {

constexpr double near_floor_m = 0.05;

CarPlantDesign plant_of(const Building& building, const LiftDesign& design) {
  constexpr double gravity = 9.81;
  constexpr double test_share = 1.25;
  const CarDesign& of_car = design.car;
  const double test_n = gravity * (test_share - design.balance) * of_car.rated_load_kg;
  return {.car_kg = of_car.mass_kg,
          .counterweight_kg = of_car.mass_kg + design.balance * of_car.rated_load_kg,
          .travel_m = building.top_m(),
          .overtravel_m = design.overtravel_m,
          .stretch_um_per_kg = of_car.rope_stretch_um_per_kg,
          .brake_force_n = std::max(CarPlantDesign{}.brake_force_n, 2 * test_n),
          .brake_test_n = test_n,
          .has_brake_test = design.has_brake_test};
}

SafetyChainDesign chain_of(const LiftDesign& design) {
  return {.rated_speed_m_s = design.speed_m_s,
          .door_zone_m = design.door_zone_m,
          .final_limit_m = design.overtravel_m / 3,
          .is_bridged = !design.has_safety_chain};
}

}  // namespace

/// On its own bus each lift is lift 1.
ShaftCar::ShaftCar(const Building& building, LiftNumber lift, Callback<Time()> clock)
    : building_(&building),
      plant_(plant_of(building, building.lift(lift)), clock),
      chain_(chain_of(building.lift(lift))),
      real_(1, clock) {}

void ShaftCar::follow_real_drive() {
  is_led_ = true;
  plant_.lead_by(Callback<cia417::MotionState()>::to<&CarFollower::motion>(real_));
}

SafetySight ShaftCar::sight(Time now, const ShaftDoors& doors) {
  const CarPlant::Truth car = plant_.truth();
  const double below_m = building_->height_m(1) - car.position_m;
  SafetySight seen{.from_floor_m = 1e9,
                   .beyond_m = std::max(below_m, car.position_m - building_->top_m()),
                   .speed_m_s = std::abs(car.velocity_m_s),
                   .gear_is_caught = car.gear_is_caught,
                   .brake_slips = plant_.brake_has_slipped()};
  for (const Floor& each : building_->floors) {
    seen.from_floor_m = std::min(seen.from_floor_m, std::abs(each.height_m - car.position_m));
  }
  for (const auto& door : doors) {
    if (!door->is_there()) continue;
    const bool is_closed = door->plant().contact_is_closed(now);
    if (!is_closed || !door->plant().is_locked(now)) seen.doors_are_locked = false;
    if (!is_closed) seen.is_a_door_open = true;
  }
  return seen;
}

void ShaftCar::look_at_chain(Time now, const ShaftDoors& doors) {
  chain_.look(sight(now, doors));
  const bool is_caught = plant_.truth().gear_is_caught;
  if (chain_.wants_gear() && !is_caught && !is_cranked_) plant_.arrest();
  const bool is_cut = !chain_.is_closed() || is_stopped_by_hand_;
  if (plant_.is_cut() == is_cut) return;
  plant_.cut(is_cut);
  drive_.tell();
}

bool ShaftCar::crank(double metre_per_second) {
  if (is_led_) return false;
  const bool moves = metre_per_second != 0;
  if (moves && !is_cranked_) was_caught_ = plant_.truth().gear_is_caught;
  if (moves) plant_.release_gear();
  is_cranked_ = moves;
  plant_.crank(metre_per_second);
  if (!moves && was_caught_) plant_.arrest();
  return true;
}

FloorNumber ShaftCar::floor() {
  return building_->floor_near(plant_.truth().position_m, near_floor_m);
}

void ShaftCar::lose_drive() {
  const cia417::CarDriveHardware stage = plant_.drive_hardware();
  stage.release_brake(false);
  stage.power(false);
}

void ShaftCar::set_fault(FaultKind kind, bool present) {
  constexpr double slip_share = 0.1;
  CarPlantFaults faults = plant_.faults();
  if (kind == FaultKind::brake) has_no_brake_ = present;
  if (kind == FaultKind::weak_brake) has_weak_brake_ = present;
  faults.brake_share = has_no_brake_ ? 0 : has_weak_brake_ ? plant_.weak_brake_share() : 1;
  if (kind == FaultKind::rope_slip) faults.slip = present ? slip_share : 0;
  if (kind == FaultKind::runaway) faults.motor_runs_away = present;
  // It keeps its last position, and reports the defect.
  if (kind == FaultKind::dead_encoder) {
    faults.position_encoder_is_dead = faults.position_encoder_alarms = present;
  }
  plant_.set_faults(faults);
}

bool ShaftCar::is_whole() const {
  const CarPlantFaults& broken = plant_.faults();
  return broken.brake_share == 1 && broken.slip == 0 && !broken.motor_runs_away;
}

void ShaftCar::reset_by_hand() {
  plant_.release_gear();
  chain_.reset_by_hand();
}

void ShaftCar::reset_brake() {
  plant_.forget_brake_test();
  chain_.reset_brake();
}

}  // namespace canvoy::lift
