// Detects another charger at the same battery: a node that sends with the COB-ID on which the
// battery receives its charger (CiA 419, 6.1, links one of them; the clause does not describe the
// other).
//
//     RivalWatch rivals(node);
//     rivals.watch(10, 0x20A);           // from here on this node sends it
//     if (rivals.is_to_leave()) ...      // the battery is the other one's
//
// The later charger leaves. If two have come at once, both leave, and come back one after the
// other, by their node-IDs. The charger that stays reports the collision (CiA 301, 7.2.7: 8150h,
// with the CAN-ID in the first two manufacturer-specific bytes).
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia419 {

class RivalWatch {
 public:
  /// Number of CAN-IDs that it receives.
  static constexpr std::size_t routes = 1;
  /// A charger that has sent for this time was first.
  static constexpr Duration newcomer_time = 3s;
  /// A charger that was received for this time does not leave.
  static constexpr Duration patience = 5s;
  /// A charger that was not received for this time is gone.
  static constexpr Duration quiet_time = 3s;
  /// Delay after the return of the charger with the next lower node-ID.
  static constexpr Duration turn_time = 1s;

  /// Makes the watch; `node` must outlive it.
  explicit RivalWatch(Node& node) : node_(node) {}
  RivalWatch(const RivalWatch&) = delete;
  RivalWatch& operator=(const RivalWatch&) = delete;

  /// Starts to send `can_id` to the battery.
  void watch(NodeId battery, std::uint16_t can_id);
  /// Stops sending it. Whether the other charger continues is still monitored.
  void leave();
  /// True if this node sends it, and the battery belongs to another charger.
  bool is_to_leave() const { return is_to_leave_; }
  /// True if the battery has another charger, or had one a short time ago.
  bool is_served(NodeId battery) const;
  /// Time before this node searches for a battery again: a charger that has left at the same time
  /// is then already linked, or not yet back.
  Duration turn() const { return quiet_time + node_.id() * turn_time; }
  /// Call it every second or more often: it ends the error when the other charger is gone.
  void advance(Time now);
  /// Discards all that was received.
  void forget();

 private:
  void heard(const Frame& frame, Time now);

  Node& node_;
  NodeId battery_ = 0;
  std::uint16_t can_id_ = 0;  ///< received CAN-ID; 0: none
  bool is_linked_ = false;
  bool is_to_leave_ = false;
  bool is_told_ = false;
  Time linked_at_{};
  Time heard_first_ = never;  ///< after silence; never: silent
  Time heard_last_ = never;
};

}  // namespace canvoy::cia419
