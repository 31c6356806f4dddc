// Flying master: of the devices that may be NMT master, one becomes it, and another one if that is
// lost (CiA 302-2, NMT flying master; 1F80h bit 5, 1F90h, 1F91h).
//
// Frames and times are those of another implementation: the specification was not available.
// Uncertain details are options.
//
//     FlyingMaster flying(node, commands, boot_manager);
//     flying.on_change(Callback<void(FlyingMaster::State)>::to<&App::role_is>(app));
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/boot_manager.hpp"

namespace canvoy {

/// Negotiates. After each reset it waits (1F90h:02h) for its node slot, asks for the active NMT
/// master, and waits for its answer (1F90h:01h). Without an answer, all nodes are reset once, so
/// that all competitors start at the same moment. Then each waits for its time slot, by priority
/// (1F90h:03h and 04h) and node-ID (05h), and the first becomes the master, and boots the network.
///
/// A device that finds an active master of lower priority forces a new negotiation. An active
/// master repeats this call periodically (06h), so that several masters find each other. When the
/// heartbeat (1016h) of the active master, or its node guarding, is lost, the procedure starts
/// again.
///
/// The node slot (05h, once for each node-ID) separates devices that begin at the same moment,
/// after a reset or a loss that all have seen: if all nodes of a bus send the same frame at once,
/// no node is left to acknowledge it, and they would send it forever.
class FlyingMaster {
 public:
  /// CAN-IDs of the negotiation, and what is not certain.
  struct Options {
    std::uint16_t active_master = 0x071;          ///< priority and node-ID of the active master
    std::uint16_t negotiation = 0x072;            ///< competitors begin to count
    std::uint16_t active_master_request = 0x073;  ///< is there an active master?
    std::uint16_t capable_answer = 0x074;         ///< a device that may be NMT master is present
    std::uint16_t capable_request = 0x075;        ///< which devices may be NMT master?
    std::uint16_t force_negotiation = 0x076;      ///< all begin again
    /// Whether a lower node-ID of the same priority forces a negotiation.
    bool node_id_forces = false;
    /// Whether all nodes are reset the first time that no master is found.
    bool resets_all = true;
  };
  /// Role in the negotiation.
  enum class State : std::uint8_t {
    off,          ///< not a flying master by 1F80h
    waiting,      ///< after a reset
    detecting,    ///< has requested the active master
    negotiating,  ///< waits for its time slot
    master,
    slave,  ///< of active_master()
  };

  /// Makes the service, which needs six routes. All arguments must outlive it.
  FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager);
  /// Like the above, with other options. All must outlive it.
  FlyingMaster(Node& node, NmtQueue& commands, BootManager& manager, const Options& options);
  FlyingMaster(const FlyingMaster&) = delete;
  FlyingMaster& operator=(const FlyingMaster&) = delete;

  /// Sets the callback for each change of state().
  void on_change(Callback<void(State)> changed) { changed_ = changed; }

  /// Requests the devices that may be NMT master: `found` is called with true for each answer, and
  /// with false when the time (1F91h:01h) is over.
  void find_capable(Callback<void(bool)> found);

  /// Role of this node at present.
  State state() const { return state_; }
  /// Node-ID of the active master; 0 if unknown.
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
  /// Delay of this node after a moment that all nodes share.
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
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  State state_ = State::off;
  NodeId active_ = 0;
  bool was_reset_ = false;  ///< has not begun since a reset
  bool has_reset_all_ = false;
};

}  // namespace canvoy
