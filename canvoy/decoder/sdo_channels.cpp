#include "canvoy/decoder/sdo_channels.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::decoder {

namespace {

/// Route of the pre-defined connection set (CiA 301, 7.3.3).
std::optional<SdoRoute> default_route(std::uint32_t can_id) {
  const auto node = static_cast<NodeId>(can_id & node_id_max);
  const std::uint32_t function = can_id - node;
  const bool is_request = function == can_id::sdo_request;
  if (node == 0 || (!is_request && function != can_id::sdo_response)) return std::nullopt;
  return SdoRoute{static_cast<std::uint16_t>(can_id::sdo_request + node), 0, node, is_request};
}

/// Each pair of nodes of a car has its own CAN-IDs (CiA 447-4).
std::optional<SdoRoute> mesh_route(std::uint32_t can_id) {
  const bool asks = (can_id & 0xC0) == 0x40;
  const std::uint32_t request = asks ? can_id : can_id + 0x80;
  if (request < cia447::sdo_request(1, 1)) return std::nullopt;
  const unsigned clients = request - cia447::sdo_request(1, 1);
  const unsigned client = (clients >> 8 << 2 | (clients >> 4 & 3)) + 1;
  const unsigned server = (clients & 0x0F) + 1;
  const bool is_mesh = client <= cia447::node_id_max && client != server &&
                       cia447::sdo_request(client, server) == request;
  if (!is_mesh) return std::nullopt;
  return SdoRoute{static_cast<std::uint16_t>(request), static_cast<NodeId>(client),
                  static_cast<NodeId>(server), asks};
}

}  // namespace

std::optional<SdoRoute> SdoChannels::find(std::uint32_t can_id, bool has_car) const {
  if (can_id > Frame::id_max) return std::nullopt;
  const SdoRoute* learned = routes_.find(can_id);
  if (learned != nullptr && learned->channel != 0) return *learned;
  if (const std::optional<SdoRoute> route = default_route(can_id)) return route;
  return has_car ? mesh_route(can_id) : std::nullopt;
}

void SdoChannels::learn(NodeId node, std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
  const std::pair key{node, index};
  if (parameters_.size() == channels_max && !parameters_.contains(key)) return;
  Parameters& own = parameters_[key];
  if (sub == 1) own.to_server.raw = value;
  if (sub == 2) own.to_client.raw = value;
  if (sub == 3) own.partner = is_node_id(value & 0xFF) ? static_cast<NodeId>(value) : NodeId{0};
  place(node, index, own);
}

void SdoChannels::forget(NodeId node) {
  for (auto& [key, own] : parameters_) {
    if (key.first != node) continue;
    own.to_server = own.to_client = {};
    place(node, key.second, own);
  }
}

/// A client without a known server gives no usable route.
void SdoChannels::place(NodeId node, std::uint16_t index, Parameters& own) {
  routes_.at(own.placed_request) = {};
  routes_.at(own.placed_response) = {};
  own.placed_request = own.placed_response = 0;
  const bool is_client = index >= object_index::sdo_client;
  const NodeId server = is_client ? own.partner : node;
  const auto is_used = [](CobId cob_id) {
    return cob_id.valid() && cob_id.is_base_frame() && cob_id.can_id() != 0;
  };
  if (server == 0 || !is_used(own.to_server) || !is_used(own.to_client)) return;
  own.placed_request = static_cast<std::uint16_t>(own.to_server.can_id());
  own.placed_response = static_cast<std::uint16_t>(own.to_client.can_id());
  const NodeId client = is_client ? node : own.partner;
  routes_.at(own.placed_response) = {own.placed_request, client, server, false};
  routes_.at(own.placed_request) = {own.placed_request, client, server, true};
}

}  // namespace canvoy::decoder
