// What is in a car: what people weigh, within what the signals of a real load unit say of it, as
// the car and its own load cell have it.
//
//     ShaftLoad load(design, car);
//     device(port, id, load.cell().hardware());
//     load.set_people(450);
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/car_plant.hpp"
#include "canvoy/sim/lift/change_signal.hpp"
#include "canvoy/sim/lift/load_cell.hpp"
#include "canvoy/sim/lift/real_devices.hpp"

namespace canvoy::lift {

/// Of the rated load, from which on a load unit says that the car is full, and hall calls are
/// passed. Nobody steps into a car with 0.8 of its persons, who may be light ones.
inline constexpr double full_share = 0.7;

class ShaftLoad {
 public:
  /// Both must outlive this.
  ShaftLoad(const CarDesign& design, CarPlant& car)
      : design_(&design), car_(&car), cell_({.car_mass_kg = design.mass_kg}) {}
  ShaftLoad(const ShaftLoad&) = delete;
  ShaftLoad& operator=(const ShaftLoad&) = delete;

  LoadCell& cell() { return cell_; }
  void has_unit(ChangeSignal unit) { unit_ = std::move(unit); }

  void set_people(double mass_kg) {
    people_kg_ = mass_kg;
    weigh();
  }
  /// A real unit says so, and from now on leads what is weighed.
  void lead(const LoadSaid& said) {
    said_ = said;
    weigh();
  }
  bool is_led() const { return said_.has_value(); }
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
    if (!said_) return people_kg_;
    const double rated_kg = design_->rated_load_kg;
    const double overload_kg = rated_kg * design_->overload_share;
    if (said_->overload) return std::max(people_kg_, overload_kg);
    const double least_kg = said_->full ? rated_kg * full_share : 0;
    return std::clamp(people_kg_, least_kg, overload_kg - 1);
  }

  const CarDesign* design_;
  CarPlant* car_;
  LoadCell cell_;
  ChangeSignal unit_;
  double people_kg_ = 0;
  std::optional<LoadSaid> said_{};
};

}  // namespace canvoy::lift
