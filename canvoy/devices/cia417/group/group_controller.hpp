// The controller of a group of up to 8 lifts: takes hall and destination calls from the lifts'
// panels, and assigns each to the lift that answers it best (HallDispatcher,
// DestinationDispatcher).
//
//     GroupController group(node, tpdos, heartbeats, memory, {.lifts = 4, .lift = kinds});
//
// The calls of a lift that is not received, or does not serve hall calls, are assigned to the
// others. A lift that is received again, or sends its state again, gets all calls again, and the
// end of those that have ended: after a delay, in which it sends its own calls. For the messages on
// the bus of a group, see canvoy/devices/cia417/group/group_bus.hpp.
#pragma once

#include <array>
#include <span>

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/devices/cia417/group/destination_dispatcher.hpp"
#include "canvoy/devices/cia417/group/group_bus.hpp"
#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"
#include "canvoy/devices/cia417/group/up_peak.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/devices/cia417/virtual_io/waiting_queue.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"

namespace canvoy::cia417 {

/// Settings of a group controller.
struct GroupControllerSettings {
  unsigned lifts = 8;  ///< lift 1 and up
  /// Fixed data of each lift: the floors that it serves, its times and its size.
  std::array<GroupLift, group_lifts_max> lift{};
  DispatchSettings hall{};            ///< of hall calls
  DestinationSettings destination{};  ///< of destination calls
  UpPeakSettings up_peak{};           ///< of the main floor
  Duration reconsider = 5s;           ///< period in which calls are compared with other lifts
  Duration tells_again = 1s;          ///< delay after the return of a lift
};

/// All sizes are set by the owner.
struct GroupControllerMemory {
  std::span<HallDispatcher::Slot> hall_calls;           ///< calls that wait, one for each door
  std::span<DestinationDispatcher::Slot> destinations;  ///< passengers that wait or ride, by floors
  std::span<std::uint64_t> assignments;                 ///< waiting for the bus
  std::span<std::uint64_t> acknowledgements;            ///< of destination calls
};

class GroupController {
 public:
  /// All arguments must outlive the controller.
  GroupController(Node& node, Tpdos& tpdos, HeartbeatConsumer& heartbeats,
                  const GroupControllerMemory& memory, const GroupControllerSettings& settings);

  /// `lift` is 1 to 8.
  const GroupLift& lift(unsigned lift) const { return lifts_[lift - 1]; }
  /// Hall calls, and their lifts.
  const HallDispatcher& hall_calls() const { return hall_; }
  /// Passengers with a destination, and their lifts.
  const DestinationDispatcher& destinations() const { return destinations_; }

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
  void report_again(Time now);
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
  LiftCalls shown_;                ///< hall calls that panels have to show
  LiftCalls told_;                 ///< those that they have received
  LiftCalls were_on_;              ///< those that they have shown since the group started
  LiftCalls told_again_;           ///< those to send even if unchanged
  std::size_t resend_ = SIZE_MAX;  ///< the next assignment to repeat after the queue was full
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Timer again_timer_;
  GapWatch gaps_;
};

}  // namespace canvoy::cia417
