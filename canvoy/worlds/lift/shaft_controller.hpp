// The controller of one lift in a building: a LiftControllerDevice with the data of its shaft.
//
//     ShaftController controller(world.port(slot), 1, description_of_the_lift);
//     world.occupy(slot, controller.node());
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/lift_snapshot.hpp"

namespace canvoy::lift {

/// Data of the shaft, for 6008h and the settings of the controller.
struct ShaftControllerOptions {
  NodeId id = 1;                                   ///< node-ID on the bus of the lift
  unsigned doors = 0b0001;                         ///< doors of the car: bit 0 is door 1
  NodeId drive = 2;                                ///< node-ID of the drive unit
  NodeId position = 4;                             ///< node-ID of the position unit
  std::array<NodeId, doors_max> door_units{};      ///< 0: there is none
  std::array<NodeId, doors_max> light_barriers{};  ///< light barriers that are nodes of their own
  NodeId load = 13;                                ///< 0: there is none
  std::vector<NodeId> others{};                    ///< other nodes of the lift: panels and the like
  /// Outputs of its panels, as 6200h lists them: at most eight groups.
  std::vector<cia417::VirtualOutput> outputs{};
  std::vector<double> heights_m{};  ///< of the floors, above floor 1
  /// Floors that each door serves; empty: all. Entries of doors that the car does not have are
  /// ignored.
  std::array<FloorList, doors_max> served{};
  /// Floors to which car calls need the key; empty: none.
  std::array<FloorList, key_locks> locked_by_key{};
  double speed_m_s = 1.6;                ///< rated speed
  double acceleration_m_s2 = 1;          ///< greatest, also of braking
  double jerk_m_s3 = 1.2;                ///< greatest change of the acceleration
  double door_zone_m = 0.2;              ///< to both sides of a floor
  FloorNumber fire_floor = 1;            ///< floor of a recall
  Duration dwell = 3s;                   ///< time for which a door stays open after the last person
  FloorNumber parking_floor = no_floor;  ///< no_floor: it stays at its floor
  Duration parking_after = 60s;          ///< time without a call, before it parks
};

class ShaftController {
 public:
  /// Makes the node at the port; start it by its slot.
  ShaftController(const Port& port, const ShaftControllerOptions& options);
  ShaftController(const ShaftController&) = delete;
  ShaftController& operator=(const ShaftController&) = delete;
  ~ShaftController();

  /// The node on the bus of the lift.
  Node& node();
  /// Emergencies of that node.
  EmergencyProducer& emergency_producer();
  /// Adds a second node, on the bus of a group. Call it once, before the start.
  Node& join_group(const Port& port, LiftNumber lift, NodeId group_controller);
  /// Sets a special function at an input of its own. From outside of its node: advance() before.
  void set(cia417::SpecialFunction function, bool on);
  /// Mode that it reports.
  LiftMode mode() const;
  /// Direction in which it travels, or shows that it will.
  Direction direction() const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace canvoy::lift
