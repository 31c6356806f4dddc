// A lift controller on the bus of its group: hands hall and destination calls of its panels to the
// group controller, tells it where the lift is and stops, and takes the calls that it assigns.
//
//     GroupMember member(group_node, services, lift_node, calls, lift, queue, {.lift = 3});
//     // frames of the group bus go to group_node, those of the lift's own bus to lift_node
//
// While the group controller is not heard the lift answers the calls of its panels by itself, and
// those that its panels show. When it is heard again it is told the state of the lift, and these
// calls, from the beginning: either may have changed.
#pragma once

#include <span>

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/group/group_bus.hpp"
#include "canvoy/devices/cia417/group/waiting_queue.hpp"
#include "canvoy/devices/cia417/panel/virtual_mapping.hpp"
#include "canvoy/devices/gap_watch.hpp"

namespace canvoy::cia417 {

struct GroupMemberSettings {
  unsigned lift = 1;  ///< 1 to 8
  NodeId group_controller = group_controller_id;
};

class GroupMember {
 public:
  /// `queue` bounds the calls that wait for the group bus: one more is the lift's own. It takes
  /// on_hall_call of `calls`, and on_stop and on_change of `lift`. All must outlive this.
  GroupMember(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats, Node& lift_node,
              CallController& calls, LiftController& lift, std::span<std::uint64_t> queue,
              const GroupMemberSettings& settings);
  GroupMember(const GroupMember&) = delete;
  GroupMember& operator=(const GroupMember&) = delete;

  bool is_in_group() const { return is_in_group_; }
  /// Called when the lift has changed: LiftController::on_change is taken.
  void on_change(Callback<void()> changed) { changed_ = changed; }

 private:
  /// What the group was told of the lift.
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
  LiftCalls own_calls_;  ///< of landings, that the group is still to be told of
  GroupMemberSettings settings_;
  VirtualMapping call_mapping_;
  VirtualMapping status_mapping_;
  Callback<void()> changed_;
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  static const ServiceCalls lift_service_calls;
  ServiceLink service_{&service_calls, this};
  ServiceLink lift_service_{&lift_service_calls, this};  ///< of the lift's node
  bool is_in_group_ = false;
  bool is_inside_ = false;  ///< in a callback of the group's node
  bool knows_status_ = false;
  Status told_;
  Stop stop_;  ///< the last one, which was not told yet; floor 0: none
  GapWatch gaps_;
};

}  // namespace canvoy::cia417
