// Parts of the description of a building that concern one lift: the nodes on its bus, the settings
// of its units, the lamps and buttons of its panels, and the places of faults.
//
//     const ShaftPlan plan(description, 2);
//     plan.id_of(DeviceKind::door, 1);      // of the unit that moves door 1
//     plan.controls_of(node);               // of a panel
//
// On a bus of its own each lift is lift 1, with its objects, CAN-IDs and lift mask.
#pragma once

#include <optional>
#include <vector>

#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"
#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"
#include "canvoy/devices/cia417/position/position_cam_unit.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/real_devices.hpp"
#include "canvoy/worlds/lift/referee.hpp"
#include "canvoy/worlds/lift/shaft_controller.hpp"

namespace canvoy::lift {

class ShaftPlan {
 public:
  /// `description` must outlive this object.
  ShaftPlan(const LiftNetworkDescription& description, LiftNumber lift);

  /// The building of the description.
  const Building& building() const { return description_->building; }
  /// Service of the controllers.
  const LiftService& service() const { return description_->service; }
  /// Design of this lift.
  const LiftDesign& design() const { return building().lift(lift_); }
  /// Number of this lift.
  LiftNumber lift() const { return lift_; }
  std::size_t bus() const { return bus_; }  ///< index among those of the description

  /// Nodes of this lift, simulated here or not, without a group controller.
  std::vector<const NodeDescription*> nodes() const;
  /// Node-ID of the first node of that kind, for that door (0: any), simulated here or not.
  std::optional<NodeId> id_of(DeviceKind kind, DoorNumber door = 0) const;
  /// Lowest door of the car.
  DoorNumber lowest_door() const;
  /// Devices that are elsewhere. A drive that is not described at all is one, too.
  RealDevices::Wanted real_devices() const;

  /// Data for the controller with this node-ID.
  ShaftControllerOptions controller_options(NodeId controller) const;
  /// Settings of the drive unit, by the design of the lift.
  cia417::CarDriveSettings drive_settings() const;
  /// Settings of the load unit, by the design of the car.
  cia417::LoadSettings load_settings() const;
  /// Cams of the shaft (cams_of_shaft()).
  std::vector<cia417::Cam> cams() const;
  /// Speed from which on units report overspeed: 1.15 of the rated speed.
  double overspeed_mm_s() const;
  /// Buttons, keys, lamps and displays of a panel of this lift.
  PanelControls controls_of(const NodeDescription& panel) const;

  /// Node of a fault: the one in the plan, or the first one that suits its kind; 0: none, or a
  /// button.
  NodeId node_of(const ScheduledFault& fault) const;
  /// True if the lift cannot run without this node.
  bool needs(NodeId id) const;
  /// Button of a stuck_button.
  CallKey stuck_button(const ScheduledFault& fault) const;
  /// Key lock that must be turned for a car call; empty: none.
  std::optional<std::size_t> key_for(const CallKey& button) const;

 private:
  const NodeDescription* find(DeviceKind kind, DoorNumber door = 0) const;
  bool is_of_lift(const NodeDescription& node) const;
  std::vector<cia417::VirtualOutput> outputs_of_panels() const;

  const LiftNetworkDescription* description_;
  LiftNumber lift_;
  std::size_t bus_ = 0;
};

}  // namespace canvoy::lift
