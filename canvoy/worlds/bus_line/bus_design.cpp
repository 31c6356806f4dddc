#include "canvoy/worlds/bus_line/bus_design.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "canvoy/devices/catalogue.hpp"

namespace canvoy::bus_line {

namespace {

/// CAN-IDs of the pre-defined messages (8.1.4.3).
constexpr std::array<std::uint32_t, 8> pre_defined_ids = {0x181, 0x381, 0x401, 0x481,
                                                          0x501, 0x201, 0x281, 0x301};
constexpr NodeId pre_defined_node = 1;
constexpr std::uint32_t node_bits = 0x7F;
constexpr std::uint32_t first_pdo_id = 0x181;
constexpr std::string_view counter_kind = "passenger-counter";

std::string hex_text(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "%Xh", static_cast<unsigned>(id));
  return text;
}

/// The device that is made for this bus, with power or without; null: none.
const DevicePlace* find_place(const BusDesign& design, NodeId id) {
  const std::span<const DevicePlace> places = places_of(design.cars);
  const auto found = std::ranges::find_if(
      places, [&](const DevicePlace& place) { return id_of(design, place.id) == id; });
  return found == places.end() ? nullptr : &*found;
}

/// Each message with its sender.
std::array<std::pair<std::uint32_t, DeviceKey>, 10> senders_of(const MessageIds& ids) {
  return {{{ids.motion, vehicle_gateway_id},
           {ids.mileage, vehicle_gateway_id},
           {ids.position, positioning_id},
           {ids.movement, positioning_id},
           {ids.universal_time, positioning_id},
           {ids.first_count, first_counter_id},
           {ids.second_count, second_counter_id},
           {ids.aboard, counting_manager_id},
           {ids.train_stop_request, train_gateway_id},
           {ids.stop_request, computer_id}}};
}

}  // namespace

NodeId id_of(const BusDesign& design, DeviceKey key) {
  if (key > node_id_max) {
    const std::size_t number = key - added_key(0);
    return number < design.added.size() ? design.added[number].id : NodeId{0};
  }
  const auto own = design.node_ids.find(key);
  return own == design.node_ids.end() ? key : own->second;
}

DeviceKey key_of(const BusDesign& design, NodeId id) {
  if (const DevicePlace* const place = find_place(design, id); place != nullptr) return place->id;
  const auto added = std::ranges::find(design.added, id, &AddedDevice::id);
  if (added == design.added.end()) return 0;
  return added_key(static_cast<std::size_t>(added - design.added.begin()));
}

std::string_view name_of(const BusDesign& design, NodeId id) {
  if (const DevicePlace* const place = find_place(design, id); place != nullptr) return place->name;
  const auto added = std::ranges::find(design.added, id, &AddedDevice::id);
  return added == design.added.end() ? std::string_view() : added->kind;
}

MessageIds message_ids(const BusDesign& design) {
  constexpr std::uint32_t tpdo_1 = 0x180;
  constexpr std::uint32_t tpdo_2 = 0x280;
  constexpr std::uint32_t tpdo_3 = 0x380;
  MessageIds ids = design.ids;
  const auto complete = [&design](std::uint32_t& id, std::uint32_t function, DeviceKey sender) {
    if (id == 0) id = function + id_of(design, sender);
  };
  complete(ids.motion, tpdo_1, vehicle_gateway_id);
  complete(ids.mileage, tpdo_2, vehicle_gateway_id);
  complete(ids.position, tpdo_1, positioning_id);
  complete(ids.movement, tpdo_2, positioning_id);
  complete(ids.universal_time, tpdo_3, positioning_id);
  complete(ids.first_count, tpdo_2, first_counter_id);
  complete(ids.second_count, tpdo_2, second_counter_id);
  complete(ids.aboard, tpdo_2, counting_manager_id);
  complete(ids.train_stop_request, tpdo_1, train_gateway_id);
  return ids;
}

std::string problem_of_node_id(const BusDesign& design, const DevicePlace& place) {
  const NodeId id = id_of(design, place.id);
  const std::string node = "node " + std::to_string(id);
  if (id < node_id_min || id > node_id_max) return node + " is none from 1 to 127";
  // A PDO of any other device with this node-ID could have the CAN-ID of a pre-defined message.
  if (id == pre_defined_node && place.id != computer_id) {
    return node + " is of the on-board computer: 181h to 501h are pre-defined (CiA 407, 8.1.4.3)";
  }
  for (const DevicePlace& other : places_of(design.cars)) {
    if (other.id == place.id || id_of(design, other.id) != id) continue;
    return node + " is " + std::string(other.name) + " too";
  }
  return "";
}

std::string problem_of_id(const BusDesign& design, std::uint32_t id, DeviceKey sender) {
  if (id < first_pdo_id || id > Frame::id_max || is_restricted(id)) {
    return hex_text(id) + " is no CAN-ID of a PDO: SYNC, EMCY, TIME, SDO and others have it";
  }
  if (std::ranges::find(pre_defined_ids, id) != pre_defined_ids.end()) {
    return hex_text(id) + " is that of a pre-defined message (CiA 407, 8.1.4.3)";
  }
  const auto node = static_cast<NodeId>(id & node_bits);
  const std::uint32_t function = id - node;
  const bool is_tpdo =
      function == 0x180 || function == 0x280 || function == 0x380 || function == 0x480;
  if (is_tpdo && node != id_of(design, sender) && key_of(design, node) != 0) {
    return hex_text(id) + " is of a TPDO of node " + std::to_string(node);
  }
  const auto all = senders_of(message_ids(design));
  const auto count = std::ranges::count(all, id, &std::pair<std::uint32_t, DeviceKey>::first);
  return count > 1 ? hex_text(id) + " is of two messages" : "";
}

std::string problem_of(const AddedDevice& device, const BusDesign& design) {
  const DeviceKind* const kind = find_device_kind(device.kind);
  if (kind == nullptr || kind->bus_unit == nullptr) {
    return "'" + device.kind + "' is no device of CiA 407: canvoy device --list";
  }
  const std::uint8_t code = kind->bus_unit->provides->code;
  using cia407::DeviceCode;
  for (const DeviceCode one : {DeviceCode::main_on_board_computer, DeviceCode::identification,
                               DeviceCode::train_bus_gateway}) {
    if (code == code_of(one)) return "a bus has one " + device.kind + " in a car, and no other";
  }
  if (device.id == 0) return "node: its node-ID is missing";
  const bool is_counter = device.kind == counter_kind;
  if (is_counter != (device.door != 0)) {
    return is_counter ? "door: of which one it counts is missing"
                      : "door: of a passenger-counter alone";
  }
  if (device.car > design.cars) {
    return design.cars == 1 ? "the bus has one car"
                            : "the bus has " + std::to_string(design.cars) + " cars";
  }
  if (is_counter && device.car != 1) return "the doors are in the first car";
  const bool is_twice = std::ranges::count(design.added, device.id, &AddedDevice::id) > 1;
  if (is_twice || find_place(design, device.id) != nullptr)
    return "node " + std::to_string(device.id) + " is there already";
  return "";
}

std::string problem_of(const BusDesign& design) {
  for (const DevicePlace& place : places_of(design.cars)) {
    const std::string problem = problem_of_node_id(design, place);
    if (!problem.empty()) return std::string(place.name) + ": " + problem;
  }
  for (const AddedDevice& device : design.added) {
    if (std::string problem = problem_of(device, design); !problem.empty()) return problem;
  }
  for (const auto& [id, sender] : senders_of(message_ids(design))) {
    if (std::string problem = problem_of_id(design, id, sender); !problem.empty()) return problem;
  }
  const std::size_t doors = design.doors ? design.doors->size() : 2;
  for (std::size_t door = 3; door <= doors; ++door) {
    if (std::ranges::count(design.added, door, &AddedDevice::door) == 1) continue;
    return "door " + std::to_string(door) + " wants a passenger-counter of its own";
  }
  for (const AddedDevice& device : design.added) {
    if (device.door == 0 || (device.door > 2 && device.door <= doors)) continue;
    return "there is no door " + std::to_string(device.door) + " without a counter";
  }
  const bool has_both = !design.doors || (std::ranges::any_of(*design.doors, &DoorUse::boards) &&
                                          std::ranges::any_of(*design.doors, &DoorUse::alights));
  return has_both ? "" : "people get in by some door, and out by some door";
}

}  // namespace canvoy::bus_line
