// The controller of a group of up to 8 lifts: takes hall and destination calls from the lifts'
// panels, and gives each to the lift that answers it best (HallDispatcher, DestinationDispatcher).
//
//     GroupController group(node, tpdos, heartbeats, memory, {.lifts = 4, .lift = kinds});
//
// A lift that is not heard, or does not serve hall calls, loses its calls to the others. One that
// is heard again, or tells its state anew, is told anew which calls there are, and which not any
// more: after a while, in which it has said what it was asked for alone. What travels on the bus of
// a group is in canvoy/devices/cia417/group/group_bus.hpp.
#pragma once

#include <array>
#include <span>

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/group/destination_dispatcher.hpp"
#include "canvoy/devices/cia417/group/group_bus.hpp"
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"
#include "canvoy/devices/cia417/group/up_peak.hpp"
#include "canvoy/devices/cia417/group/waiting_queue.hpp"
#include "canvoy/devices/cia417/panel/virtual_mapping.hpp"
#include "canvoy/devices/gap_watch.hpp"

namespace canvoy::cia417 {

struct GroupControllerSettings {
  unsigned lifts = 8;  ///< lift 1 and up
  /// What of each lift does not change: the floors that it serves, its times and its size.
  std::array<GroupLift, group_lifts_max> lift{};
  DispatchSettings hall{};
  DestinationSettings destination{};
  UpPeakSettings up_peak{};
  Duration reconsider = 5s;   ///< how often calls are compared with other lifts
  Duration tells_again = 1s;  ///< after a lift has come back
};

/// All bounded by their owner.
struct GroupControllerMemory {
  std::span<HallDispatcher::Slot> hall_calls;
  std::span<DestinationDispatcher::Slot> destinations;
  std::span<std::uint64_t> assignments;       ///< that wait for the bus
  std::span<std::uint64_t> acknowledgements;  ///< of destination calls
};

class GroupController {
 public:
  /// All must outlive the controller.
  GroupController(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats,
                  const GroupControllerMemory& memory, const GroupControllerSettings& settings);
  GroupController(const GroupController&) = delete;
  GroupController& operator=(const GroupController&) = delete;

  /// `lift` is 1 to 8.
  const GroupLift& lift(unsigned lift) const { return lifts_[lift - 1]; }
  const HallDispatcher& hall_calls() const { return hall_; }
  const DestinationDispatcher& destinations() const { return destinations_; }
  /// Calls for which there was no memory; panels were told that they are not affirmed.
  std::uint32_t calls_without_room() const { return calls_without_room_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void heard(NodeId id, RemoteState state);
  void call_received();
  void status_received();
  void take_hall_call(const VirtualInput& input);
  void take_destination(const VirtualInput& input);
  void lift_told(unsigned lift, const VirtualOutput& status);
  void lift_stopped(unsigned lift, const VirtualOutput& arrival);
  void update_service(unsigned lift);
  void hall_assigned(const HallCall& call, unsigned lift);
  void destination_assigned(const DestinationCall& call, unsigned lift);
  void destination_withdrawn(const DestinationCall& call, unsigned lift);
  void acknowledge(const DestinationCall& call, std::uint8_t lifts, bool on);
  void assign(const VirtualInput& record);
  void reconsider(Time now);
  void tell_again(Time now);
  void lift_returned();
  void ask_anew(NodeId /*lift*/) { lift_returned(); }
  void open_more();
  void refresh_shown();
  void announce();

  bool assignment_waits();
  std::uint64_t next_assignment();
  bool acknowledgement_waits();
  Call next_untold() const;
  std::uint64_t next_acknowledgement();
  std::size_t resend_end() const;

  Node& node_;
  GroupControllerSettings settings_;
  std::array<GroupLift, group_lifts_max> lifts_;
  std::array<bool, group_lifts_max> serves_{};
  HeartbeatConsumer& heartbeats_;
  HallDispatcher hall_;
  DestinationDispatcher destinations_;
  UpPeak up_peak_;
  WaitingRecords assignments_;
  WaitingRecords acknowledgements_;
  VirtualMapping assignment_mapping_;
  VirtualMapping acknowledgement_mapping_;
  LiftCalls shown_;       ///< hall calls that panels are to show
  LiftCalls told_;        ///< what they were told
  LiftCalls were_on_;     ///< what they have shown since the group began
  LiftCalls told_again_;  ///< what they are told whether it has changed or not
  std::uint32_t calls_without_room_ = 0;
  std::size_t resend_ = SIZE_MAX;  ///< the next assignment to tell again, where the queue was full
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  Timer again_timer_;
  GapWatch gaps_;
};

}  // namespace canvoy::cia417
