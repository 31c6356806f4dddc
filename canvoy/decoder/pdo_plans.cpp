#include "canvoy/decoder/pdo_plans.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"

namespace canvoy::decoder {

namespace {

using Direction = PdoInfo::Direction;

constexpr unsigned pdos_max = 512;
constexpr std::uint8_t cob_id_sub = 1;
constexpr std::uint8_t source_mpdo = 254;
constexpr std::uint8_t destination_mpdo = 255;

/// Default COB-ID of one of the first four PDOs of a node in the pre-defined connection set (CiA
/// 301, 7.3.3).
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

const PdoPlan* PdoPlans::find(std::uint32_t can_id) const {
  const Plans* plans = plans_.find(can_id);
  if (plans == nullptr) return nullptr;
  if (plans->transmit) return &*plans->transmit;
  return plans->receive ? &*plans->receive : nullptr;
}

std::optional<PdoPlan>& PdoPlans::plan(std::uint32_t can_id, Direction direction) {
  Plans& plans = plans_.at(can_id);
  return direction == Direction::transmit ? plans.transmit : plans.receive;
}

void PdoPlans::use_profile(NodeId node, const Profile& profile) {
  ++generation_;
  forget_defaults(node, profile);
  for_each_pdo(profile, [&](const PdoInfo& pdo) {
    add_default(node, profile, pdo, is_message_of(profile, pdo));
  });
}

void PdoPlans::forget(NodeId node, const Profile& profile) {
  for (auto each = parameters_.lower_bound({node, {}, 0}); each != parameters_.end(); ++each) {
    if (each->first.node != node) break;
    each->second.learned_cob_id = each->second.learned_mapping = false;
  }
  forget_defaults(node, profile);
}

/// Discards what the previous profile of the node gave; keeps what was heard.
void PdoPlans::forget_defaults(NodeId node, const Profile& profile) {
  const Key first{node, {}, 0};
  for (auto each = parameters_.lower_bound(first); each != parameters_.end(); ++each) {
    auto& [key, own] = *each;
    if (key.node != node) break;
    if (!own.learned_cob_id) own.cob_id = predefined_cob_id(node, key.direction, key.number);
    if (!own.learned_mapping) {
      own.mapping.clear();
      own.count = 0;
    }
    place(key, profile, own);
  }
}

/// PDOs of a table belong to some of the devices of the profile, and several may have the same
/// number: such a PDO is identified by its CAN-ID, not by a parameter of the node.
void PdoPlans::add_default(NodeId node, const Profile& profile, const PdoInfo& pdo,
                           bool is_message) {
  if (profile.number == cia447::profile_number) return add_car_pdo(node, profile, pdo);
  const unsigned count = std::max(pdo.number, pdo.last_number) - pdo.number + 1U;
  for (unsigned i = 0; i < count; ++i) {
    const CobId cob_id{pdo.cob_id + i + (pdo.plus_node_id ? node : 0U)};
    if (is_message) {
      add_message(pdo.plus_node_id ? node : NodeId{0}, profile, pdo, cob_id);
    } else {
      add_parameters({node, pdo.direction, static_cast<std::uint16_t>(pdo.number + i)}, profile,
                     pdo, cob_id);
    }
  }
}

/// Each node of a car has a block of CAN-IDs, in which the predefined PDOs follow each other in the
/// order of their list (canvoy/devices/cia447/kit/car_network.hpp).
void PdoPlans::add_car_pdo(NodeId node, const Profile& profile, const PdoInfo& pdo) {
  if (pdo.direction != Direction::transmit || !cia447::is_node_id(node)) return;
  const auto is_before = [&pdo](const PdoInfo& other) {
    return other.direction == pdo.direction && other.number < pdo.number;
  };
  const auto offset = static_cast<std::uint32_t>(std::ranges::count_if(profile.pdos, is_before));
  add_message(node, profile, pdo, CobId{cia447::pdo_base(node) + offset});
}

void PdoPlans::add_message(NodeId node, const Profile& profile, const PdoInfo& pdo, CobId cob_id) {
  const bool carries = !pdo.mapping.empty() || pdo.multiplexed != MpdoKind::no;
  // An initially invalid PDO (CiA 417) becomes valid with this CAN-ID when it is heard.
  if (!cob_id.is_base_frame() || cob_id.can_id() == 0 || !carries) return;
  std::optional<PdoPlan>& place = plan(cob_id.can_id(), pdo.direction);
  // The first one in the table is the most complete: receivers have dummies for unneeded entries.
  if (place) return;
  place = {.node = node,
           .direction = pdo.direction,
           .multiplexed = pdo.multiplexed,
           .mapping = {pdo.mapping.begin(), pdo.mapping.end()},
           .name = pdo.name,
           .profile = &profile};
  ++generation_;
}

/// If the profile leaves the CAN-ID open until the device has found its partner (CiA 419), the
/// pre-defined connection set is used.
void PdoPlans::add_parameters(const Key& key, const Profile& profile, const PdoInfo& pdo,
                              CobId cob_id) {
  Parameters& own = parameters(key);
  if (!own.learned_cob_id && cob_id.valid()) own.cob_id = cob_id;
  if (!own.learned_mapping) {
    own.mapping = {pdo.mapping.begin(), pdo.mapping.end()};
    own.count = static_cast<std::uint8_t>(own.mapping.size());
  }
  place(key, profile, own);
}

void PdoPlans::learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value,
                     const Profile& profile) {
  if (index < index_first || index > index_last) return;
  const unsigned offset = index - unsigned{index_first};
  const Key key{node, offset < 2 * pdos_max ? Direction::receive : Direction::transmit,
                static_cast<std::uint16_t>(offset % pdos_max + 1)};
  const bool is_mapping = offset / pdos_max % 2 != 0;
  if (is_mapping ? sub > pdo_bits_max : sub != cob_id_sub) return;
  Parameters* own = learned_parameters(key);
  if (own == nullptr) return;
  if (!is_mapping) {
    own->cob_id.raw = value;
    own->learned_cob_id = true;
  } else {
    own->learned_mapping = true;
    own->map(sub, value);
  }
  place(key, profile, *own);
}

void PdoPlans::Parameters::map(std::uint8_t sub, std::uint32_t value) {
  if (sub == 0) {
    count = static_cast<std::uint8_t>(value);
    return;
  }
  mapping.resize(std::max<std::size_t>(mapping.size(), sub));
  mapping[sub - 1] = value;
}

PdoPlans::Parameters& PdoPlans::parameters(const Key& key) {
  const auto [known, is_new] = parameters_.try_emplace(key);
  if (is_new) known->second.cob_id = predefined_cob_id(key.node, key.direction, key.number);
  return known->second;
}

/// Null if there are too many.
PdoPlans::Parameters* PdoPlans::learned_parameters(const Key& key) {
  const bool is_new = !parameters_.contains(key);
  if (is_new && learned_ == learned_max) return nullptr;
  if (is_new) ++learned_;
  return &parameters(key);
}

/// Stores the plan of a PDO under its present CAN-ID.
void PdoPlans::place(const Key& key, const Profile& profile, Parameters& own) {
  ++generation_;
  own.profile = &profile;
  if (const auto before = std::exchange(own.placed, std::nullopt)) take_away(key, *before);
  const MpdoKind kind = mpdo_kind(own.count);
  const bool carries = kind != MpdoKind::no || (own.count > 0 && own.count <= own.mapping.size());
  if (!own.cob_id.valid() || !own.cob_id.is_base_frame() || !carries) return;
  own.placed = static_cast<std::uint16_t>(own.cob_id.can_id());
  plan(*own.placed, key.direction) = plan_of(key, own);
}

PdoPlan PdoPlans::plan_of(const Key& key, const Parameters& own) {
  const MpdoKind kind = mpdo_kind(own.count);
  const std::size_t count = kind == MpdoKind::no ? own.count : 0;
  check_invariant(count <= own.mapping.size());
  return {
      .node = key.node,
      .direction = key.direction,
      .number = key.number,
      .multiplexed = kind,
      .mapping = {own.mapping.begin(), own.mapping.begin() + static_cast<std::ptrdiff_t>(count)},
      .profile = own.profile};
}

/// Another node may have a PDO there: several nodes receive the same one.
void PdoPlans::take_away(const Key& key, std::uint16_t can_id) {
  std::optional<PdoPlan>& old = plan(can_id, key.direction);
  if (!old || old->node != key.node || old->number != key.number) return;
  old.reset();
  for (const auto& [other, its] : parameters_) {
    if (other.direction == key.direction && its.placed == can_id) old = plan_of(other, its);
  }
}

}  // namespace canvoy::decoder
