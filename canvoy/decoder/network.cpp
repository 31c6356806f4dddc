#include "canvoy/decoder/network.hpp"

#include <algorithm>
#include <functional>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/profile_pdo.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

using Direction = PdoInfo::Direction;

constexpr unsigned car_profile = 447;
constexpr unsigned pdos_max = 512;
constexpr std::uint8_t source_mpdo = 254;
constexpr std::uint8_t destination_mpdo = 255;

/// Where the pre-defined connection set puts the first four PDOs of a node (CiA 301, 7.3.3).
CobId predefined_cob_id(NodeId node, Direction direction, unsigned number) {
  if (number < 1 || number > 4) return {};
  const unsigned first = direction == Direction::transmit ? can_id::tpdo1 : can_id::rpdo1;
  return {first + (number - 1) * 0x100 + node};
}

MpdoKind mpdo_kind(std::uint8_t count) {
  if (count == source_mpdo) return MpdoKind::source;
  return count == destination_mpdo ? MpdoKind::destination : MpdoKind::no;
}

bool is_message_of(const Profile& profile, const PdoInfo& pdo) {
  return std::less_equal<>{}(profile.pdos.begin(), &pdo) && std::less<>{}(&pdo, profile.pdos.end());
}

}  // namespace

const Profile& Network::profile(NodeId node) const {
  const Profile* known = node <= node_id_max ? nodes_.at(node).profile : nullptr;
  return known == nullptr ? base_profile() : *known;
}

const PdoPlan* Network::pdo(std::uint32_t can_id) const {
  const Plans* plans = plans_.find(can_id);
  if (plans == nullptr) return nullptr;
  if (plans->transmit) return &*plans->transmit;
  return plans->receive ? &*plans->receive : nullptr;
}

std::optional<PdoPlan>& Network::plan(std::uint32_t can_id, Direction direction) {
  Plans& plans = plans_.at(can_id);
  return direction == Direction::transmit ? plans.transmit : plans.receive;
}

// What a profile says

void Network::use_profile(NodeId node, const Profile& profile, KnownBy by) {
  Node& known = nodes_.at(node);
  if (by < known.by) return;
  const bool has_it_already = known.profile == &profile;
  known.profile = &profile;
  known.by = by;
  if (by == KnownBy::device_type) remember_product(known);
  if (has_it_already) return;
  if (profile.number == car_profile && !has_car_) assume_car(profile);
  ++generation_;
  forget_defaults(node);
  for_each_pdo(profile, [&](const PdoInfo& pdo) {
    add_default(node, profile, pdo, is_message_of(profile, pdo));
  });
}

/// In a car all nodes are of its profile: what is not known of them otherwise.
void Network::assume_car(const Profile& profile) {
  has_car_ = true;
  for (NodeId node = cia447::gateway_node_id; node <= cia447::node_id_max; ++node) {
    if (nodes_.at(node).profile == nullptr) use_profile(node, profile, KnownBy::assumed);
  }
}

/// What the profile said that the node had before; what was heard of the node stays.
void Network::forget_defaults(NodeId node) {
  const Key first{node, {}, 0};
  for (auto each = parameters_.lower_bound(first); each != parameters_.end(); ++each) {
    auto& [key, own] = *each;
    if (key.node != node) break;
    if (!own.learned_cob_id) own.cob_id = predefined_cob_id(node, key.direction, key.number);
    if (!own.learned_mapping) {
      own.mapping.clear();
      own.count = 0;
    }
    place(key, own);
  }
}

/// Those of a table belong to some of the profile's devices, and several may have one number: such
/// a PDO stands for its CAN-ID, not for a parameter of the node.
void Network::add_default(NodeId node, const Profile& profile, const PdoInfo& pdo,
                          bool is_message) {
  if (profile.number == car_profile) return add_car_pdo(node, profile, pdo);
  const unsigned count = std::max(pdo.number, pdo.last_number) - pdo.number + 1U;
  for (unsigned i = 0; i < count; ++i) {
    const CobId cob_id{pdo.cob_id + i + (pdo.plus_node_id ? node : 0U)};
    if (is_message) {
      add_message(pdo.plus_node_id ? node : NodeId{0}, profile, pdo, cob_id);
    } else {
      add_parameters({node, pdo.direction, static_cast<std::uint16_t>(pdo.number + i)}, pdo,
                     cob_id);
    }
  }
}

/// Of a car each node has a block of CAN-IDs, in which the pre-defined PDOs follow each other as
/// they are listed (canvoy/devices/cia447/car_network.hpp).
void Network::add_car_pdo(NodeId node, const Profile& profile, const PdoInfo& pdo) {
  if (pdo.direction != Direction::transmit || !cia447::is_node_id(node)) return;
  const auto is_before = [&pdo](const PdoInfo& other) {
    return other.direction == pdo.direction && other.number < pdo.number;
  };
  const auto offset = static_cast<std::uint32_t>(std::ranges::count_if(profile.pdos, is_before));
  add_message(node, profile, pdo, CobId{cia447::pdo_base(node) + offset});
}

void Network::add_message(NodeId node, const Profile& profile, const PdoInfo& pdo, CobId cob_id) {
  const bool carries = !pdo.mapping.empty() || pdo.multiplexed != MpdoKind::no;
  // One that is invalid at first (CiA 417) becomes valid with this CAN-ID: it is heard then.
  if (!cob_id.is_base_frame() || cob_id.can_id() == 0 || !carries) return;
  std::optional<PdoPlan>& place = plan(cob_id.can_id(), pdo.direction);
  // The first in the table is the most complete: receivers have dummies for what they do not want.
  if (place) return;
  place = {.node = node,
           .direction = pdo.direction,
           .multiplexed = pdo.multiplexed,
           .mapping = {pdo.mapping.begin(), pdo.mapping.end()},
           .name = pdo.name,
           .profile = &profile};
  ++generation_;
}

/// Where the profile leaves the CAN-ID open until the device knows its partner (CiA 419), it is
/// looked for in the pre-defined connection set.
void Network::add_parameters(const Key& key, const PdoInfo& pdo, CobId cob_id) {
  Parameters& own = parameters(key);
  if (!own.learned_cob_id && cob_id.valid()) own.cob_id = cob_id;
  if (!own.learned_mapping) {
    own.mapping = {pdo.mapping.begin(), pdo.mapping.end()};
    own.count = static_cast<std::uint8_t>(own.mapping.size());
  }
  place(key, own);
}

// What SDO transfers say

void Network::learn(NodeId node, std::uint16_t index, std::uint8_t sub,
                    std::span<const std::uint8_t> bytes) {
  if (!is_node_id(node) || bytes.empty() || bytes.size() > sizeof(std::uint32_t)) return;
  const std::uint64_t value = load_unsigned(bytes);
  if (index == object_index::device_type && sub == 0) return learn_device_type(node, value);
  if (index == object_index::identity && sub >= 1 && sub <= Identity::count) {
    Identity identity;
    identity.set(sub - 1U, static_cast<std::uint32_t>(value));
    return learn_identity(node, identity);
  }
  if (index >= object_index::sdo_server && index <= object_index::sdo_client_last)
    return learn_channel(node, index, sub, value);
  constexpr unsigned first = 0x1400;
  constexpr unsigned end = 0x1C00;
  if (index >= end) return learn_unit(node, index, sub, value);
  if (index < first) return;
  const unsigned offset = index - first;
  const Key key{node, offset < 2 * pdos_max ? Direction::receive : Direction::transmit,
                static_cast<std::uint16_t>(offset % pdos_max + 1)};
  const bool is_mapping = offset / pdos_max % 2 != 0;
  if (is_mapping) {
    learn_mapping(key, sub, value);
  } else {
    learn_communication(key, sub, value);
  }
}

Network::Parameters& Network::parameters(const Key& key) {
  const auto [known, is_new] = parameters_.try_emplace(key);
  if (is_new) known->second.cob_id = predefined_cob_id(key.node, key.direction, key.number);
  return known->second;
}

/// Null where they are too many.
Network::Parameters* Network::learned_parameters(const Key& key) {
  const bool is_new = !parameters_.contains(key);
  if (is_new && learned_ == learned_max) return nullptr;
  if (is_new) ++learned_;
  return &parameters(key);
}

void Network::learn_communication(const Key& key, std::uint8_t sub, std::uint64_t value) {
  constexpr std::uint8_t cob_id_sub = 1;
  if (sub != cob_id_sub) return;
  Parameters* own = learned_parameters(key);
  if (own == nullptr) return;
  own->cob_id.raw = static_cast<std::uint32_t>(value);
  own->learned_cob_id = true;
  place(key, *own);
}

void Network::learn_mapping(const Key& key, std::uint8_t sub, std::uint64_t value) {
  if (sub > pdo_bits_max) return;
  Parameters* own = learned_parameters(key);
  if (own == nullptr) return;
  own->learned_mapping = true;
  if (sub == 0) {
    own->count = static_cast<std::uint8_t>(value);
  } else {
    own->mapping.resize(std::max<std::size_t>(own->mapping.size(), sub));
    own->mapping[sub - 1] = static_cast<std::uint32_t>(value);
  }
  place(key, *own);
}

/// Puts the plan of a PDO where its CAN-ID is now.
void Network::place(const Key& key, Parameters& own) {
  ++generation_;
  if (own.placed) {
    std::optional<PdoPlan>& old = plan(*own.placed, key.direction);
    if (old && old->node == key.node && old->number == key.number) old.reset();
    own.placed.reset();
  }
  const MpdoKind kind = mpdo_kind(own.count);
  const bool carries = kind != MpdoKind::no || (own.count > 0 && own.count <= own.mapping.size());
  if (!own.cob_id.valid() || !own.cob_id.is_base_frame() || !carries) return;
  const std::size_t count = kind == MpdoKind::no ? own.count : 0;
  own.placed = static_cast<std::uint16_t>(own.cob_id.can_id());
  plan(*own.placed, key.direction) = {
      .node = key.node,
      .direction = key.direction,
      .number = key.number,
      .multiplexed = kind,
      .mapping = {own.mapping.begin(), own.mapping.begin() + static_cast<std::ptrdiff_t>(count)},
      .profile = &profile(key.node)};
}

}  // namespace canvoy::decoder
