// Reports that another node sends with a CAN-ID of this node (CiA 301, 7.2.7 and table of emergency
// error codes: 8150h, CAN-ID collision): two nodes have one node-ID, or a COB-ID was given twice.
// Watched are its TPDOs, its emergencies, the answers of its default SDO server, and its heartbeat.
//
//     CollisionWatch::Slot slots[CollisionWatch::ids_beside_tpdos + 4];
//     CollisionWatch watch(node, slots, 1);   // TPDOs 1 to 4; a route for each slot
//
// DeviceNode and HeapNode have it on a host. On a small machine, the application adds it where it
// has the routes.
//
// The emergency has the CAN-ID in its first two manufacturer-specific bytes. It ends when no such
// frame was received for three seconds. A CAN-ID that an RPDO of the node receives is shared on
// purpose: it is no collision.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

class CollisionWatch {
 public:
  /// A CAN-ID that has a route; 0: none, since the node does not send with it, or receives it.
  using Slot = std::uint16_t;

  static constexpr std::size_t ids_beside_tpdos = 3;  ///< emergency, SDO answer and heartbeat
  /// After which a collision is over: longer than the usual times of heartbeats, so that one that
  /// lasts is reported once.
  static constexpr Duration quiet_time = std::chrono::seconds(3);

  /// Watches the CAN-IDs beside TPDOs, and those of as many TPDOs from number `first_tpdo` on as
  /// `slots` have room for. `slots` must outlive this. What has no route is not watched.
  CollisionWatch(Node& node, std::span<Slot> slots, std::uint16_t first_tpdo = 1);
  CollisionWatch(const CollisionWatch&) = delete;
  CollisionWatch& operator=(const CollisionWatch&) = delete;

 private:
  /// A bit for each CAN-ID of base frames. That of 0 says nothing.
  using CanIds = std::bitset<Frame::id_max + 1>;

  void reset(ResetScope scope);
  void written(const Entry& entry, Source source);
  void listen();
  void listen(Slot& slot, std::uint16_t can_id);
  std::uint16_t sent_at(std::size_t place) const;
  std::uint16_t can_id_in(std::uint16_t index, std::uint8_t sub) const;
  CanIds received_by_rpdos() const;
  void heard(const Frame& frame, Time now);
  void is_quiet(Time now);

  Node& node_;
  std::span<Slot> slots_;
  std::uint16_t first_tpdo_;
  std::uint16_t collided_ = 0;  ///< as reported; 0: none
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_{Callback<void(Time)>::to<&CollisionWatch::is_quiet>(*this)};
};

}  // namespace canvoy
