#include "canvoy/worlds/lift/lift_soak.hpp"

#include <array>

namespace canvoy::lift {

namespace {

constexpr std::array<unsigned, 6> door_masks = {0b0001, 0b0001, 0b0011, 0b0101, 0b1011, 0b1111};

}  // namespace

/// Mostly single lifts, which run quickly: every third seed is a group, and every other one of
/// these has destination control.
LiftNetworkDescription soak_network(std::uint64_t seed, Duration time) {
  const bool is_group = seed % 3 == 0;
  StandardLifts options{.seed = seed};
  options.lifts = static_cast<LiftNumber>(is_group ? 2 + seed / 6 % 3 : 1);
  options.floors = static_cast<FloorNumber>(5 + seed / 5 % 8);
  options.destination_control = seed % 6 == 0;
  options.lift.doors = door_masks.at(seed / 3 % door_masks.size());
  options.traffic.pattern = static_cast<TrafficPattern>(seed / 7 % 4);
  options.traffic.percent_in_5_minutes = 3;
  LiftNetworkDescription made = standard_lift_network(options);
  made.service.fire_floor = static_cast<FloorNumber>(1 + seed % 5 / 4);
  made.faults.faults = random_faults(made.building, Time(1min), Time(time), seed);
  return made;
}

LiftNetworkDescription soak_network_of_pairs(std::uint64_t seed, Duration time) {
  LiftNetworkDescription made = soak_network(seed, time);
  made.faults.faults = random_fault_pairs(made.building, Time(1min), Time(time), seed);
  return made;
}

}  // namespace canvoy::lift
