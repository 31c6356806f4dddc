#include "canvoy/decoder/known_devices.hpp"

#include <algorithm>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

using Product = std::pair<std::uint32_t, std::uint32_t>;

Product product(const Identity& identity) {
  return {identity.part(LssAddress::vendor), identity.part(LssAddress::product)};
}

}  // namespace

const Profile& KnownDevices::reading_of(const Profile& profile) const {
  const auto chosen = readings_.find(&profile);
  return chosen == readings_.end() ? profile : *chosen->second;
}

const Profile& KnownDevices::profile(NodeId node) const {
  const Profile* known = node <= node_id_max ? nodes_.at(node).profile : nullptr;
  return known == nullptr ? base_profile() : *known;
}

bool KnownDevices::use_profile(NodeId node, const Profile& profile, KnownBy by) {
  Node& known = nodes_.at(node);
  if (by < known.by) return false;
  const bool is_another = known.profile != &profile;
  known.profile = &profile;
  known.by = by;
  if (by == KnownBy::device_type) remember_product(node);
  return is_another;
}

bool KnownDevices::add_identity(NodeId node, const Identity& identity) {
  Identity& known = nodes_.at(node).identity;
  const Identity before = known;
  known.add(identity);
  return !(known == before);
}

bool KnownDevices::forget(NodeId node) {
  Node& known = nodes_.at(node);
  known.identity = {};
  if (known.by == KnownBy::given) return false;
  known.profile = nullptr;
  known.by = KnownBy::nothing;
  return true;
}

const Profile* KnownDevices::product_of(NodeId node) const {
  const Identity& identity = nodes_.at(node).identity;
  const auto known = identity.is_product() ? products_.find(product(identity)) : products_.end();
  return known == products_.end() ? nullptr : known->second;
}

const DeviceSheet* KnownDevices::sheet_of(NodeId node) const {
  const Node& known = nodes_.at(node);
  if (known.by >= KnownBy::sheet || !known.identity.is_product()) return nullptr;
  const auto found = std::ranges::find_if(sheets_, [&known](const DeviceSheet* sheet) {
    return product(sheet->identity) == product(known.identity);
  });
  return found == sheets_.end() ? nullptr : *found;
}

void KnownDevices::remember_product(NodeId node) {
  const Node& known = nodes_.at(node);
  if (!known.identity.is_product() || known.profile == nullptr) return;
  const auto is_of = product(known.identity);
  if (products_.size() < products_max || products_.contains(is_of))
    products_[is_of] = known.profile;
}

}  // namespace canvoy::decoder
