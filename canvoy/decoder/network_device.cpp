// The part of Network that knows which device a node is.
#include "canvoy/decoder/network.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

bool is_product(const Identity& known, const Identity& asked) {
  return known.part(LssAddress::vendor) == asked.part(LssAddress::vendor) &&
         known.part(LssAddress::product) == asked.part(LssAddress::product);
}

}  // namespace

// What is given

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

const Profile& Network::reading_of(const Profile& profile) const {
  const auto chosen = readings_.find(&profile);
  return chosen == readings_.end() ? profile : *chosen->second;
}

void Network::use_sheet(NodeId node, const DeviceSheet& sheet, KnownBy by) {
  use_profile(node, *sheet.profile, by);
  for (const DeviceSheet::Parameter& parameter : sheet.parameters) {
    std::array<std::uint8_t, sizeof(std::uint32_t)> bytes{};
    store(bytes.data(), parameter.value + (parameter.plus_node_id ? node : 0U));
    learn(node, parameter.index, parameter.sub, bytes);
  }
}

// What is heard

NodeNews& Network::tell_of(NodeId node) {
  news_.node = node;
  return news_;
}

void Network::learn_device_type(NodeId node, std::uint64_t value) {
  const Profile* named = find_profile(static_cast<std::uint32_t>(value));
  if (named == nullptr) return;
  const Profile& profile = reading_of(*named);
  const bool is_new = nodes_.at(node).profile != &profile;
  use_profile(node, profile, KnownBy::device_type);
  if (is_new && nodes_.at(node).profile == &profile) {
    tell_of(node).profile_by = KnownBy::device_type;
  }
}

void Network::learn_identity(NodeId node, const Identity& identity) {
  if (!is_node_id(node) || identity.empty()) return;
  Node& known = nodes_.at(node);
  if (known.identity.contradicts(identity)) forget_device(node);
  const Identity before = known.identity;
  known.identity.add(identity);
  if (known.identity == before) return;
  tell_of(node).has_identity = true;
  recognize(node);
}

/// By a data sheet, or by what another device of the kind has told.
void Network::recognize(NodeId node) {
  Node& known = nodes_.at(node);
  if (!known.identity.is_product()) return;
  if (known.by == KnownBy::device_type) remember_product(known);
  const Profile* before = known.profile;
  KnownBy by = KnownBy::product;
  const auto product = products_.find(
      {known.identity.part(LssAddress::vendor), known.identity.part(LssAddress::product)});
  if (product != products_.end()) use_profile(node, *product->second, by);
  for (const DeviceSheet* sheet : sheets_) {
    if (known.by >= KnownBy::sheet || !is_product(sheet->identity, known.identity)) continue;
    by = KnownBy::sheet;
    use_sheet(node, *sheet, by);
  }
  if (known.profile != before) tell_of(node).profile_by = by;
}

void Network::remember_product(const Node& node) {
  if (!node.identity.is_product() || node.profile == nullptr) return;
  if (products_.size() >= products_max) return;
  products_[{node.identity.part(LssAddress::vendor), node.identity.part(LssAddress::product)}] =
      node.profile;
}

/// Another device has its node-ID now.
void Network::forget_device(NodeId node) {
  Node& known = nodes_.at(node);
  known.identity = {};
  if (known.by == KnownBy::given) return;
  known.profile = nullptr;
  known.by = KnownBy::nothing;
  for (auto each = parameters_.lower_bound({node, {}, 0}); each != parameters_.end(); ++each) {
    if (each->first.node != node) break;
    each->second.learned_cob_id = each->second.learned_mapping = false;
  }
  forget_defaults(node);
  forget_channels(node);
  forget_units(node);
  if (assumed_ != nullptr) use_profile(node, *assumed_, KnownBy::assumed);
}

}  // namespace canvoy::decoder
