// Communication parameters of nodes, from SDO or from data sheets: SYNC (1007h), heartbeats (1016h,
// 1017h) and TPDOs (1800h to 1BFFh) (CiA 301, 7.5.2).
//
//     KnownParameters known;
//     known.learn(5, 0x1017, 0, 1000);
//     known.producer_time(5);  // 1 s
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::text {

/// The known parameters of a TPDO.
struct KnownTpdo {
  std::optional<CobId> cob_id = {};                    ///< 1800h:01h; nothing: unknown
  std::optional<std::uint8_t> transmission_type = {};  ///< 1800h:02h; nothing: unknown
  std::optional<Duration> inhibit_time = {};           ///< 1800h:03h; zero: none; nothing: unknown
  std::optional<Duration> event_timer = {};            ///< 1800h:05h; zero: none; nothing: unknown
  std::optional<std::uint8_t> count = {};              ///< of mapped entries
  std::map<std::uint8_t, std::uint32_t> mapping = {};  ///< by sub-index

  /// True for types 1 to 240, which follow SYNC.
  bool is_synchronous() const;
  /// True for types FEh and FFh, which are sent on events of the manufacturer or the profile.
  bool is_event_driven() const;
  /// Mapped size in bytes; nothing: not completely known.
  std::optional<unsigned> length() const;
};

/// SYNC parameters of a node (CiA 301, 7.5.2.5 and 7.5.2.6).
struct KnownSync {
  std::optional<CobId> cob_id = {};     ///< 1005h; nothing: unknown
  std::optional<Duration> period = {};  ///< 1006h; zero: none; nothing: unknown

  /// True if the node sends SYNC: bit 30 of 1005h.
  bool is_produced() const { return cob_id && (cob_id->raw & CobId::bit30) != 0; }
};

class KnownParameters {
 public:
  /// Takes an entry of a node that was read or written; ignores other than communication
  /// parameters. `node` is a node-ID.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value);
  /// 1017h; zero: no heartbeat; nothing: unknown.
  std::optional<Duration> producer_time(NodeId node) const { return producers_.at(node); }
  /// The consumer of the heartbeats of a node with the shortest time (1016h).
  struct Consumer {
    NodeId by = 0;    ///< the consumer
    Duration time{};  ///< from 1016h; above zero from consumer_of()
  };
  /// The consumer of `node` with the shortest time; nothing: none is known.
  std::optional<Consumer> consumer_of(NodeId node) const;
  /// 1007h; nothing: unknown, or none.
  std::optional<Duration> sync_window(NodeId node) const;
  /// 1005h and 1006h.
  const KnownSync& sync(NodeId node) const { return syncs_.at(node); }
  /// 1006h of the first known producer of SYNC; nothing: unknown, or none.
  std::optional<Duration> sync_period() const;
  /// True if this is a CAN-ID of SYNC: 080h, or that of a producer.
  bool is_sync(std::uint32_t can_id) const { return can_id < sync_id_count && sync_ids_[can_id]; }
  /// `number` from 1; null: unknown.
  const KnownTpdo* tpdo(NodeId node, std::uint16_t number) const;
  /// A node, and the number of a TPDO of it, from 1.
  using Place = std::pair<NodeId, std::uint16_t>;
  /// The node with a TPDO on this CAN-ID, and the number of the TPDO; null: none.
  const Place* sender_of(std::uint16_t can_id) const;
  /// By node and number.
  const std::map<Place, KnownTpdo>& tpdos() const { return tpdos_; }

 private:
  void learn_sync(NodeId node, CobId cob_id);
  void learn_tpdo(const Place& place, std::uint8_t sub, std::uint32_t value);
  KnownTpdo* place_of(NodeId node, std::uint16_t number);

  static constexpr std::size_t tpdos_max = 16384;
  static constexpr std::size_t consumers_max = 16384;

  std::array<std::optional<Duration>, node_id_max + 1> producers_{};
  std::array<Duration, node_id_max + 1> windows_{};
  std::array<KnownSync, node_id_max + 1> syncs_{};
  static constexpr std::size_t sync_id_count = 0x800;
  std::bitset<sync_id_count> sync_ids_ = std::bitset<sync_id_count>().set(can_id::sync);
  /// Entries of 1016h, by consumer and sub-index.
  std::map<std::pair<NodeId, std::uint8_t>, Consumer> consumers_;
  std::map<Place, KnownTpdo> tpdos_;
  std::map<std::uint16_t, Place> senders_;  ///< by CAN-ID, the last node that gave it
};

}  // namespace canvoy::text
