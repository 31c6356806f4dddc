// The load in a car: the mass of its people, within the signals of a real load unit, for the car
// and its own load cell.
//
//     ShaftLoad load(design, car);
//     device(port, id, load.cell().hardware());
//     load.set_people(450);
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/change_signal.hpp"
#include "canvoy/worlds/lift/load_cell.hpp"
#include "canvoy/worlds/lift/real_devices.hpp"

namespace canvoy::lift {

/// Share of the rated load from which on a load unit reports that the car is full, so that it
/// passes hall calls. No person boards a car with 0.8 of its persons, who may be light ones.
inline constexpr double full_share = 0.7;

class ShaftLoad {
 public:
  /// Both must outlive this object.
  ShaftLoad(const CarDesign& design, CarPlant& car)
      : design_(&design), car_(&car), cell_({.car_mass_kg = design.mass_kg}) {}
  ShaftLoad(const ShaftLoad&) = delete;
  ShaftLoad& operator=(const ShaftLoad&) = delete;

  /// The load cell that the unit reads.
  LoadCell& cell() { return cell_; }
  /// The unit reads its inputs again when `unit` tells it.
  void has_unit(ChangeSignal unit) { unit_ = std::move(unit); }

  /// Mass of the people in the car.
  void set_people(double mass_kg) {
    people_kg_ = mass_kg;
    weigh();
  }
  /// Sets the load beside people.
  void set_goods(double mass_kg) {
    goods_kg_ = mass_kg;
    weigh();
  }
  /// Takes the report of a real unit, which from then on determines the load.
  void lead(const LoadSaid& said) {
    said_ = said;
    weigh();
  }
  /// True once a real unit has reported: its signals bound the load.
  bool is_led() const { return said_.has_value(); }
  /// Breaks the sensor of the first rope, or mends it.
  void break_sensor(bool is_broken) {
    cell_.break_sensor(is_broken ? 1 : 0);
    unit_.tell();
  }

 private:
  void weigh() {
    const double mass_kg = weighed_kg();
    car_->set_load(mass_kg);
    cell_.set_load(mass_kg);
    unit_.tell();
  }
  double weighed_kg() const {
    const double inside_kg = people_kg_ + goods_kg_;
    if (!said_) return inside_kg;
    const double rated_kg = design_->rated_load_kg;
    const double overload_kg = rated_kg * design_->overload_share;
    if (said_->overload) return std::max(inside_kg, overload_kg);
    const double least_kg = said_->full ? rated_kg * full_share : 0;
    return std::clamp(inside_kg, least_kg, overload_kg - 1);
  }

  const CarDesign* design_;
  CarPlant* car_;
  LoadCell cell_;
  ChangeSignal unit_;
  double people_kg_ = 0;
  double goods_kg_ = 0;
  std::optional<LoadSaid> said_{};
};

}  // namespace canvoy::lift
