// A network of lifts as data: buses, nodes on them, the building behind them, its traffic and its
// faults. The tools read it from a file; the standard one is made here.
//
//     LiftNetworkDescription description = standard_lift_network({.lifts = 4, .floors = 20});
//     std::erase_if(description.nodes, is_the_drive_of_lift_1);  // a real one plays it
//
// Each lift has a bus of its own (250 kbit/s); a group has one more, which connects the controllers
// of the lifts and the group controller. Node-IDs are those that the special interest group
// recommends (facts: 1 controller, 2 drive, 4 position, 6 to 8 doors, 13 load, from 16 on car
// panels, from 21 on landing panels).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/fault.hpp"
#include "canvoy/worlds/lift/panel_words.hpp"
#include "canvoy/worlds/lift/passenger.hpp"
#include "canvoy/worlds/lift/traffic.hpp"

namespace canvoy::lift {

/// Kind of a node. Most are one virtual device; the others are listed with theirs.
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
  sensors,           ///< sensor unit of one landing, or of the car
};
/// True for the panels of cars and landings.
constexpr bool is_panel(DeviceKind kind) {
  return kind == DeviceKind::car_panel || kind == DeviceKind::landing_panel;
}
/// True for a device without which a lift cannot run.
constexpr bool is_needed(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::lift_controller:
    case DeviceKind::drive:
    case DeviceKind::position:
    case DeviceKind::door:
    case DeviceKind::load:
      return true;
    default:
      return false;
  }
}
/// Name in a file: `lift-controller`. Empty for a number that is no kind.
std::string_view device_kind_name(DeviceKind kind);
/// The inverse of device_kind_name(); empty for another name.
std::optional<DeviceKind> device_kind_of(std::string_view name);

/// Of buses of lifts and of the group, in bit/s.
inline constexpr std::uint32_t lift_bit_rate = 250'000;

/// Options of controllers: an urgent frame, such as an emergency, does not wait behind one of their
/// heartbeats that a babbling node keeps from the bus.
inline constexpr SlotOptions controller_slot{.transmit_order = TransmitOrder::by_identifier};

/// A bus of the building.
struct BusDescription {
  std::string name{};                      ///< by which nodes refer to it in a file
  std::uint32_t bit_rate = lift_bit_rate;  ///< in bit/s
};

/// A node on a bus, played here or real.
struct NodeDescription {
  std::size_t bus = 0;                            ///< index of the bus
  NodeId id = 1;                                  ///< 1 to 127; unique on its bus
  DeviceKind kind = DeviceKind::lift_controller;  ///< decides what is behind it
  LiftNumber lift = 1;                            ///< lift of the node; for a group controller none
  /// Floors of a landing panel; several where it has the buttons of several. Of a sensor unit at
  /// most one; without, it is in the car.
  std::vector<FloorNumber> floors{};
  unsigned doors = 0b0001;  ///< doors that it moves, watches, or hangs beside: bit 0 is door 1
  /// False: a real device is that node. It is on the bus, and is supervised and served like any
  /// other; the plant behind it follows its reports.
  bool played = true;
  PanelDescription panel{};  ///< keys and displays, of a panel only
  /// Values written at each boot-up, in this order: CAN-IDs, times and limits that differ from the
  /// defaults.
  std::vector<NodeValue> values{};

  friend bool operator==(const NodeDescription&, const NodeDescription&) = default;
};

/// A value of a description that its node refused.
struct RefusedValue {
  NodeDescription node{};                ///< the node
  NodeConfiguration::Refusal refusal{};  ///< the value, and the abort code
};

/// Service of the controllers of lifts.
struct LiftService {
  bool destination_control = false;  ///< in a group: people enter their destination at the landing
  Duration door_dwell = 3s;          ///< time for which a door stays open after the last person has
                                     ///< passed
  FloorNumber fire_floor = 1;        ///< floor to which a recall sends the cars
  /// Floor to which an idle car goes; no_floor: it stays. In an up-peak, cars return to the main
  /// floor by themselves, as in the classical calculation.
  FloorNumber parking_floor = no_floor;
  Duration parking_after = 60s;  ///< time without a call, before it goes there
  /// True: a technician in the house comes to a lift that must be reset by hand, and to people who
  /// are shut in.
  bool technician = true;
};

struct LiftNetworkDescription {
  std::string name{};                    ///< for the title of a run
  Building building{};                   ///< floors, lifts and zones
  std::vector<BusDescription> buses{};   ///< one for each lift, and that of the group
  std::vector<NodeDescription> nodes{};  ///< of all buses
  LiftService service{};                 ///< the same for all lifts
  TrafficOptions traffic{};              ///< drawn people
  /// in place of traffic, if not empty
  std::vector<Arrival> arrivals{};
  PassengerOptions people{};  ///< how they behave
  FaultPlan faults{};         ///< faults, and the seed of all chance without a seed of its own
};

/// Options of `canvoy run lift`.
struct StandardLifts {
  LiftNumber lifts = 1;              ///< 1 to 8
  FloorNumber floors = 10;           ///< 2 to 254
  double floor_height_m = 3.5;       ///< from floor to floor
  double population_per_floor = 50;  ///< at each floor but the lowest
  LiftDesign lift{};                 ///< design of all lifts
  bool destination_control = false;  ///< people enter their destination at the landing
  TrafficOptions traffic{};          ///< drawn people
  std::uint64_t seed = 1;            ///< of all chance
};
/// The network of that building: a bus for each lift, one for a group of several, and all nodes at
/// the node-IDs below.
LiftNetworkDescription standard_lift_network(const StandardLifts& options);

/// One line that says what is wrong with a description; empty where nothing is: nodes that share an
/// ID, more buses, lifts or floors than possible, a node for a lift that does not exist.
std::string check(const LiftNetworkDescription& description);

/// Node-IDs on the bus of a lift.
namespace node_id {
inline constexpr NodeId lift_controller = 1;  ///< and NMT master
inline constexpr NodeId drive = 2;            ///< drive unit of the car
inline constexpr NodeId position = 4;         ///< position unit of the car
inline constexpr NodeId first_door = 6;       ///< door 1; doors 2 and 3 follow, and door 4 has 12
inline constexpr NodeId first_light_barrier = 9;   ///< one unit for all doors
inline constexpr NodeId load = 13;                 ///< load measuring unit
inline constexpr NodeId first_car_panel = 16;      ///< further ones follow
inline constexpr NodeId first_landing_panel = 21;  ///< lowest floor; the others follow
inline constexpr NodeId last_landing_panel =
    120;  ///< of 100: with more floors, a panel has several
/// On the bus of a group, a lift controller has the number of its lift.
inline constexpr NodeId group_controller = 17;
}  // namespace node_id

}  // namespace canvoy::lift
