#include "canvoy/worlds/excavator/cab_truth.hpp"

#include <cmath>

namespace canvoy::excavator {

void CabTruth::step(Time now) {
  bool moves = false;
  for (std::size_t i = 0; i < movements; ++i) {
    moves = moves || std::abs(machine_->speed(static_cast<Movement>(i))) > 0;
  }
  if (moves) moved_at_ = now;
}

bool CabTruth::is_as_without_host() const {
  for (std::size_t i = 0; i < shown_parameters; ++i) {
    if (panel_->shown(static_cast<Shown>(i)) != no_value) return false;
  }
  return panel_->lit() == lamps_without_host;
}

/// Of a machine with a failed module, fuel and oil are unknown.
bool CabTruth::lamps_are_right(bool has_valves, bool has_armrest) const {
  const Lamps& lit = panel_->lit();
  const auto is_as = [&lit](Lamp lamp, bool is_on) { return is_lit(lit, lamp) == is_on; };
  const double fuel = machine_->litres() / Excavator::tank_litres * 100;
  constexpr double hardly = 0.5;
  return is_as(Lamp::light, valves_->is_on(Switched::light)) &&
         is_as(Lamp::beacon, valves_->is_on(Switched::beacon)) &&
         is_as(Lamp::fast, machine_->is_fast()) &&
         is_as(Lamp::locked, !machine_->has_pilot_pressure()) && is_as(Lamp::ready, has_valves) &&
         (panel_->has_jam() ||
          is_as(Lamp::fault,
                panel_->has_broken_wire() || panel_->has_drift() || !has_valves || !has_armrest)) &&
         (!has_valves || std::abs(fuel - low_fuel_percent) < hardly ||
          is_as(Lamp::low_fuel, fuel < low_fuel_percent)) &&
         (!has_valves || std::abs(machine_->oil_celsius() - Excavator::hot) < hardly ||
          is_as(Lamp::hot, machine_->oil_celsius() > Excavator::hot));
}

bool CabTruth::is_blank() const {
  for (std::size_t each = 0; each < shown_parameters; ++each) {
    if (panel_->shown(static_cast<Shown>(each)) != no_value) return false;
  }
  return true;
}

/// A moving value is reported a moment later.
bool CabTruth::display_is_right(Time now, bool has_valves) const {
  if (!has_valves) return is_blank();
  const bool is_still = now - moved_at_ > 1s;
  const auto is_near = [this](Shown what, double is, double tolerance) {
    return std::abs(panel_->shown(what) - is) <= tolerance;
  };
  const Excavator::Point tip = machine_->tip();
  constexpr double centimetres = 100;
  const double way = is_still ? 10 : 150;
  const double turn = is_still ? 2 : 20;
  const double slew =
      std::remainder(panel_->shown(Shown::slew) - machine_->angle(Movement::slew), 360);
  const std::uint32_t page = panel_->knob() % display_pages;
  constexpr Movement details[] = {Movement::boom, Movement::stick, Movement::bucket};
  const bool is_detail_right =
      page >= std::size(details)
          ? is_near(Shown::detail, machine_->pressure_bar(), is_still ? 5 : 400)
          : is_near(Shown::detail, machine_->angle(details[page]), is_still ? 2 : 45);
  return is_near(Shown::fuel, machine_->litres() / Excavator::tank_litres * 100, 1.5) &&
         is_near(Shown::oil, machine_->oil_celsius(), 2) && std::abs(slew) <= turn &&
         is_near(Shown::height, tip.z * centimetres, way) &&
         is_near(Shown::reach, tip.x * centimetres, way) &&
         is_near(Shown::rpm, machine_->rpm(), 60) && is_near(Shown::page, page, 0) &&
         is_detail_right;
}

}  // namespace canvoy::excavator
