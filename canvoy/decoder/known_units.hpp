// Size of one count of a value where nodes give it in another entry (told_unit.hpp): the value that
// each node holds there, and the resulting descriptions.
//
//     KnownUnits units;
//     units.learn(10, 0x6480, 2, 0xFD02);
//     show(units.as_told(10, profile, entry, 0x6481, 1)->value.unit);
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/unit_source.hpp"

namespace canvoy::decoder {

class KnownUnits {
 public:
  /// Takes the value of an entry of a node; ignored if it gives no unit of other entries.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t held);
  /// Discards what a node has reported: another device has its node-ID.
  void forget(NodeId node);

  /// Returns the description with the reported unit, or the same one if none was reported. Node 0:
  /// of any node, if all nodes that reported agree. The result lives as long as this.
  const EntryInfo* as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                           unsigned index, unsigned sub);

  /// Changes whenever something is learned or discarded.
  std::uint32_t generation() const { return generation_; }

 private:
  struct Key {
    std::uint16_t index;
    std::uint8_t sub;
    NodeId node;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// The source of a copied entry, and the value of the entry that gives its unit; nothing:
  /// unknown.
  using ToldKey = std::pair<const EntryInfo*, std::optional<std::uint32_t>>;

  static constexpr std::size_t held_max = 4096;
  static constexpr std::size_t told_entries_max = 4096;

  std::optional<std::uint32_t> held_by(NodeId node, const UnitSource& teller) const;

  std::map<Key, std::uint32_t> held_;  ///< values of the entries that give units
  /// Requested descriptions; shared with copies of this.
  std::map<ToldKey, std::shared_ptr<const EntryWithUnit>> told_entries_;
  std::uint32_t generation_ = 0;
};

}  // namespace canvoy::decoder
