#include "canvoy/text/doctor/known_parameters.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::text {

namespace {

/// Types of PDOs that follow SYNC, and of those that follow events (CiA 301, 7.5.2.37).
constexpr std::uint8_t synchronous_first = 1;
constexpr std::uint8_t synchronous_last = 240;
constexpr std::uint8_t event_first = 0xFE;

}  // namespace

bool KnownTpdo::is_synchronous() const {
  return transmission_type && *transmission_type >= synchronous_first &&
         *transmission_type <= synchronous_last;
}

bool KnownTpdo::is_event_driven() const {
  return transmission_type && *transmission_type >= event_first;
}

std::optional<unsigned> KnownTpdo::length() const {
  if (!count) return std::nullopt;
  unsigned bits = 0;
  for (std::uint8_t sub = 1; sub <= *count; ++sub) {
    const auto mapped = mapping.find(sub);
    if (mapped == mapping.end()) return std::nullopt;
    bits += MappingValue(mapped->second).bits;
  }
  return (bits + 7) / 8;
}

void KnownParameters::learn(NodeId node, std::uint16_t index, std::uint8_t sub,
                            std::uint32_t value) {
  if (!is_node_id(node)) return;
  if (index == object_index::heartbeat_producer && sub == 0) {
    producers_.at(node) = from_milliseconds(static_cast<std::uint16_t>(value));
  } else if (index == object_index::sync_window && sub == 0) {
    windows_.at(node) = Duration(value);
  } else if (index == object_index::cob_id_sync && sub == 0) {
    learn_sync(node, CobId{value});
  } else if (index == object_index::sync_period && sub == 0) {
    syncs_.at(node).period = Duration(value);
  } else if (index == object_index::heartbeat_consumers && sub != 0) {
    if (consumers_.size() == consumers_max) return;
    consumers_[{node, sub}] = {static_cast<NodeId>(value >> 16 & 0x7FU),
                               from_milliseconds(static_cast<std::uint16_t>(value))};
  } else if (index >= object_index::tpdo_parameter && index <= object_index::tpdo_parameter_last) {
    learn_tpdo({node, static_cast<std::uint16_t>(index - object_index::tpdo_parameter + 1)}, sub,
               value);
  } else if (index >= object_index::tpdo_mapping && index <= object_index::tpdo_mapping_last) {
    const auto number = static_cast<std::uint16_t>(index - object_index::tpdo_mapping + 1);
    KnownTpdo* tpdo = place_of(node, number);
    if (tpdo == nullptr) return;
    if (sub == 0) tpdo->count = static_cast<std::uint8_t>(value);
    if (sub != 0 && sub <= pdo_bits_max) tpdo->mapping[sub] = value;
  }
}

/// A producer with a CAN-ID other than 080h has SYNC there.
void KnownParameters::learn_sync(NodeId node, CobId cob_id) {
  KnownSync& sync = syncs_.at(node);
  sync.cob_id = cob_id;
  if (sync.is_produced() && cob_id.is_base_frame()) sync_ids_.set(cob_id.can_id());
}

std::optional<Duration> KnownParameters::sync_period() const {
  for (const KnownSync& sync : syncs_) {
    if (sync.is_produced() && sync.period && *sync.period > Duration::zero()) return sync.period;
  }
  return std::nullopt;
}

KnownTpdo* KnownParameters::place_of(NodeId node, std::uint16_t number) {
  if (tpdos_.size() == tpdos_max && !tpdos_.contains({node, number})) return nullptr;
  return &tpdos_[{node, number}];
}

const KnownParameters::Place* KnownParameters::sender_of(std::uint16_t can_id) const {
  const auto found = senders_.find(can_id);
  return found == senders_.end() ? nullptr : &found->second;
}

void KnownParameters::learn_tpdo(const Place& place, std::uint8_t sub, std::uint32_t value) {
  KnownTpdo* known = place_of(place.first, place.second);
  if (known == nullptr) return;
  KnownTpdo& tpdo = *known;
  if (sub == 1) {
    std::erase_if(senders_, [&](const auto& sender) { return sender.second == place; });
    tpdo.cob_id = CobId{value};
    const bool is_sent = tpdo.cob_id->valid() && tpdo.cob_id->is_base_frame();
    if (is_sent) senders_.try_emplace(static_cast<std::uint16_t>(tpdo.cob_id->can_id()), place);
  }
  if (sub == 2) tpdo.transmission_type = static_cast<std::uint8_t>(value);
  if (sub == 3) tpdo.inhibit_time = from_100_microseconds(static_cast<std::uint16_t>(value));
  if (sub == 5) tpdo.event_timer = from_milliseconds(static_cast<std::uint16_t>(value));
}

std::optional<KnownParameters::Consumer> KnownParameters::consumer_of(NodeId node) const {
  std::optional<Consumer> shortest;
  for (const auto& [place, watched] : consumers_) {
    const bool is_of_it = watched.by == node && watched.time > Duration::zero();
    if (!is_of_it || (shortest && shortest->time <= watched.time)) continue;
    shortest = Consumer{place.first, watched.time};
  }
  return shortest;
}

std::optional<Duration> KnownParameters::sync_window(NodeId node) const {
  const Duration window = windows_.at(node);
  return window > Duration::zero() ? std::optional(window) : std::nullopt;
}

const KnownTpdo* KnownParameters::tpdo(NodeId node, std::uint16_t number) const {
  const auto found = tpdos_.find({node, number});
  return found == tpdos_.end() ? nullptr : &found->second;
}

}  // namespace canvoy::text
