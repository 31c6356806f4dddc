// A lift controller on the bus of its group: forwards hall and destination calls of its panels to
// the group controller, reports the position and the stops of the lift, and takes the calls that
// are assigned to it.
//
//     GroupMember member(group_node, services, lift_node, calls, lift, queue, {.lift = 3});
//     // frames of the group bus go to group_node, those of the lift's own bus to lift_node
//
// While the group controller is not received, the lift itself answers the calls of its panels, and
// those that its panels show. When it is received again, it gets the whole state of the lift, and
// these calls, as both may have changed.
#pragma once

#include <span>

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/group/group_bus.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"

namespace canvoy::cia417 {

/// The lift, and its group controller.
struct GroupMemberSettings {
  unsigned lift = 1;                              ///< 1 to 8
  NodeId group_controller = group_controller_id;  ///< monitored by its heartbeat
};

class GroupMember {
 public:
  /// The size of `queue` limits the calls that wait for the group bus: the lift itself takes any
  /// further one. It sets on_hall_call of `calls`, and on_stop and on_change of `lift`. All
  /// arguments must outlive this.
  GroupMember(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats, Node& lift_node,
              CallController& calls, LiftController& lift, std::span<std::uint64_t> queue,
              const GroupMemberSettings& settings);
  GroupMember(const GroupMember&) = delete;
  GroupMember& operator=(const GroupMember&) = delete;

  /// True while the group controller is received.
  bool is_in_group() const { return is_in_group_; }
  /// Called when the lift has changed, in place of LiftController::on_change.
  void on_change(Callback<void()> changed) { changed_ = changed; }

 private:
  /// State of the lift that the group has received.
  struct Status {
    std::uint8_t floor = 0;
    Direction direction = Direction::none;
    bool moving = false;
    bool serves = false;
    bool full = false;
    FloorSet car_calls{};
    friend constexpr bool operator==(const Status&, const Status&) = default;
  };
  struct Stop {
    Landing landing{};
    DoorMask doors = 0;
  };

  void reset(ResetScope scope);
  void lift_reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void group_heard(NodeId id, RemoteState state);
  void join(bool is_in_group);
  bool offer(const VirtualInput& call);
  void stopped(const Landing& landing, DoorMask doors);
  void update();
  void announce();
  void assigned();
  void acknowledged();
  void assign(const VirtualInput& call);
  void act_on_lift();
  void tell_anew(NodeId /*group*/);

  Status status() const;
  bool call_waits() { return !queue_.empty() || !own_calls_.empty(); }
  std::uint64_t next_call();
  bool status_waits();
  std::uint64_t next_status();
  VirtualOutput next_car_call(const FloorSet& difference, const FloorSet& wanted);

  Node& node_;
  HeartbeatConsumer& heartbeats_;
  Node& lift_node_;
  CallController& calls_;
  LiftController& lift_;
  WaitingRecords queue_;
  LiftCalls own_calls_;  ///< of landings, still to be sent to the group
  GroupMemberSettings settings_;
  VirtualMapping call_mapping_;
  VirtualMapping status_mapping_;
  Callback<void()> changed_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  static const ServiceHandlers lift_service_calls;
  HandlerBinding service_{&service_calls, this};
  HandlerBinding lift_service_{&lift_service_calls, this};  ///< of the lift's node
  bool is_in_group_ = false;
  bool is_inside_ = false;  ///< in a callback of the group's node
  bool knows_status_ = false;
  Status told_;
  Stop stop_;  ///< the last one, if not yet sent; floor 0: none
  GapWatch gaps_;
};

}  // namespace canvoy::cia417
