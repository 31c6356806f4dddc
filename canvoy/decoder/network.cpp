#include "canvoy/decoder/network.hpp"

#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

// Settings

void Network::set_profile(NodeId node, const Profile& profile) {
  if (is_node_id(node)) use_profile(node, profile, KnownBy::given);
}

void Network::set_sheet(NodeId node, const DeviceSheet& sheet) {
  if (is_node_id(node)) use_sheet(node, sheet, KnownBy::given);
}

void Network::assume_profile(const Profile& profile) {
  assumed_ = &profile;
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    use_profile(node, profile, KnownBy::assumed);
  }
}

void Network::use_profile(NodeId node, const Profile& profile, KnownBy by) {
  if (!devices_.use_profile(node, profile, by)) return;
  if (profile.number == cia447::profile_number && !has_car_) assume_car(profile);
  pdos_.use_profile(node, profile);
}

/// In a car all nodes without a better source have its profile.
void Network::assume_car(const Profile& profile) {
  has_car_ = true;
  for (NodeId node = cia447::gateway_node_id; node <= cia447::node_id_max; ++node) {
    if (devices_.known_profile(node) == nullptr) use_profile(node, profile, KnownBy::assumed);
  }
}

void Network::use_sheet(NodeId node, const DeviceSheet& sheet, KnownBy by) {
  use_profile(node, *sheet.profile, by);
  for (const DeviceSheet::Parameter& parameter : sheet.parameters) {
    std::array<std::uint8_t, sizeof(std::uint32_t)> bytes{};
    store(bytes.data(), parameter.value + (parameter.plus_node_id ? node : 0U));
    learn(node, parameter.index, parameter.sub, bytes);
  }
}

// Traffic

void Network::learn(NodeId node, std::uint16_t index, std::uint8_t sub,
                    std::span<const std::uint8_t> bytes) {
  if (!is_node_id(node) || bytes.empty() || bytes.size() > sizeof(std::uint32_t)) return;
  const auto value = static_cast<std::uint32_t>(load_unsigned(bytes));
  if (index == object_index::device_type && sub == 0) return learn_device_type(node, value);
  if (index == object_index::identity && sub >= 1 && sub <= Identity::count) {
    Identity identity;
    identity.set(sub - 1U, value);
    return learn_identity(node, identity);
  }
  if (index >= object_index::sdo_server && index <= object_index::sdo_client_last) {
    return channels_.learn(node, index, sub, value);
  }
  if (index > PdoPlans::index_last) return units_.learn(node, index, sub, value);
  pdos_.learn(node, index, sub, value, devices_.profile(node));
}

void Network::learn_device_type(NodeId node, std::uint32_t value) {
  const Profile* named = find_profile(value);
  if (named == nullptr) return;
  const Profile& profile = reading_of(*named);
  const bool is_new = devices_.known_profile(node) != &profile;
  use_profile(node, profile, KnownBy::device_type);
  if (is_new && devices_.known_profile(node) == &profile) {
    tell_of(node).profile_by = KnownBy::device_type;
  }
}

void Network::learn_identity(NodeId node, const Identity& identity) {
  if (!is_node_id(node) || identity.empty()) return;
  if (devices_.identity(node).contradicts(identity)) forget_device(node);
  if (!devices_.add_identity(node, identity)) return;
  tell_of(node).has_identity = true;
  recognize(node);
}

/// Finds the profile by a data sheet, or from another device of the same kind.
void Network::recognize(NodeId node) {
  if (!devices_.identity(node).is_product()) return;
  if (devices_.known_by(node) == KnownBy::device_type) devices_.remember_product(node);
  const Profile* before = devices_.known_profile(node);
  KnownBy by = KnownBy::product;
  if (const Profile* known = devices_.product_of(node)) use_profile(node, *known, by);
  if (const DeviceSheet* sheet = devices_.sheet_of(node)) {
    by = KnownBy::sheet;
    use_sheet(node, *sheet, by);
  }
  if (devices_.known_profile(node) != before) tell_of(node).profile_by = by;
}

/// Another device has this node-ID.
void Network::forget_device(NodeId node) {
  if (!devices_.forget(node)) return;
  pdos_.forget(node, devices_.profile(node));
  channels_.forget(node);
  units_.forget(node);
  if (assumed_ != nullptr) use_profile(node, *assumed_, KnownBy::assumed);
}

NodeNews& Network::tell_of(NodeId node) {
  news_.node = node;
  return news_;
}

}  // namespace canvoy::decoder
