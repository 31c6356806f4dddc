// The devices of one lift without its panels: each unit at its slot on the bus, with the plant that
// it senses and moves.
//
//     ShaftUnits units(world, plan, {car, doors, barrier, load}, nodes);
//     units.add(node);
//     units.controller()->mode();
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/car_follower.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/change_signal.hpp"
#include "canvoy/worlds/lift/fault.hpp"
#include "canvoy/worlds/lift/safety_chain.hpp"
#include "canvoy/worlds/lift/shaft_controller.hpp"
#include "canvoy/worlds/lift/shaft_door.hpp"
#include "canvoy/worlds/lift/shaft_load.hpp"
#include "canvoy/worlds/lift/shaft_nodes.hpp"
#include "canvoy/worlds/lift/shaft_plan.hpp"
#include "canvoy/worlds/lift/shaft_sensors.hpp"

namespace canvoy::lift {

/// The car of a lift with the safety chain that guards it, and with its drive: its own, or a real
/// one elsewhere.
///
///     ShaftCar car(building, 1, clock);
///     device(port, id, car.plant().drive_hardware());
///     car.look_at_chain(now, doors);
///     car.set_fault(FaultKind::brake, true);
class ShaftCar {
 public:
  /// `building`, and the object to which `clock` refers, must outlive this object.
  ShaftCar(const Building& building, LiftNumber lift, Callback<Time()> clock);
  ShaftCar(const ShaftCar&) = delete;
  ShaftCar& operator=(const ShaftCar&) = delete;

  /// The car in its shaft.
  CarPlant& plant() { return plant_; }
  /// The car in its shaft.
  const CarPlant& plant() const { return plant_; }
  /// The drive unit reads its inputs again when `unit` tells it.
  void has_drive_unit(ChangeSignal unit) { drive_ = std::move(unit); }
  /// Follows a real drive, and so receives all frames of the bus.
  void follow_real_drive();
  /// True if the frame comes from that drive, or is for it.
  bool hear(const Frame& frame) { return real_.hear(frame); }

  /// The part of the safety chain that must be reset by hand.
  SafetyChain::Trip trip() const {
    return chain_.is_closed() ? SafetyChain::Trip::none : chain_.trip();
  }
  /// Updates the safety chain, and with it what the drive may do.
  void look_at_chain(Time now, const ShaftDoors& doors);
  /// Opens the safety chain by a stop switch, or closes it again.
  void press_stop(bool is_pressed) { is_stopped_by_hand_ = is_pressed; }
  /// Moves the car by hand, off its safety gear; at 0, the gear catches it again if it had. False:
  /// the car follows a real drive, and is moved there.
  bool crank(double metre_per_second);
  /// True if it moves although its brake is closed.
  static bool drifts(const CarPlant::Truth& car) {
    return car.brake_is_closed && car.velocity_m_s != 0;
  }
  /// True if its motor runs away, or its brake holds nothing.
  bool is_unheld() const {
    return plant_.faults().motor_runs_away || plant_.faults().brake_share == 0;
  }
  /// Floor where it stands, or which it passes; no_floor: between two.
  FloorNumber floor();

  /// A drive without its electronics has no power stage, and its brake closes.
  void lose_drive();
  /// Begins or ends a fault of drive, brake, ropes or encoder.
  void set_fault(FaultKind kind, bool present);
  /// True if drive, brake and ropes are in order.
  bool is_whole() const;
  /// Pulls the car off its safety gear, and closes what must be closed by hand.
  void reset_by_hand();
  /// Closes what the self-test of the brake has opened.
  void reset_brake();

 private:
  SafetySight sight(Time now, const ShaftDoors& doors);

  const Building* building_;
  CarPlant plant_;
  SafetyChain chain_;
  CarFollower real_;
  ChangeSignal drive_;
  bool is_stopped_by_hand_ = false;
  bool is_cranked_ = false;
  bool has_no_brake_ = false;
  bool has_weak_brake_ = false;
  bool is_led_ = false;      ///< follows a real drive
  bool was_caught_ = false;  ///< by its gear, before it was cranked
};

/// The light barriers of a car, one in each door, for a unit that is a node of its own.
///
///     ShaftLightBarrier barrier(doors);
///     device(port, id, barrier.hardware());
///     barrier.cover(true);    // by smoke
class ShaftLightBarrier {
 public:
  /// `doors` must outlive this object.
  explicit ShaftLightBarrier(const ShaftDoors& doors) : doors_(&doors) {}
  ShaftLightBarrier(const ShaftLightBarrier&) = delete;
  ShaftLightBarrier& operator=(const ShaftLightBarrier&) = delete;

  /// Hardware for its unit; valid as long as this object.
  cia417::LightBarrierHardware hardware() {
    return {.sense = callback<&ShaftLightBarrier::see>(*this)};
  }
  /// The unit reads its inputs again when `unit` tells it.
  void has_unit(ChangeSignal unit) { unit_ = std::move(unit); }

  /// Call it when a person has stepped into a door, or out of it.
  void look_again() const { unit_.tell(); }
  /// Breaks it, which it reports, or mends it.
  void break_down(bool is_broken) {
    is_broken_ = is_broken;
    look_again();
  }
  /// Interrupts it for ever, or frees it.
  void cover(bool is_covered) {
    is_covered_ = is_covered;
    look_again();
  }

 private:
  cia417::Detection see(unsigned door) {
    const ShaftDoor& seen = *doors_->at(door - 1);
    if (!seen.is_there()) return cia417::Detection::not_available;
    if (is_broken_) return cia417::Detection::error;
    const bool is_interrupted = seen.has_somebody() || is_covered_;
    return is_interrupted ? cia417::Detection::yes : cia417::Detection::no;
  }

  const ShaftDoors* doors_;
  ChangeSignal unit_;
  bool is_broken_ = false;
  bool is_covered_ = false;
};

/// Plants that the units of a lift sense and move.
struct ShaftPlants {
  ShaftCar& car;               ///< car and its drive
  ShaftDoors& doors;           ///< doors of the car
  ShaftLightBarrier& barrier;  ///< light barriers of the doors
  ShaftLoad& load;             ///< load of the car
};

class ShaftUnits {
 public:
  /// All must outlive this object.
  ShaftUnits(World& world, const ShaftPlan& plan, const ShaftPlants& plants, ShaftNodes& nodes)
      : world_(&world), plan_(&plan), plants_(plants), nodes_(&nodes), cams_(plan.cams()) {}
  ShaftUnits(const ShaftUnits&) = delete;
  ShaftUnits& operator=(const ShaftUnits&) = delete;

  /// Adds a device that is no panel.
  void add(const NodeDescription& node);
  /// Gives the controller a second node on the bus of a group.
  void join_group(BusIndex group_bus, NodeId group_controller);
  /// Sets a special function at an input of the controller itself; does nothing where that is not
  /// simulated here, or has no power.
  void set_special(cia417::SpecialFunction function, bool on);
  /// Null where it is not simulated here.
  const ShaftController* controller() const { return controller_; }
  /// Null where the node is no sensor unit, or is not simulated here.
  ShaftSensors* sensors(NodeId id) const;
  /// Sets whether sensors in the car detect smoke.
  void smoke_in_car(bool is_there);

 private:
  /// PDOs of light barriers for doors that another unit watches.
  struct LeftOut {
    std::vector<NodeValue> values{};
    std::unique_ptr<NodeConfiguration> configuration{};
  };

  void add_controller(const NodeDescription& node);
  void add_drive(const NodeDescription& node);
  void add_position(const NodeDescription& node);
  void add_door(const NodeDescription& node);
  template <unsigned mask>
  void add_door_unit(const NodeDescription& node);
  void add_light_barrier(const NodeDescription& node);
  void leave_doors_to_others(const NodeDescription& watching, Node& device);
  void add_load(const NodeDescription& node);
  void add_sensors(const NodeDescription& node);
  template <class Device>
  void keep(const NodeDescription& node, SlotIndex slot, std::shared_ptr<Device> device);
  /// Signal for a device with one unit.
  template <class Device>
  ChangeSignal signal_to(Device& device, SlotIndex slot) const;

  World* world_;
  const ShaftPlan* plan_;
  ShaftPlants plants_;
  ShaftNodes* nodes_;
  std::vector<cia417::Cam> cams_;
  std::vector<std::shared_ptr<void>> devices_;
  std::vector<std::shared_ptr<ShaftSensors>> sensors_;
  ShaftController* controller_ = nullptr;
  NodeId controller_id_ = 0;
  std::vector<std::unique_ptr<LeftOut>> left_out_;
};

}  // namespace canvoy::lift
