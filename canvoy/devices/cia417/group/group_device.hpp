// Whole devices for the nodes of a group's bus: a group controller, and the second node of a lift
// controller.
//
//     GroupControllerDevice<> group(port, {.lifts = 4, .lift = kinds});
//     GroupMemberDevice<> member(other_port, 3, controller.node(), controller.calls(),
//                                controller.lift());
#pragma once

#include <array>
#include <span>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/group/group_bus.hpp"
#include "canvoy/devices/cia417/group/group_controller.hpp"
#include "canvoy/devices/cia417/kit/bus_warning.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia417 {

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

/// The lift, and its group controller.
struct GroupMemberSettings {
  unsigned lift = 1;                              ///< 1 to 8
  NodeId group_controller = group_controller_id;  ///< monitored by its heartbeat
};

/// A lift controller on the bus of its group.
class GroupMember {
 public:
  /// The size of `queue` limits the calls that wait for the group bus: the lift itself takes any
  /// further one. It sets on_hall_call of `calls`, and on_stop and on_change of `lift`. All
  /// arguments must outlive this.
  GroupMember(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats, Node& lift_node,
              CallController& calls, LiftController& lift, std::span<std::uint64_t> queue,
              const GroupMemberSettings& settings);

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
  void report_anew(NodeId /*group*/);

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

/// For GroupMemberDevice.
inline constexpr auto full_group_member_layout = lay_out_device<full_group_member>();
/// For GroupControllerDevice.
inline constexpr auto full_group_controller_layout = lay_out_device<full_group_controller>();
/// Tables of multiplexed_group_controller.
template <MpdoMode mode>
inline constexpr auto multiplexed_group_controller_layout =
    lay_out_device<multiplexed_group_controller<mode>>();

/// It starts by itself; `queue_max` calls can wait for the bus.
template <const auto& layout = full_group_member_layout, std::size_t queue_max = 32>
class GroupMemberDevice : public DeviceValues<GroupMemberDevice<layout, queue_max>, layout> {
 public:
  /// `lift` is 1 to 8, and the node-ID. The other arguments are those of the lift's own device, and
  /// the node-ID of the group controller, which it monitors (1016h).
  GroupMemberDevice(const Port& port, NodeId lift, Node& lift_node, CallController& calls,
                    LiftController& controller, NodeId group_controller = group_controller_id)
      : device_(port, lift, true),
        group_controller_(group_controller),
        member_(device_.node(), device_.tpdos(), device_.heartbeat_consumer(), lift_node, calls,
                controller, queue_, {.lift = lift, .group_controller = group_controller}) {
    node().on_defaults_restored(callback<&GroupMemberDevice::restored>(*this));
  }

  /// The node on the bus of the group.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Behaviour on the bus of the group.
  GroupMember& member() { return member_; }

 private:
  void restored(ResetScope) {
    const std::uint64_t time_ms =
        node().dictionary().number(object_index::heartbeat_consumers, 1) & 0xFFFF;
    node().dictionary().set_number(object_index::heartbeat_consumers, 1,
                                   std::uint64_t{group_controller_} << 16 | time_ms);
  }

  DeviceNode<layout> device_;
  BusWarning bus_warning_{device_.node()};
  NodeId group_controller_;
  std::array<std::uint64_t, queue_max> queue_{};
  GroupMember member_;
};

/// It starts by itself; `hall_max` hall calls and `destinations_max` pairs of floors in one car can
/// wait.
template <const auto& layout = full_group_controller_layout, std::size_t hall_max = 512,
          std::size_t destinations_max = 512, std::size_t queue_max = 64,
          std::size_t own_routes = 0>
class GroupControllerDevice
    : public DeviceValues<
          GroupControllerDevice<layout, hall_max, destinations_max, queue_max, own_routes>,
          layout> {
 public:
  /// Makes the device; the context of `port` must outlive it.
  explicit GroupControllerDevice(const Port& port, const GroupControllerSettings& settings,
                                 NodeId node_id = group_controller_id)
      : device_(port, node_id, true),
        group_(device_.node(), device_.tpdos(), device_.heartbeat_consumer(),
               {hall_calls_, destinations_, assignments_, acknowledgements_}, settings) {
    node().on_defaults_restored(callback<&GroupControllerDevice::restored>(*this));
  }

  /// The node of the device.
  Node& node() { return device_.node(); }
  /// Sends errors of the device.
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }
  /// Behaviour of the group controller.
  GroupController& group() { return group_; }
  /// Behaviour of the group controller.
  const GroupController& group() const { return group_; }

 private:
  static constexpr bool hears_mpdos = hears_multiplexed(layout.tables());

  void restored(ResetScope) {
    if constexpr (hears_mpdos) {
      use_multiplexed_panels(node().dictionary(), lift_count, node().id(),
                             first_multiplexed_group_rpdo);
    }
  }

  DeviceNode<layout, own_routes> device_;
  BusWarning bus_warning_{device_.node()};
  [[no_unique_address]] canvoy::detail::Optional<VirtualMpdoConsumer, hears_mpdos> mpdos_{
      device_.node(), group_input_object.index};
  std::array<HallDispatcher::Slot, hall_max> hall_calls_{};
  std::array<DestinationDispatcher::Slot, destinations_max> destinations_{};
  std::array<std::uint64_t, queue_max> assignments_{};
  std::array<std::uint64_t, queue_max> acknowledgements_{};
  GroupController group_;
};

}  // namespace canvoy::cia417
