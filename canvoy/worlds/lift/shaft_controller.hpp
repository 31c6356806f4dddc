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

struct ShaftControllerOptions {
  NodeId id = 1;
  unsigned doors = 0b0001;
  NodeId drive = 2;
  NodeId position = 4;
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
  std::array<FloorList, key_locks> locked_by_key{};
  double speed_m_s = 1.6;
  double acceleration_m_s2 = 1;
  double jerk_m_s3 = 1.2;
  double door_zone_m = 0.2;
  FloorNumber fire_floor = 1;
  Duration dwell = 3s;
  FloorNumber parking_floor = no_floor;  ///< no_floor: it stays at its floor
  Duration parking_after = 60s;
};

class ShaftController {
 public:
  ShaftController(const Port& port, const ShaftControllerOptions& options);
  ShaftController(const ShaftController&) = delete;
  ShaftController& operator=(const ShaftController&) = delete;
  ~ShaftController();

  Node& node();
  EmergencyProducer& emergency_producer();
  /// Adds a second node, on the bus of a group. Call it once, before the start.
  Node& join_group(const Port& port, LiftNumber lift, NodeId group_controller);
  /// Mode that it reports.
  LiftMode mode() const;
  Direction direction() const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace canvoy::lift
