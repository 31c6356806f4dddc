// Reports that another node sends with a COB-ID of this node (CiA 852, Table 37: 8150h, CAN-ID
// collision): of its TPDOs, emergencies, SDO answers and heartbeats.
//
//     std::array<std::uint16_t, CollisionWatch::ids_beside_tpdos + 3> ids;
//     CollisionWatch watch(node, ids);   // a route for each of them
//
// The emergency has the CAN-ID in its first two manufacturer-specific bytes. It ends when no such
// frame was received for a second.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia852 {

class CollisionWatch {
 public:
  static constexpr std::size_t ids_beside_tpdos = 3;  ///< emergency, SDO answer and heartbeat
  /// After which a collision is over.
  static constexpr Duration quiet_time = std::chrono::seconds(1);

  /// COB-IDs without room in `ids`, which must outlive this, are not monitored.
  CollisionWatch(Node& node, std::span<std::uint16_t> ids);
  CollisionWatch(const CollisionWatch&) = delete;
  CollisionWatch& operator=(const CollisionWatch&) = delete;

 private:
  void reset(ResetScope scope);
  void written(const Entry& entry, Source source);
  void listen_anew();
  void listen_to(std::uint16_t can_id);
  void heard(const Frame& frame, Time now);
  void is_quiet(Time now);

  Node& node_;
  std::span<std::uint16_t> ids_;
  std::size_t used_ = 0;
  std::uint16_t collided_ = 0;  ///< as reported; 0: none
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_{callback<&CollisionWatch::is_quiet>(*this)};
};

}  // namespace canvoy::cia852
