// Another charger at the same battery: somebody else sends with the COB-ID on which the battery
// hears its charger (CiA 419, 6.1, links one of them; the clause does not say what the other does).
//
//     RivalWatch rivals(node);
//     rivals.watch(10, 0x20A);           // from here on this node sends it
//     if (rivals.is_to_leave()) ...      // the battery is the other one's
//
// Who has come last leaves. Of two that have come at once both leave, and come back one after the
// other, by their node-IDs. Who stays tells of the collision (CiA 301, 7.2.7: 8150h, with the
// CAN-ID in the first two manufacturer-specific bytes).
#pragma once

#include <cstdint>

#include "canvoy/canopen/node.hpp"

namespace canvoy::cia419 {

class RivalWatch {
 public:
  /// CAN-IDs that a node needs for it.
  static constexpr std::size_t routes = 1;
  /// Who has sent for so long was first.
  static constexpr Duration newcomer_time = 3s;
  /// One that was heard for so long does not leave.
  static constexpr Duration patience = 5s;
  /// One that was not heard for so long is gone.
  static constexpr Duration quiet_time = 3s;
  /// By how much later than the one with the node-ID before its own a charger comes back.
  static constexpr Duration turn_time = 1s;

  explicit RivalWatch(Node& node) : node_(node) {}
  RivalWatch(const RivalWatch&) = delete;
  RivalWatch& operator=(const RivalWatch&) = delete;

  /// This node sends `can_id` to the battery from now on.
  void watch(NodeId battery, std::uint16_t can_id);
  /// This node does not send it any more: whether the other one goes on is still heard.
  void leave();
  /// This node sends it, and the battery is another one's.
  bool is_to_leave() const { return is_to_leave_; }
  /// The battery has another charger, or had one a short while ago.
  bool is_served(NodeId battery) const;
  /// How long to wait before this node looks for a battery again: then one that has left at the
  /// same time is linked already, or is not yet back.
  Duration turn() const { return quiet_time + node_.id() * turn_time; }
  /// To be called each second or more often: ends the error when the other one is gone.
  void advance(Time now);
  /// Nothing is known any more.
  void forget();

 private:
  void heard(const Frame& frame, Time now);

  Node& node_;
  NodeId battery_ = 0;
  std::uint16_t can_id_ = 0;  ///< that is listened to; 0: none
  bool is_linked_ = false;
  bool is_to_leave_ = false;
  bool is_told_ = false;
  Time linked_at_{};
  Time heard_first_ = never;  ///< since it was quiet; never: it is
  Time heard_last_ = never;
};

}  // namespace canvoy::cia419
