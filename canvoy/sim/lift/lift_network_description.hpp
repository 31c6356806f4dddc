// A network of lifts as data: buses, nodes on them, the building behind them, who comes, and what
// goes wrong. A file of it is read by the tools; the standard one is made here.
//
//     LiftNetworkDescription description = standard_lift_network({.lifts = 4, .floors = 20});
//     std::erase_if(description.nodes, is_the_drive_of_lift_1);  // a real one plays it
//
// Each lift has a bus of its own (250 kbit/s); a group has one more, on which the controllers of
// the lifts and the group controller talk. Node-IDs are those that the special interest group
// recommends (facts: 1 controller, 2 drive, 4 position, 6 to 8 doors, 13 load, from 16 on car
// panels, from 21 on landing panels).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/fault.hpp"
#include "canvoy/sim/lift/panel_words.hpp"
#include "canvoy/sim/lift/passenger.hpp"
#include "canvoy/sim/lift/traffic.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

/// What a node is. Most are one virtual device; the others are named with those that they are.
enum class DeviceKind : std::uint8_t {
  lift_controller,   ///< call, car door and car drive controller; NMT master of its bus
  group_controller,  ///< on the bus of a group
  drive,             ///< car drive unit
  position,          ///< car position unit
  door,              ///< car door unit
  light_barrier,     ///< light barrier unit
  load,              ///< load measuring unit
  car_panel,         ///< input and output panel unit in the car
  landing_panel,     ///< input and output panel unit of one landing
};
constexpr bool is_panel(DeviceKind kind) {
  return kind == DeviceKind::car_panel || kind == DeviceKind::landing_panel;
}
/// As it is written in a file: `lift-controller`. Empty for a number that is none.
std::string_view device_kind_name(DeviceKind kind);
std::optional<DeviceKind> device_kind_of(std::string_view name);

inline constexpr std::uint32_t lift_bit_rate = 250'000;

/// Of controllers: what is urgent, as an emergency is, does not wait behind a heartbeat of theirs
/// that a babbling node keeps from the bus.
inline constexpr SlotOptions controller_slot{.transmit_order = TransmitOrder::by_identifier};

struct BusDescription {
  std::string name{};
  std::uint32_t bit_rate = lift_bit_rate;
};

struct NodeDescription {
  std::size_t bus = 0;  ///< its place among the buses
  NodeId id = 1;
  DeviceKind kind = DeviceKind::lift_controller;
  LiftNumber lift = 1;  ///< that it belongs to; of a group controller none
  /// Where a landing panel hangs; more than one where it has the buttons of several.
  std::vector<FloorNumber> floors{};
  unsigned doors = 0b0001;  ///< that it moves, watches, or hangs beside: bit 0 is door 1
  /// False: a real device is that node. It is on the bus, is supervised and served as any other;
  /// what it says leads the plant behind it.
  bool played = true;
  PanelDescription panel{};
  /// What it is given at each boot-up, in this order: other CAN-IDs, times, limits than by default.
  std::vector<NodeValue> values{};

  friend bool operator==(const NodeDescription&, const NodeDescription&) = default;
};

/// A value of a description that its node did not take.
struct RefusedValue {
  NodeDescription node{};
  NodeConfiguration::Refusal refusal{};
};

/// How the controllers of lifts serve.
struct LiftService {
  bool destination_control = false;  ///< of a group: people say at the landing where to
  Duration door_dwell = 3s;          ///< a door stays open, after the last one has passed
  FloorNumber fire_floor = 1;
  /// Where a car goes that has nothing to do; no_floor: it stays. In an up-peak cars come back to
  /// the main floor by themselves, as the classical calculation takes it.
  FloorNumber parking_floor = no_floor;
  Duration parking_after = 60s;
};

struct LiftNetworkDescription {
  std::string name{};
  Building building{};
  std::vector<BusDescription> buses{};
  std::vector<NodeDescription> nodes{};
  LiftService service{};
  TrafficOptions traffic{};
  /// In place of traffic, where there are any.
  std::vector<Arrival> arrivals{};
  PassengerOptions people{};
  FaultPlan faults{};  ///< and the seed of all that is left to chance, beside what has its own
};

/// What `canvoy run lift` asks for.
struct StandardLifts {
  LiftNumber lifts = 1;  ///< 1 to 8
  FloorNumber floors = 10;
  double floor_height_m = 3.5;
  double population_per_floor = 50;
  LiftDesign lift{};
  bool destination_control = false;
  TrafficOptions traffic{};
  std::uint64_t seed = 1;
};
LiftNetworkDescription standard_lift_network(const StandardLifts& options);

/// In one line what is wrong with a description, and empty where nothing is: nodes that share an
/// ID, more buses, lifts or floors than there can be, a node for a lift that is not there.
std::string check(const LiftNetworkDescription& description);

/// Places where nodes stand on the bus of a lift.
namespace node_id {
inline constexpr NodeId lift_controller = 1;
inline constexpr NodeId drive = 2;
inline constexpr NodeId position = 4;
inline constexpr NodeId first_door = 6;
inline constexpr NodeId first_light_barrier = 9;
inline constexpr NodeId load = 13;
inline constexpr NodeId first_car_panel = 16;
inline constexpr NodeId first_landing_panel = 21;
inline constexpr NodeId last_landing_panel = 120;
/// On the bus of a group: lift controllers have the number of their lift.
inline constexpr NodeId group_controller = 17;
}  // namespace node_id

}  // namespace canvoy::lift
