// What nodes have told of their communication parameters, by SDO or in their data sheets: SYNC
// (1007h), heartbeats (1016h, 1017h) and TPDOs (1800h to 1BFFh), CiA 301, 7.5.2.
//
//     KnownParameters known;
//     known.learn(5, 0x1017, 0, 1000);
//     known.producer_time(5);  // 1 s
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"

namespace canvoy::words {

/// As far as it is known.
struct KnownTpdo {
  std::optional<CobId> cob_id = {};                    ///< 1800h:01h; nothing: not known
  std::optional<std::uint8_t> transmission_type = {};  ///< 1800h:02h; nothing: not known
  std::optional<Duration> inhibit_time = {};  ///< 1800h:03h; zero: none; nothing: not known
  std::optional<Duration> event_timer = {};   ///< 1800h:05h; zero: none; nothing: not known
  std::optional<std::uint8_t> count = {};     ///< of mapped entries
  std::map<std::uint8_t, std::uint32_t> mapping = {};  ///< by sub-index

  /// It follows SYNC: types 1 to 240.
  bool is_synchronous() const;
  /// It is sent when its maker or its profile thinks so: types FEh and FFh.
  bool is_event_driven() const;
  /// What is mapped, in bytes; nothing: not all of it is known.
  std::optional<unsigned> length() const;
};

class KnownParameters {
 public:
  /// An entry of a node as it was read or written; what is no communication parameter is passed
  /// over. `node` is a node-ID.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value);
  /// 1017h; zero: it sends none. Nothing: not known.
  std::optional<Duration> producer_time(NodeId node) const { return producers_.at(node); }
  /// The shortest time after which a consumer (1016h) takes this node for lost.
  struct Consumer {
    NodeId by = 0;    ///< who watches
    Duration time{};  ///< as 1016h says; above zero from consumer_of()
  };
  /// Who takes `node` for lost soonest; nothing: no consumer of it is known.
  std::optional<Consumer> consumer_of(NodeId node) const;
  /// 1007h; nothing: not known, or it has none.
  std::optional<Duration> sync_window(NodeId node) const;
  /// `number` from 1; null: nothing is known of it.
  const KnownTpdo* tpdo(NodeId node, std::uint16_t number) const;
  /// A node, and the number of a TPDO of it, from 1.
  using Place = std::pair<NodeId, std::uint16_t>;
  /// Who tells that its TPDO has this CAN-ID, and the number of that; null: nobody.
  const Place* sender_of(std::uint16_t can_id) const;
  /// By node and number.
  const std::map<Place, KnownTpdo>& tpdos() const { return tpdos_; }

 private:
  void learn_tpdo(const Place& place, std::uint8_t sub, std::uint32_t value);
  KnownTpdo* place_of(NodeId node, std::uint16_t number);

  static constexpr std::size_t tpdos_max = 16384;
  static constexpr std::size_t consumers_max = 16384;

  std::array<std::optional<Duration>, node_id_max + 1> producers_{};
  std::array<Duration, node_id_max + 1> windows_{};
  /// What the entries of 1016h hold, by consumer and sub-index.
  std::map<std::pair<NodeId, std::uint8_t>, Consumer> consumers_;
  std::map<Place, KnownTpdo> tpdos_;
  std::map<std::uint16_t, Place> senders_;  ///< by CAN-ID, who has told it last
};

}  // namespace canvoy::words
