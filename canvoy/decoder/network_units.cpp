// The part of Network that knows what one count of a value is, where nodes tell it.
#include "canvoy/decoder/network.hpp"

namespace canvoy::decoder {

void Network::learn_unit(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint64_t value) {
  const UnitKey key{index, sub, node};
  const auto known = units_.find(key);
  if (known == units_.end() && (units_.size() == units_max || !is_teller(index, sub))) return;
  const auto held = static_cast<std::uint32_t>(value);
  if (known != units_.end() && known->second == held) return;
  units_[key] = held;
  ++generation_;
}

void Network::forget_units(NodeId node) {
  std::erase_if(units_, [node](const auto& each) { return each.first.node == node; });
  ++generation_;
}

/// What a node holds in an entry that tells a unit; of node 0 what all that have told hold.
std::optional<std::uint32_t> Network::told_unit(NodeId node, const Teller& teller) const {
  if (node != 0) {
    const auto own = units_.find({teller.index, teller.sub, node});
    return own == units_.end() ? std::nullopt : std::optional(own->second);
  }
  std::optional<std::uint32_t> held;
  for (auto each = units_.lower_bound({teller.index, teller.sub, 0}); each != units_.end();
       ++each) {
    if (each->first.index != teller.index || each->first.sub != teller.sub) break;
    if (held && *held != each->second) return std::nullopt;
    held = each->second;
  }
  return held;
}

const EntryInfo* Network::as_told(NodeId node, const Profile& profile, const EntryInfo* entry,
                                  unsigned index, unsigned sub) {
  if (units_.empty() || entry == nullptr) return entry;
  const Teller teller = teller_of(profile, *entry, index, sub);
  if (teller.index == 0) return entry;
  const std::optional<std::uint32_t> held = told_unit(node, teller);
  if (!held) return entry;
  const std::optional<Measure> measure = told_measure(profile, *entry, *held);
  const ToldKey key{entry, measure ? std::optional(*held) : std::nullopt};
  if (const auto known = told_entries_.find(key); known != told_entries_.end()) {
    return &known->second->entry();
  }
  // Of a node that tells something else all the time, counts have no unit in the end.
  const bool is_room = told_entries_.size() < told_entries_max;
  auto& told = told_entries_[is_room ? key : ToldKey{entry, std::nullopt}];
  if (told == nullptr) {
    told = std::make_shared<const ToldEntry>(*entry, is_room ? measure : std::nullopt);
  }
  return &told->entry();
}

}  // namespace canvoy::decoder
