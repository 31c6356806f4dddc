// Flying master: of the devices that may be NMT master, one becomes it, and another one when that
// is lost (CiA 302-2, NMT flying master; 1F80h bit 5, 1F90h, 1F91h).
//
// The frames and the times are those that one other implementation has: the specification was not
// at hand. What is uncertain is an option.
//
//     FlyingMaster flying(node, commands, boot_manager);
//     flying.on_change(Callback<void(FlyingMaster::State)>::to<&App::role_is>(app));
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/boot_manager.hpp"

namespace canvoy {

/// After each reset it waits (1F90h:02h) for its node slot, asks for the active NMT master, and
/// waits for its answer (1F90h:01h). Where there is none, all nodes are reset once, so that all who
/// compete do so from the same moment. Then each waits for its time slot, by priority (1F90h:03h
/// and 04h) and node-ID (05h), and whoever is first is the master, and boots the network.
///
/// Who finds an active master of lower priority forces a new negotiation. An active master repeats
/// this call in a cycle (06h), by which several masters find each other. When the heartbeat (1016h)
/// of the active master is lost, or its node guarding, all begins anew.
///
/// The node slot (05h, once for each node-ID) keeps those apart who begin at the same moment, after
/// a reset or a loss that all have seen: where all nodes of a bus send the same frame at once there
/// is nobody left to acknowledge it, and they would send it for ever.
class FlyingMaster {
 public:
  struct Options {
    std::uint16_t active_master = 0x071;  ///< priority and node-ID of the active master
    std::uint16_t negotiation = 0x072;    ///< those who compete begin to count
    std::uint16_t active_master_request = 0x073;
    std::uint16_t capable_answer = 0x074;  ///< a device that may be NMT master is there
    std::uint16_t capable_request = 0x075;
    std::uint16_t force_negotiation = 0x076;
    /// A lower node-ID of the same priority is reason enough to force a negotiation.
    bool node_id_forces = false;
    /// The first time that no master is found, all nodes are reset.
    bool resets_all = true;
  };
  enum class State : std::uint8_t {
    off,          ///< 1F80h makes it no flying master
    waiting,      ///< after a reset
    detecting,    ///< has asked for the active master
    negotiating,  ///< waits for its time slot
    master,
    slave,  ///< of active_master()
  };

  /// It needs six routes. All must outlive this.
  FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager);
  FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager, const Options& options);
  FlyingMaster(const FlyingMaster&) = delete;
  FlyingMaster& operator=(const FlyingMaster&) = delete;

  void on_change(Callback<void(State)> changed) { changed_ = changed; }

  /// Asks which devices may be NMT master: `found` is called with true for each answer, and with
  /// false when the time (1F91h:01h) is over.
  void find_capable(Callback<void(bool)> found);

  State state() const { return state_; }
  /// 0 where it is not known.
  NodeId active_master() const { return active_; }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void received(const Frame& frame, Time now);
  void active_master_told(const Frame& frame);
  bool gives_way_to(std::uint8_t priority, NodeId other) const;
  void expired(Time now);
  void detect();
  void nobody_found();
  void reset_all();
  void negotiate(bool tells_others);
  void become_master();
  void follow(NodeId master);
  void tell_active();
  void finding_over(Time now);
  void enter(State state);
  void wait(Duration duration);
  void send(std::uint16_t can_id);
  std::uint16_t parameter(std::uint16_t index, std::uint8_t sub, std::uint16_t absent) const;
  Duration time(std::uint8_t sub, std::uint16_t absent) const;
  /// From a moment that all know to this node's own.
  Duration node_slot() const;
  std::uint8_t priority() const;

  Node& node_;
  NmtQueue& commands_;
  BootManager& manager_;
  Options options_;
  Callback<void(State)> changed_;
  Callback<void(bool)> found_;
  Timer timer_;
  Timer capable_timer_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  State state_ = State::off;
  NodeId active_ = 0;
  bool was_reset_ = false;  ///< and has not begun yet
  bool has_reset_all_ = false;
};

}  // namespace canvoy
