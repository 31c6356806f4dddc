// One lift of a building: its nodes on its bus, and the car, doors and scales behind them.
//
//     LiftShaft shaft(world, description, 1, hooks);
//     shaft.start();
//     shaft.press({.floor = 3, .direction = Direction::up}, true);
//     shaft.facts(now);   // the truth, for a referee
//     shaft.view(now);    // what people see
//
// On a bus of its own each lift is lift 1, with its objects, CAN-IDs and lift mask; which lift of
// the building it is, only the bus of the group knows (docs/decisions.md, "Lifts in a building").
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/lift_snapshot.hpp"
#include "canvoy/sim/lift/passenger.hpp"
#include "canvoy/sim/lift/referee.hpp"
#include "canvoy/sim/lift/safety_chain.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

/// Whom a shaft tells of what happens in it.
struct ShaftHooks {
  /// The car moves or stops, a door moves, a lamp that people look at changes: facts() and view()
  /// are others. Called at least each 100 ms while something moves.
  std::function<void(LiftNumber)> changed{};
  /// A lamp of a button on one of its panels; of a car call the key has the lift.
  std::function<void(LiftNumber, const CallKey&, bool lit)> lamp{};
  /// A landing panel of this lift says to which one a destination call was given; 0: to none yet.
  std::function<void(LiftNumber, const DestinationButton&, LiftNumber assigned)> assigned{};
  /// What only a hand resets has opened the safety chain; `none`: a hand has reset it.
  std::function<void(LiftNumber, SafetyChain::Trip)> tripped{};
};

class LiftShaft {
 public:
  LiftShaft(World& world, const LiftNetworkDescription& description, LiftNumber lift,
            ShaftHooks hooks);
  LiftShaft(const LiftShaft&) = delete;
  LiftShaft& operator=(const LiftShaft&) = delete;
  ~LiftShaft();

  /// The controller gets a second node on the bus of a group. Called once, before start().
  void join_group(BusIndex group_bus, NodeId group_controller);
  /// Gives all nodes power.
  void start();

  // What people do. Where the node for it is left out of the description nothing happens; where it
  // has no power it finds the contact as it is when the power comes back.

  /// A button: of a landing, of the car, or of a destination. False: there is none, or no power.
  bool press(const CallKey& button, bool pressed);
  void press_door_open(bool pressed);
  void press_door_close(bool pressed);
  /// The key at the fire floor: it stays on until each that turned it has turned it back.
  void turn_fire_key(bool on);
  /// The key in the car, of the fire brigade.
  void turn_brigade_key(bool on);
  void stand_in_door(DoorNumber door, bool is_in_the_way);
  void set_load(double mass_kg);

  /// Somebody has turned a key of a real panel, and the lift is not for passengers; or was not
  /// until this time.
  Time in_real_service_until(Time now) const;

  LiftFacts facts(Time now) const;
  CarView view(Time now) const;
  LiftSnapshot snapshot(Time now) const;

  /// Begins or ends what goes wrong in this shaft.
  void set_fault(const ScheduledFault& fault, bool present);
  /// Without a brake the car would move now.
  bool would_drift() const;
  /// Where that is: the node of the fault, or the first one that suits its kind; 0: at none.
  NodeId node_of(const ScheduledFault& fault) const;
  /// The button of a fault of that kind is there.
  bool has_stuck_button(const ScheduledFault& fault) const;
  /// Of a node of this lift; nothing where it is not simulated here.
  std::optional<SlotIndex> slot(NodeId node) const;
  /// Of its controller on the bus of the group.
  std::optional<SlotIndex> group_slot() const;
  /// Null where it is not simulated here.
  Node* node(NodeId id);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace canvoy::lift
