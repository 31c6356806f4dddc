#include "canvoy/tools/play/lift_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

using lift::Building;
using lift::FloorNumber;
using lift::LandingSnapshot;
using lift::LiftMode;
using lift::LiftNetworkDescription;
using lift::LiftNetworkSnapshot;
using lift::LiftSnapshot;

/// Floors of one row of the drawing, inclusive.
struct Row {
  FloorNumber first = 1;
  FloorNumber last = 1;

  bool has(FloorNumber floor) const { return floor >= first && floor <= last; }
};

std::string_view mode_text(LiftMode mode) {
  switch (mode) {
    case LiftMode::starting:
      return "starts";
    case LiftMode::normal:
      return "normal";
    case LiftMode::fire_recall:
      return "recall";
    case LiftMode::fire_brigade:
      return "fire";
    case LiftMode::special:
      return "special";
    case LiftMode::out_of_order:
      return "off";
    case LiftMode::fault:
      return "FAULT";
  }
  return "?";
}

char direction_sign(lift::Direction direction) {
  switch (direction) {
    case lift::Direction::up:
      return '^';
    case lift::Direction::down:
      return 'v';
    case lift::Direction::none:
      break;
  }
  return ' ';
}

/// `[ 4]^`, five columns.
std::string car_text(const LiftSnapshot& car) {
  constexpr double nearly_open = 0.99;
  double open = 0;
  for (const LiftSnapshot::Door& door : car.doors) open = std::max(open, door.open_share);
  const std::string_view sides = open <= 0 ? "[]" : open < nearly_open ? ")(" : "][";
  return fmt::format("{}{:>2}{}{}", sides[0], std::min(car.persons, 99U), sides[1],
                     direction_sign(car.direction));
}

/// The part of a row for one lift, without its edge.
std::string shaft_text(const LiftSnapshot& car, const Row& row) {
  if (row.has(car.nearest_floor)) return car_text(car);
  const bool is_wanted =
      std::ranges::any_of(car.car_calls, [&row](FloorNumber floor) { return row.has(floor); });
  return is_wanted ? "." : "";
}

std::string landing_text(const LiftNetworkSnapshot& now, const Row& row) {
  LandingSnapshot all;
  for (unsigned floor = row.first; floor <= row.last && floor <= now.landings.size(); ++floor) {
    const LandingSnapshot& landing = now.landings[floor - 1];
    all.waiting_up += landing.waiting_up;
    all.waiting_down += landing.waiting_down;
    all.lamp_up = all.lamp_up || landing.lamp_up;
    all.lamp_down = all.lamp_down || landing.lamp_down;
  }
  const auto people = [](unsigned count, char sign) {
    return count == 0 ? std::string("    ") : fmt::format("{:>3}{}", std::min(count, 999U), sign);
  };
  return fmt::format("{} {}  {}{}", people(all.waiting_up, '^'), people(all.waiting_down, 'v'),
                     all.lamp_up ? '^' : ' ', all.lamp_down ? 'v' : ' ');
}

/// From the top.
std::vector<Row> rows_of(const Building& building, unsigned rows_max) {
  const unsigned floors = building.floor_count();
  const unsigned each = (floors + rows_max - 1) / std::max(rows_max, 1U);
  std::vector<Row> rows;
  for (unsigned first = 1; first <= floors; first += each) {
    rows.push_back({static_cast<FloorNumber>(first),
                    static_cast<FloorNumber>(std::min(floors, first + each - 1))});
  }
  std::ranges::reverse(rows);
  return rows;
}

}  // namespace

std::string lift_picture(const LiftNetworkDescription& network, const LiftNetworkSnapshot& now,
                         double speed, unsigned rows_max, unsigned columns_max) {
  constexpr std::size_t columns_before = 27;
  constexpr std::size_t usual_width = 7;
  constexpr std::size_t least_width = 5;
  const bool is_wide = columns_before + now.lifts.size() * (usual_width + 1) <= columns_max;
  const std::size_t width = is_wide ? usual_width : least_width;
  std::string text = fmt::format("Canvoy: {}    {}{}    {} wait, {} ride, {} were carried\n\n",
                                 network.name, text::duration_text(now.at - Time{}),
                                 speed > 0 ? fmt::format("  (x{:g})", speed) : "", now.waiting,
                                 now.riding, now.served);
  const auto columns = [&](std::string_view title, const auto& cell) {
    std::string line = fmt::format("  {:<24}|", title);
    for (const LiftSnapshot& car : now.lifts)
      line += fmt::format("{:^{}.{}}|", cell(car), width, width);
    text += line + "\n";
  };
  std::size_t number = 0;
  columns("floor   waiting    calls", [&](const LiftSnapshot&) {
    return fmt::format("{} {}", is_wide ? "lift" : "no.", ++number);
  });
  for (const Row& row : rows_of(network.building, rows_max)) {
    text += fmt::format("  {:<8}{:<16}|", network.building.floor(row.first).name,
                        landing_text(now, row));
    for (const LiftSnapshot& car : now.lifts)
      text += fmt::format("{:^{}}|", shaft_text(car, row), width);
    text += "\n";
  }
  columns("", [](const LiftSnapshot& car) { return std::string(mode_text(car.mode)); });
  columns("load, kg", [](const LiftSnapshot& car) {
    return fmt::format("{:.0f}{}", car.load_kg, car.overload ? "!" : "");
  });
  columns("speed, m/s",
          [](const LiftSnapshot& car) { return fmt::format("{:.1f}", std::abs(car.speed_m_s)); });
  columns("starts", [](const LiftSnapshot& car) { return fmt::format("{}", car.starts); });
  std::size_t bus = 0;
  columns("bus load", [&](const LiftSnapshot&) {
    return bus < now.buses.size() ? fmt::format("{:.1f} %", now.buses[bus++].load * 100)
                                  : std::string();
  });
  return text +
         "  [ 4] a car with persons, ][ its doors are open, . somebody wants to go there\n\n";
}

}  // namespace canvoy::tools
