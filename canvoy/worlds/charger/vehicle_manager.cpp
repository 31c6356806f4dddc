#include "canvoy/worlds/charger/vehicle_manager.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::charger {

namespace {

/// The default of other SDO managers.
constexpr std::uint32_t first_can_id = 0x680;

}  // namespace

constexpr ServiceHandlers VehicleManager::service_calls = {.reset = method<&VehicleManager::reset>};

VehicleManager::VehicleManager(const Port& port, NodeId id, Duration heartbeat_time_out)
    : device_(port, id),
      nodes_(device_.node(), remote_nodes_),
      manager_(device_.node(), connections_, {}) {
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    nodes_.set_time_out(node, heartbeat_time_out);
  }
  nodes_.on_change(Callback<void(NodeId, RemoteState)>::to<&SdoManager::remote_changed>(manager_));
  device_.node().attach(service_);
}

/// Its connections depend on the vehicle, not on the manager's manufacturer.
void VehicleManager::reset(ResetScope) {
  for (std::uint8_t number = 0; number < detail::vehicle_cob_ids; ++number) {
    std::array<std::uint8_t, 4> value{};
    store(value.data(), first_can_id + number);
    device_.dictionary().write(object_index::sdo_cob_ids, static_cast<std::uint8_t>(number + 1),
                               value, Source::application);
  }
}

}  // namespace canvoy::charger
