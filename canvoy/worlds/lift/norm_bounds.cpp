#include "canvoy/worlds/lift/norm_bounds.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "canvoy/worlds/lift/door_plant.hpp"

namespace canvoy::lift {

namespace {

std::string number_text(double number) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6);
  return {text.data(), end};
}

/// `door_zone_m = 5: EN 81-20, 5.3.8.1, allows 0.35`
std::string refusal(std::string_view key, double value, std::string_view clause,
                    const std::string& bound) {
  return std::string(key) + " = " + number_text(value) + ": EN 81-20, " + std::string(clause) +
         ", allows " + bound;
}

/// The norm limits closing doors; one that opens faster would strike what leans on it.
std::string check_door_time(std::string_view key, double time_s, double width_m) {
  const double mass_kg = DoorPlantOptions{}.mass_kg;
  const double energy_j = door_energy_j(mass_kg, width_m / time_s);
  if (energy_j <= door_energy_most_j) return {};
  const double least_s = width_m * std::sqrt(mass_kg / (8 * door_energy_most_j));
  const double in_hundredths = std::ceil(least_s * 100) / 100;
  return refusal(key, time_s, "5.3.6.2.2.1",
                 "a door " + number_text(door_energy_most_j) + " J, this one has " +
                     number_text(std::round(energy_j * 10) / 10) +
                     " J: " + number_text(in_hundredths) + " at least");
}

}  // namespace

std::string beyond_norm(const LiftDesign& design) {
  if (design.door_zone_m > door_zone_most_m) {
    return refusal("door_zone_m", design.door_zone_m, "5.3.8.1", number_text(door_zone_most_m));
  }
  const CarDesign& car = design.car;
  const double most_kg = std::max(overload_most_share * car.rated_load_kg, overload_most_kg);
  constexpr double rounding = 1e-9;
  if (car.rated_load_kg * (car.overload_share - 1) > most_kg * (1 + rounding)) {
    return refusal("overload_share", car.overload_share, "5.12.1.2",
                   number_text(1 + most_kg / car.rated_load_kg) + " of " +
                       number_text(car.rated_load_kg) + " kg");
  }
  const double persons_most = std::floor(car.rated_load_kg / person_kg);
  if (car.rated_persons > std::max(persons_most, 1.0)) {
    return refusal("rated_persons", car.rated_persons, "5.4.2.3.1",
                   number_text(persons_most) + " for " + number_text(car.rated_load_kg) + " kg");
  }
  const DoorDesign& door = design.door;
  std::string error = check_door_time("door_open_s", door.open_time_s, door.width_m);
  if (!error.empty()) return error;
  return check_door_time("door_close_s", door.close_time_s, door.width_m);
}

}  // namespace canvoy::lift
