// LSS slave: gets its node-ID and bit rate over the bus (CiA 305).
//
// A node without node-ID (node_id_unconfigured) stays in NMT initialisation and sends no boot-up
// message; when LSS has given it one and its configuration ends, it boots. A node that has a
// node-ID changes it at the next NMT reset communication. LssSlaveHooks::store stores the settings.
//
//     DeviceNode<layout, LssSlave::routes> device(port, node_id_unconfigured);
//     LssSlave lss(device.node(), {.store = ...});
#pragma once

#include <type_traits>

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// The application's part of LSS. All functions are optional: without one, its service is not
/// supported.
struct LssSlaveHooks {
  /// Checks whether the hardware supports this bit timing of table selector 0 (0 to 4, 6 to 9),
  /// which then is the pending one. Nothing changes yet.
  Callback<LssError(std::uint8_t bit_timing)> configure_bit_timing;
  /// Switches to the pending bit timing, in the steps of BitTimingSwitch; not called while that is
  /// unknown.
  Callback<void(std::uint8_t bit_timing, Duration delay)> activate_bit_timing;
  /// Begins to store both values; LssSlave::stored() reports the end, at once or later.
  Callback<void(NodeId, std::uint8_t bit_timing)> store;
  /// For indicators: called when the state changed.
  Callback<void(LssState)> state_entered;
};

/// A slave. It works in every NMT state, from the start of the node on, and takes its address from
/// 1018h. A message with a length other than 8, or with an unknown command specifier, is ignored
/// and counted as malformed. An NMT reset leads back to state waiting.
///
/// Constant time and no timer: at most one message is sent for each that is received.
class LssSlave : private NodeService {
 public:
  /// Number of routes of the node that it needs.
  static constexpr std::size_t routes = is_small_machine ? 0 : 1;

  /// Makes a slave without bit timings and without storage: their code is not linked.
  constexpr explicit LssSlave(Node& node) : NodeService({on_event}, EventMask::none), node_(node) {
    begin();
  }
  /// Makes a slave. `bit_timing` is the present one as index of table selector 0, or
  /// lss_bit_timing::unknown.
  constexpr LssSlave(Node& node, const LssSlaveHooks& hooks,
                     std::uint8_t bit_timing = lss_bit_timing::unknown)
      : NodeService({on_event}, EventMask::none),
        bit_timing_(bit_timing),
        node_(node),
        configure_with_hooks_(configure_with_hooks),
        hooks_(hooks) {
    begin();
  }
  LssSlave(const LssSlave&) = delete;
  LssSlave& operator=(const LssSlave&) = delete;

  /// LSS state: configuration from a selection or global switch on, until it is switched back.
  LssState state() const { return state_; }
  /// Bit timing that activation would switch to.
  std::uint8_t pending_bit_timing() const { return bit_timing_; }

  /// Ends LssSlaveHooks::store: the master gets its answer. A node-ID that was stored without error
  /// also applies after NMT reset node.
  void stored(LssError error);

 private:
  constexpr void begin() {
    can_id_ = can_id::lss_request;
    node_.attach(*this);
    if (!std::is_constant_evaluated()) listen();
  }
  void listen();
  static void on_event(NodeService& service, ServiceEvent& event);
  void reset();
  void receive(const Frame& frame, Time now);
  void configure(lss::Command command, const Frame& frame);
  static void configure_with_hooks(LssSlave& self, lss::Command command, const Frame& frame);
  void enter(LssState state);
  void leave_configuration();

  void switch_global(std::uint8_t wanted);
  void match(lss::Command command, std::uint32_t asked);
  void fastscan(const Frame& frame);
  void configure_node_id(NodeId wanted);
  void configure_bit_timing(std::uint8_t table, std::uint8_t index);
  void activate_bit_timing(std::uint16_t milliseconds);
  void store_configuration();

  bool is_unconfigured() const;
  std::uint32_t identity(std::size_t part) const;
  void answer(lss::Command command, std::uint32_t value = 0);
  void answer(lss::Command command, LssError error);

  // Small members come first: a Cortex-M0+ reaches them with shorter instructions.
  LssState state_ = LssState::waiting;
  std::uint8_t expected_ = 0;  ///< command of the next message of a sequence that matched so far
  std::uint8_t scan_position_ = 0;  ///< part of the address that Fastscan requests next
  std::uint8_t bit_timing_ = lss_bit_timing::unknown;
  NodeId stored_id_ = 0;  ///< while it is being stored
  bool started_ = false;
  bool storing_ = false;  ///< the master waits for an answer
  Node& node_;
  void (*configure_with_hooks_)(LssSlave&, lss::Command, const Frame&) = nullptr;
  LssSlaveHooks hooks_;
};

}  // namespace canvoy
