// One lift of a building: its nodes on its bus, and the car, doors and scales behind them.
//
//     LiftShaft shaft(world, description, 1, hooks);
//     shaft.start();
//     shaft.press({.floor = 3, .direction = Direction::up}, true);
//     shaft.facts(now);   // the truth, for a referee
//     shaft.view(now);    // what people see
//
// On a bus of its own each lift is lift 1, with its objects, CAN-IDs and lift mask; only the bus of
// the group has its number in the building (docs/decisions.md, "Lifts in a building").
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/inspection_stations.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_snapshot.hpp"
#include "canvoy/worlds/lift/passenger.hpp"
#include "canvoy/worlds/lift/referee.hpp"
#include "canvoy/worlds/lift/safety_chain.hpp"

namespace canvoy::lift {

class LiftPanel;
class ShaftSensors;
struct ShaftPlants;

/// Functions that receive the reports of a shaft.
struct ShaftHooks {
  /// The car moves or stops, a door moves, a lamp that people look at changes: facts() and view()
  /// are others. Called at least every 100 ms while something moves.
  std::function<void(LiftNumber)> changed{};
  /// A lamp of a button on one of its panels changes; the key of a car call contains the lift.
  std::function<void(LiftNumber, const CallKey&, bool lit)> lamp{};
  /// A landing panel of this lift shows to which lift a destination call was given; 0: to none yet.
  std::function<void(LiftNumber, const DestinationButton&, LiftNumber assigned)> assigned{};
  /// Something that must be reset by hand has opened the safety chain; `none`: it was reset by
  /// hand.
  std::function<void(LiftNumber, SafetyChain::Trip)> tripped{};
};

class LiftShaft {
 public:
  /// Makes all nodes of the lift that are simulated here, without power. `description` must outlive
  /// this object.
  LiftShaft(World& world, const LiftNetworkDescription& description, LiftNumber lift,
            ShaftHooks hooks);
  LiftShaft(const LiftShaft&) = delete;
  LiftShaft& operator=(const LiftShaft&) = delete;
  ~LiftShaft();

  /// Gives the controller a second node on the bus of a group. Call it once, before start().
  void join_group(BusIndex group_bus, NodeId group_controller);
  /// Switches on all nodes.
  void start();

  // Actions of people. Where the description leaves out the node, nothing happens; a node without
  // power reads the contact when power returns.

  /// Presses or releases a button of a landing, of the car, or of a destination. False: there is
  /// none, or no power.
  bool press(const CallKey& button, bool pressed);
  /// The button of the car that opens the door; held until released.
  void press_door_open(bool pressed);
  /// The button of the car that closes the door; held until released.
  void press_door_close(bool pressed);
  /// Turns the key at the fire floor: it stays on until it was turned back as often as it was
  /// turned on.
  void turn_fire_key(bool on);
  /// Turns the key of the fire brigade in the car.
  void turn_brigade_key(bool on);
  /// People stand in the door, or leave it.
  void stand_in_door(DoorNumber door, bool is_in_the_way);
  /// Mass of the people in the car.
  void set_load(double mass_kg);

  // Actions of a technician.

  /// The stop switch opens the safety chain while it is pressed.
  void press_stop(bool is_pressed);
  /// Moves the car by hand, in m/s; 0: stops. False: it follows a real drive.
  bool crank(double metre_per_second);
  /// Holds the door open with a key, where the car stands at a floor: people pass, whatever its
  /// unit does.
  void hold_door(bool is_held);
  /// Closes all that must be closed by hand, where nothing is broken.
  void reset_by_hand();
  /// Turns the switch of an inspection station.
  void turn_inspection(Station station, bool on);
  /// Holds a button there; none: releases both.
  void hold_inspection(Station station, Direction way);
  /// Switches controller and drive off, and on again after 2 s.
  void restart();
  /// True if nothing is broken that opens the safety chain, and no part without which the lift
  /// cannot run.
  bool is_whole() const;
  /// True if its display shows that it is out of order by a fault.
  bool is_out_of_order() const { return snapshot_mode() == LiftMode::fault; }
  /// The part of the safety chain that must be closed by hand.
  SafetyChain::Trip trip() const;

  /// Time until which a key of a real panel keeps the lift from passengers.
  Time in_real_service_until(Time now) const;

  /// The true state, for referees.
  LiftFacts facts(Time now) const;
  /// What people see.
  CarView view(Time now) const;
  /// State for a drawing.
  LiftSnapshot snapshot(Time now) const;

  /// Begins or ends a fault in this shaft.
  void set_fault(const ScheduledFault& fault, bool present);
  /// True if the car would move without a brake at present.
  bool would_drift() const;
  /// Node of a fault: the one in the plan, or the first one that suits its kind; 0: none.
  NodeId node_of(const ScheduledFault& fault) const;
  /// True if the button of such a fault exists.
  bool has_stuck_button(const ScheduledFault& fault) const;
  /// Slot of a node of this lift; empty where it is not simulated here.
  std::optional<SlotIndex> slot(NodeId node) const;
  /// Slot of its controller on the bus of the group.
  std::optional<SlotIndex> group_slot() const;
  /// Null where the node is not simulated here.
  Node* node(NodeId id);

  // Changes by hands from outside, beside people.

  /// Inputs of the units. A caller that changes them must call look().
  ShaftPlants plants();
  /// Call it when an input of a unit was changed.
  void look();
  /// Null where the node is no panel, or is not simulated here.
  LiftPanel* panel(NodeId id);
  /// Null where the node is no sensor unit, or is not simulated here.
  ShaftSensors* sensors(NodeId id);

 private:
  LiftMode snapshot_mode() const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace canvoy::lift
