#include "canvoy/worlds/bus_line/pdo_links.hpp"

#include <chrono>
#include <initializer_list>
#include <span>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia407/kit/messages.hpp"

namespace canvoy::bus_line {
namespace {

constexpr std::uint32_t short_heartbeat_ms = 500;

void link(BusNodes& nodes, DeviceKey sender, std::span<const std::uint32_t> sent,
          std::uint32_t can_id, std::span<const std::uint32_t> received,
          std::initializer_list<DeviceKey> receivers) {
  nodes.node(sender).preset_tpdo(sent, can_id);
  for (const DeviceKey receiver : receivers) nodes.node(receiver).preset_rpdo(received, can_id);
}

void link_messages(BusNodes& nodes) {
  using namespace cia407;
  const MessageIds ids = message_ids(nodes.design());
  link(nodes, vehicle_gateway_id, motion_mapping, ids.motion, motion_mapping, {computer_id});
  link(nodes, vehicle_gateway_id, motion_mapping, ids.motion, doors_only_mapping,
       {driver_display_id, first_counter_id, counting_manager_id, second_counter_id});
  link(nodes, vehicle_gateway_id, mileage_mapping, ids.mileage, mileage_mapping, {computer_id});
  link(nodes, positioning_id, position_mapping, ids.position, position_mapping, {computer_id});
  link(nodes, positioning_id, movement_mapping, ids.movement, movement_mapping, {computer_id});
  link(nodes, positioning_id, universal_time_mapping, ids.universal_time, universal_time_mapping,
       {computer_id});
  link(nodes, counting_manager_id, aboard_mapping, ids.aboard, aboard_mapping, {computer_id});
  nodes.node(first_counter_id).preset_tpdo(door_count_mapping, ids.first_count);
  nodes.node(second_counter_id).preset_tpdo(door_count_mapping, ids.second_count);
  nodes.node(counting_manager_id).preset_rpdo(door_count_mapping, ids.first_count, 0);
  nodes.node(counting_manager_id).preset_rpdo(door_count_mapping, ids.second_count, 1);
}

/// Added devices have the CAN-IDs of the pre-defined connection set.
void link_added(BusNodes& nodes) {
  using namespace cia407;
  constexpr std::uint32_t second_tpdo = 0x280;
  const std::uint32_t motion = message_ids(nodes.design()).motion;
  unsigned number = 2;  // of the counting manager's RPDOs
  for (const AddedDevice& added : nodes.design().added) {
    if (added.car != 1) continue;
    BusNode& node = nodes.node(key_of(nodes.design(), added.id));
    node.preset_rpdo(doors_only_mapping, motion);
    if (added.door == 0) continue;
    const std::uint32_t count = second_tpdo + added.id;
    node.preset_tpdo(door_count_mapping, count);
    nodes.node(counting_manager_id).preset_rpdo(door_count_mapping, count, number++);
  }
}

/// Links the stop request of the computer, or of the gateway in its place, in each car; and of the
/// gateway that requests it.
void link_stop_requests(BusNodes& nodes) {
  using namespace cia407;
  const MessageIds ids = message_ids(nodes.design());
  for (unsigned car = 1; car <= nodes.cars(); ++car) {
    nodes.node(master_in(car)).preset_tpdo(stop_request_mapping, ids.stop_request);
  }
  for (const auto& node : nodes.all()) node->preset_rpdo(stop_request_mapping, ids.stop_request);
  nodes.node(train_gateway_id).preset_tpdo(stop_request_mapping, ids.train_stop_request);
}

void watch_heartbeats(BusNodes& nodes) {
  for (const auto& node : nodes.all()) {
    const DeviceKey key = node->place().key;
    const DeviceKey master = nodes.master_of(key);
    if (key == master || key == identification_id) {
      node->preset({object_index::heartbeat_producer, 0, short_heartbeat_ms});
    }
    if (const auto own = nodes.design().heartbeats.find(key);
        own != nodes.design().heartbeats.end()) {
      const auto period = std::chrono::duration_cast<std::chrono::milliseconds>(own->second);
      node->preset(
          {object_index::heartbeat_producer, 0, static_cast<std::uint32_t>(period.count())});
    }
    if (key == master) continue;
    const auto time =
        std::chrono::duration_cast<std::chrono::milliseconds>(nodes.heartbeat_time_out(master));
    node->preset(
        {object_index::heartbeat_consumers, 1,
         std::uint32_t{nodes.id(master)} << 16 | static_cast<std::uint32_t>(time.count())});
  }
}

}  // namespace

void configure(BusNodes& nodes) {
  link_messages(nodes);
  link_added(nodes);
  link_stop_requests(nodes);
  watch_heartbeats(nodes);
}

}  // namespace canvoy::bus_line
