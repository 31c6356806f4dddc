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
constexpr std::uint32_t node_bits = 0x7F;
constexpr std::uint32_t first_pdo_id = 0x181;
constexpr std::string_view counter_kind = "passenger-counter";

std::string hex_text(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "%Xh", static_cast<unsigned>(id));
  return text;
}

bool is_in_bus(const BusDesign& design, NodeId id) {
  return std::ranges::find(device_places, id, &DevicePlace::id) != device_places.end() ||
         std::ranges::find(design.added, id, &AddedDevice::id) != design.added.end();
}

/// Each message with its sender.
std::array<std::pair<std::uint32_t, NodeId>, 10> senders_of(const MessageIds& ids) {
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

std::string problem_of_id(const BusDesign& design, std::uint32_t id, NodeId sender) {
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
  if (is_tpdo && node != sender && is_in_bus(design, node)) {
    return hex_text(id) + " is of a TPDO of node " + std::to_string(node);
  }
  const auto all = senders_of(design.ids);
  const auto count = std::ranges::count(all, id, &std::pair<std::uint32_t, NodeId>::first);
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
  const bool is_counter = device.kind == counter_kind;
  if (is_counter != (device.door != 0)) {
    return is_counter ? "door: of which one it counts is missing"
                      : "door: of a passenger-counter alone";
  }
  if (device.car > design.cars) return "the bus has one car";
  if (is_counter && device.car != 1) return "the doors are in the first car";
  const bool is_twice = std::ranges::count(design.added, device.id, &AddedDevice::id) > 1;
  const bool is_taken =
      std::ranges::find(device_places, device.id, &DevicePlace::id) != device_places.end();
  if (is_twice || is_taken) return "node " + std::to_string(device.id) + " is there already";
  return "";
}

std::string problem_of(const BusDesign& design) {
  for (const AddedDevice& device : design.added) {
    if (std::string problem = problem_of(device, design); !problem.empty()) return problem;
  }
  for (const auto& [id, sender] : senders_of(design.ids)) {
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
