#include "canvoy/decoder/known_units.hpp"

namespace canvoy::decoder {

void KnownUnits::learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t held) {
  const Key key{index, sub, node};
  const auto known = held_.find(key);
  if (known == held_.end() && (held_.size() == held_max || !is_unit_source(index, sub))) return;
  if (known != held_.end() && known->second == held) return;
  held_[key] = held;
  ++generation_;
}

void KnownUnits::forget(NodeId node) {
  std::erase_if(held_, [node](const auto& each) { return each.first.node == node; });
  ++generation_;
}

/// Value of an entry that gives a unit; for node 0 the common value of all nodes that reported it.
std::optional<std::uint32_t> KnownUnits::held_by(NodeId node, const UnitSource& teller) const {
  if (node != 0) {
    const auto own = held_.find({teller.index, teller.sub, node});
    return own == held_.end() ? std::nullopt : std::optional(own->second);
  }
  std::optional<std::uint32_t> held;
  for (auto each = held_.lower_bound({teller.index, teller.sub, 0}); each != held_.end(); ++each) {
    if (each->first.index != teller.index || each->first.sub != teller.sub) break;
    if (held && *held != each->second) return std::nullopt;
    held = each->second;
  }
  return held;
}

const EntryInfo* KnownUnits::as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                                     unsigned index, unsigned sub) {
  if (held_.empty() || entry == nullptr) return entry;
  const UnitSource teller = unit_source_of(profile, *entry, index, sub);
  if (teller.index == 0) return entry;
  const std::optional<std::uint32_t> held = held_by(node, teller);
  if (!held) return entry;
  const std::optional<Measure> measure = measure_by_source(profile, *entry, *held);
  const ToldKey key{entry, measure ? std::optional(*held) : std::nullopt};
  if (const auto known = told_entries_.find(key); known != told_entries_.end()) {
    return &known->second->entry();
  }
  // If a node reports ever new units, its counts have no unit in the end.
  const bool is_room = told_entries_.size() < told_entries_max;
  auto& told = told_entries_[is_room ? key : ToldKey{entry, std::nullopt}];
  if (told == nullptr) {
    told = std::make_shared<const EntryWithUnit>(*entry, is_room ? measure : std::nullopt);
  }
  return &told->entry();
}

}  // namespace canvoy::decoder
