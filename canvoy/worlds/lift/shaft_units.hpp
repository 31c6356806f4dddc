// The devices of one lift without its panels: each unit at its slot on the bus, with the plant that
// it senses and moves.
//
//     ShaftUnits units(world, plan, {car, doors, barrier, load}, nodes);
//     units.add(node);
//     units.controller()->mode();
#pragma once

#include <memory>
#include <vector>

#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/worlds/lift/shaft_car.hpp"
#include "canvoy/worlds/lift/shaft_controller.hpp"
#include "canvoy/worlds/lift/shaft_door.hpp"
#include "canvoy/worlds/lift/shaft_light_barrier.hpp"
#include "canvoy/worlds/lift/shaft_load.hpp"
#include "canvoy/worlds/lift/shaft_nodes.hpp"
#include "canvoy/worlds/lift/shaft_plan.hpp"
#include "canvoy/worlds/lift/shaft_sensors.hpp"

namespace canvoy::lift {

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
