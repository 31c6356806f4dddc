// What one count of a value is, where nodes tell it in another entry (told_unit.hpp): what each of
// them holds there, and the descriptions that follow.
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

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/decoder/told_unit.hpp"

namespace canvoy::decoder {

class KnownUnits {
 public:
  /// An entry of a node; nothing where it tells nothing of others.
  void learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t held);
  void forget(NodeId node);

  /// The description with what was told of it; the same one where nothing was. Node 0: of whichever
  /// node it is, as far as those that have told agree. What is returned lives as long as this.
  const EntryInfo* as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                           unsigned index, unsigned sub);

  /// Another number whenever something was learned or forgotten.
  std::uint32_t generation() const { return generation_; }

 private:
  struct Key {
    std::uint16_t index;
    std::uint8_t sub;
    NodeId node;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// What a told entry is a copy of, and what its teller holds; nothing: what nobody knows.
  using ToldKey = std::pair<const EntryInfo*, std::optional<std::uint32_t>>;

  static constexpr std::size_t held_max = 4096;
  static constexpr std::size_t told_entries_max = 4096;

  std::optional<std::uint32_t> held_by(NodeId node, const Teller& teller) const;

  std::map<Key, std::uint32_t> held_;  ///< what tellers hold
  /// Those that were asked for; a copy has the same ones.
  std::map<ToldKey, std::shared_ptr<const ToldEntry>> told_entries_;
  std::uint32_t generation_ = 0;
};

}  // namespace canvoy::decoder
