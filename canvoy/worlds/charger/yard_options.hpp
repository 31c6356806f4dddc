// Options of a charging yard: bays with a charger each, and vehicles that come and go.
//
//     YardOptions yard{.chargers = 3, .batteries = 4, .goal = Goal{.state_of_charge = 0.8,
//                                                                  .at = Time(12h)}};
//     yard.vehicles = drawn_vehicles(yard);
//     ChargingYard network(yard);
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/worlds/charger/charger_options.hpp"

namespace canvoy::charger {

inline constexpr unsigned yard_chargers_max = 16;   ///< limit of a file of options, and so of bays
inline constexpr unsigned yard_batteries_max = 64;  ///< limit of a file of options

/// The batteries of a bay.
enum class BatteryKind : std::uint8_t {
  lead_acid,  ///< its management system requests current
  lithium,    ///< the same, of lithium iron phosphate
  plain,      ///< lead and acid with a module that only measures: the charger has a curve (IUoU)
};
/// Names in a file, in the order of BatteryKind.
inline constexpr std::string_view battery_kind_names[] = {"lead-acid", "lithium", "plain"};

/// A vehicle with a battery. It has a bay of its own, or shares it with others.
struct YardVehicle {
  unsigned bay = 1;              ///< from 1 on
  double state_of_charge = 0.2;  ///< when it first comes, 0 to 1
  Time arrives{};                ///< first time in the yard
  Time leaves = never;           ///< whatever its charge, even from the cable
  Time returns = never;          ///< after the drive; waits for its bay again
  double used = 0.4;  ///< share of the capacity that it uses between `leaves` and `returns`
};

/// What the batteries are charged for.
struct Goal {
  double state_of_charge = 0.8;  ///< 0 to 1
  Time at{12h};                  ///< a vehicle that leaves before has it when it leaves
};

struct YardOptions {
  /// Of each bay. On one bus, node-IDs of charger and battery count up with the bays, and there is
  /// no SDO manager.
  ChargerOptions bay{};
  unsigned chargers = 1;   ///< one in each bay, up to yard_chargers_max
  unsigned batteries = 1;  ///< one in each vehicle, up to yard_batteries_max
  bool one_bus = false;    ///< false: each bay has a bus of its own
  /// Of the first bay, the second and so on, and again from the first.
  std::vector<BatteryKind> kinds{BatteryKind::lead_acid};
  std::vector<YardVehicle> vehicles{};  ///< as many as batteries
  /// Empty: no charge is judged, and a battery makes room for the next only when full.
  std::optional<Goal> goal{};
  Duration change_time = 2min;  ///< without a battery at the cable, from one vehicle to the next
  double supply_watt = 0;       ///< that the mains connection bears; 0: not judged
  std::vector<unsigned> real_chargers{};   ///< bays with a real one, which is on a real bus
  std::vector<unsigned> real_batteries{};  ///< bays of which the vehicles have a real one

  /// True if charger and batteries of a bay, from 1 on, are simulated.
  bool plays(unsigned bay) const;
};

/// Kind of the batteries of a bay, from 1 on; lead_acid where YardOptions::kinds is empty.
BatteryKind kind_of_bay(const YardOptions& yard, unsigned bay);
/// The options of a bay, from 1 on, with the faults of that bay alone.
ChargerOptions bay_options(const YardOptions& yard, unsigned bay);
/// Positions in the yard's plan of the faults of that bay.
std::vector<std::size_t> faults_of_bay(const YardOptions& yard, unsigned bay);
/// As many vehicles as the yard has batteries, by its seed: the first of each bay comes in the
/// first half hour, the others within two hours, with the state of charge of the bays or up to 30 %
/// more. They leave half an hour to an hour after the goal, if there is one, and come back ten
/// hours later.
std::vector<YardVehicle> drawn_vehicles(const YardOptions& yard);

}  // namespace canvoy::charger
