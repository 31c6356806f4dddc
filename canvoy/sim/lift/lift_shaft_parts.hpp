// What a LiftShaft is made of. For its own sources.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/devices/cia417/position/position_cam_unit.hpp"
#include "canvoy/sim/lift/car_follower.hpp"
#include "canvoy/sim/lift/car_plant.hpp"
#include "canvoy/sim/lift/door_plant.hpp"
#include "canvoy/sim/lift/lift_panel.hpp"
#include "canvoy/sim/lift/lift_shaft.hpp"
#include "canvoy/sim/lift/linked_node.hpp"
#include "canvoy/sim/lift/load_cell.hpp"
#include "canvoy/sim/lift/real_devices.hpp"
#include "canvoy/sim/lift/safety_chain.hpp"
#include "canvoy/sim/lift/shaft_controller.hpp"

namespace canvoy::lift {

/// Of the rated load, from which on a load unit says that the car is full, and hall calls are
/// passed. Nobody steps into a car with 0.8 of its persons, who may be light ones.
inline constexpr double full_share = 0.7;

/// On its own bus each lift is lift 1.
inline constexpr LiftNumber lift_of_bus = 1;

struct LiftShaft::Parts {
  Parts(World& its_world, const LiftNetworkDescription& wanted, LiftNumber number,
        ShaftHooks its_hooks);

  /// A node that is simulated here, whatever device it is.
  struct SimulatedNode {
    NodeDescription description{};
    SlotIndex slot = 0;
    Node* node = nullptr;
    std::shared_ptr<void> device{};
  };
  struct Panel {
    NodeDescription description{};
    std::unique_ptr<LiftPanel> panel{};
  };
  /// A door with its plant; what its unit orders is passed on, and looked at.
  struct Door {
    Door(Parts& its_shaft, const DoorPlantOptions& options) : shaft(its_shaft), plant(options) {}
    cia417::DoorHardware hardware();
    void drive(const cia417::DoorDrive& order, Time at);
    void lock(bool locks, Time at);

    Parts& shaft;
    DoorPlant plant;
    cia417::DoorHardware behind = plant.hardware();
    std::size_t unit = no_node;  ///< its place among the nodes
    std::function<void()> unit_changed{};
    bool has_somebody = false;
    bool is_barred = false;  ///< a real light barrier says so
    bool is_there = false;
  };
  static constexpr std::size_t no_node = ~std::size_t{0};

  // lift_shaft_nodes.cpp: putting it together
  void add_nodes();
  void add_node(const NodeDescription& node);
  void add_controller(const NodeDescription& node);
  void add_drive(const NodeDescription& node);
  void follow_real_devices();
  RealDevices::Wanted real_devices() const;
  void add_position(const NodeDescription& node);
  void add_door(const NodeDescription& node);
  template <unsigned mask>
  void add_door_unit(const NodeDescription& node);
  void add_light_barrier(const NodeDescription& node);
  void leave_doors_to_others(const NodeDescription& watching, Node& device);
  void add_load(const NodeDescription& node);
  void add_panel(const NodeDescription& node);
  ShaftControllerOptions controller_options(const NodeDescription& node) const;
  std::vector<cia417::VirtualOutput> outputs_of_panels() const;
  PanelControls controls_of(const NodeDescription& panel) const;
  std::optional<NodeId> id_of(DeviceKind kind, DoorNumber door = 0) const;
  bool is_played(DeviceKind kind, DoorNumber door = 0) const;
  template <class Device>
  SimulatedNode& keep(const NodeDescription& node, SlotIndex slot, std::shared_ptr<Device> device);

  // lift_shaft.cpp
  Time now() { return world.now(); }
  CarPlantDesign car_design() const;
  void kick();
  void step(Time now);
  SafetySight safety_sight(Time at);
  void close_or_cut(Time at);
  void look_again(std::size_t node, const std::function<void()>& changed);
  cia417::Detection see(unsigned door);
  void see_again(DoorNumber door);
  void weigh_again();
  double weighed_kg() const;
  void shown(const NodeDescription& panel, const cia417::VirtualOutput& output,
             const cia417::OutputView& view);
  void shown_at_landing(const cia417::VirtualOutput& output, const cia417::OutputView& view);
  const Panel* panel_of(const CallKey& button) const;
  PanelInput input_of(const CallKey& button) const;
  std::optional<std::size_t> key_for(const CallKey& button) const;
  FloorNumber floor_here();
  void press_special(cia417::SpecialFunction function, bool on);
  bool is_turned(bool by_people, cia417::SpecialFunction key) const;
  LiftMode mode() const;

  // lift_shaft_faults.cpp
  const SimulatedNode* find(NodeId id) const;
  std::optional<SlotIndex> slot_of(NodeId id) const;
  void set_lost(const ScheduledFault& fault, bool present);
  void set_cut(const ScheduledFault& fault, bool present);
  NodeId node_of(const ScheduledFault& fault) const;
  CallKey stuck_button(const ScheduledFault& fault) const;
  void set_stuck(const ScheduledFault& fault, bool present);
  void set_babbling(const ScheduledFault& fault, bool present);
  void set_dead_encoder(bool present);
  void set_door(const ScheduledFault& fault, bool present);
  void set_car(const ScheduledFault& fault, bool present);
  void reset_by_hand();
  Door* door_of(const ScheduledFault& fault);

  World& world;
  const LiftNetworkDescription& description;
  LiftNumber lift;
  const LiftDesign& design;
  ShaftHooks hooks;
  std::size_t bus = 0;  ///< of the world
  PlantIndex plant = 0;
  CarPlant car;
  SafetyChain chain;
  CarFollower real_car;  ///< where the drive is a real one
  std::unique_ptr<RealDevices> real{};
  std::optional<LoadSaid> real_load{};
  double people_kg = 0;
  LoadCell cell;
  std::array<std::unique_ptr<Door>, doors_max> doors;
  std::vector<cia417::Cam> cams;
  std::vector<SimulatedNode> nodes;
  std::vector<Panel> panels;
  ShaftController* controller = nullptr;
  std::size_t controller_node = no_node;  ///< its place among the nodes
  std::optional<SlotIndex> group_slot{};
  std::unique_ptr<LinkedNode> on_own_bus{};
  std::unique_ptr<LinkedNode> on_group_bus{};
  std::size_t drive = no_node;
  std::function<void()> drive_changed{};
  /// PDOs of light barriers about doors that another one watches.
  struct LeftOut {
    std::vector<NodeValue> values{};
    std::unique_ptr<NodeConfiguration> configuration{};
  };
  std::vector<std::unique_ptr<LeftOut>> left_out;
  std::size_t barrier = no_node;
  std::function<void()> barrier_changed{};
  std::size_t load = no_node;
  std::function<void()> load_changed{};
  bool barrier_is_broken = false;
  bool barrier_is_covered = false;  ///< by smoke
  Time looked_at_until{};           ///< something has just changed
  bool fire_alarm = false;
  bool fire_brigade = false;
  bool door_open_is_held = false;  ///< its button in the car
  bool overload_is_shown = false;
  std::vector<Direction> lanterns;  ///< of each floor
  bool is_put_together = false;
};

}  // namespace canvoy::lift
