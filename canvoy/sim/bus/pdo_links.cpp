#include "canvoy/sim/bus/pdo_links.hpp"

#include <chrono>
#include <initializer_list>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia407/messages.hpp"

namespace canvoy::bus {
namespace {

// CAN-IDs beside those of 8.1.4.3: by the pre-defined connection set. The stop request has one in
// the data sheets of who sends and receives it.
constexpr std::uint32_t motion_id = 0x180 + vehicle_gateway_id;
constexpr std::uint32_t mileage_id = 0x280 + vehicle_gateway_id;
constexpr std::uint32_t position_id = 0x180 + positioning_id;
constexpr std::uint32_t movement_id = 0x280 + positioning_id;
constexpr std::uint32_t universal_time_id = 0x380 + positioning_id;
constexpr std::uint32_t first_count_id = 0x280 + first_counter_id;
constexpr std::uint32_t second_count_id = 0x280 + second_counter_id;
constexpr std::uint32_t aboard_id = 0x280 + counting_manager_id;

constexpr std::uint32_t short_heartbeat_ms = 500;

void link(BusNodes& nodes, NodeId sender, std::span<const std::uint32_t> sent, std::uint32_t can_id,
          std::span<const std::uint32_t> received, std::initializer_list<NodeId> receivers) {
  nodes.node(sender).preset_tpdo(sent, can_id);
  for (const NodeId receiver : receivers) nodes.node(receiver).preset_rpdo(received, can_id);
}

void link_messages(BusNodes& nodes) {
  using namespace cia407;
  link(nodes, vehicle_gateway_id, motion_mapping, motion_id, motion_mapping, {computer_id});
  link(nodes, vehicle_gateway_id, motion_mapping, motion_id, doors_only_mapping,
       {driver_display_id, first_counter_id, counting_manager_id, second_counter_id});
  link(nodes, vehicle_gateway_id, mileage_mapping, mileage_id, mileage_mapping, {computer_id});
  link(nodes, positioning_id, position_mapping, position_id, position_mapping, {computer_id});
  link(nodes, positioning_id, movement_mapping, movement_id, movement_mapping, {computer_id});
  link(nodes, positioning_id, universal_time_mapping, universal_time_id, universal_time_mapping,
       {computer_id});
  link(nodes, counting_manager_id, aboard_mapping, aboard_id, aboard_mapping, {computer_id});
  nodes.node(first_counter_id).preset_tpdo(door_count_mapping, first_count_id);
  nodes.node(second_counter_id).preset_tpdo(door_count_mapping, second_count_id);
  nodes.node(counting_manager_id).preset_rpdo(door_count_mapping, first_count_id, 0);
  nodes.node(counting_manager_id).preset_rpdo(door_count_mapping, second_count_id, 1);
}

void watch_heartbeats(BusNodes& nodes) {
  for (const auto& node : nodes.all()) {
    const NodeId id = node->place().id;
    if (id == computer_id || id == identification_id || id == second_gateway_id) {
      node->preset({object_index::heartbeat_producer, 0, short_heartbeat_ms});
    }
    if (id == computer_id || id == second_gateway_id) continue;
    const NodeId master = master_of(id);
    const auto time =
        std::chrono::duration_cast<std::chrono::milliseconds>(nodes.heartbeat_time_out(master));
    node->preset({object_index::heartbeat_consumers, 1,
                  std::uint32_t{master} << 16 | static_cast<std::uint32_t>(time.count())});
  }
}

}  // namespace

void configure(BusNodes& nodes) {
  link_messages(nodes);
  watch_heartbeats(nodes);
}

}  // namespace canvoy::bus
