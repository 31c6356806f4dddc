// Design of a fleet's buses, beside the line that they drive: CAN-IDs of messages (CiA 407, 8.1.5),
// heartbeats, displays, doors, capacity, and devices beyond those of every bus here.
//
//     BusNetworkOptions options;
//     options.design.capacity = 40;
//     options.design.added = {{.kind = "generic-io", .id = 50}};
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/kit/messages.hpp"
#include "canvoy/sim/plants/bus_display.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"
#include "canvoy/worlds/bus_line/riders.hpp"

namespace canvoy::bus_line {

/// CAN-IDs beyond those of 8.1.4.3. 0: that of the pre-defined connection set for the node-ID of
/// the sender; see message_ids(). That of the stop request stands in the data sheets of the devices
/// that send and receive it.
struct MessageIds {
  std::uint32_t motion = 0;              ///< speed, direction, doors: TPDO 1 of the vehicle gateway
  std::uint32_t mileage = 0;             ///< and temperature: TPDO 2 of the same
  std::uint32_t position = 0;            ///< longitude and latitude: TPDO 1 of positioning
  std::uint32_t movement = 0;            ///< speed and course: TPDO 2 of the same
  std::uint32_t universal_time = 0;      ///< date and time: TPDO 3 of the same
  std::uint32_t first_count = 0;         ///< of a door: TPDO 2 of its counter
  std::uint32_t second_count = 0;        ///< of the next door: likewise
  std::uint32_t aboard = 0;              ///< number of people: TPDO 2 of the counting manager
  std::uint32_t train_stop_request = 0;  ///< from another car: TPDO 1 of the train bus gateway
  std::uint32_t stop_request = cia407::stop_request_cob_id;  ///< in all cars
};

/// A further device of the catalogue: it is started, watched and judged like the others, and has no
/// hardware around it.
struct AddedDevice {
  std::string kind{};  ///< device of CiA 407, as the catalogue names it
  NodeId id = 0;       ///< of no other device in any car
  unsigned car = 1;    ///< 1 to 4
  unsigned door = 0;   ///< of a passenger counter, from 1 on
};

struct BusDesign {
  unsigned cars = 2;                                 ///< 1 to 4; 1: without a train bus
  MessageIds ids{};                                  ///< of all messages
  std::map<DeviceKey, NodeId> node_ids{};            ///< of devices with another than the usual one
  std::map<DeviceKey, Duration> heartbeats{};        ///< other devices keep their usual time
  std::map<DeviceKey, BusDisplay::Size> displays{};  ///< likewise, their usual size
  std::optional<unsigned> capacity{};                ///< of the vehicle, in people
  std::optional<std::vector<DoorUse>> doors{};       ///< from the front
  std::vector<AddedDevice> added{};                  ///< beside the devices of every bus
};

/// The passenger counter of each door sends a message to the counting manager, which takes four.
inline constexpr std::size_t counted_doors_max = 4;

/// Longest heartbeat of a device: a missing one must be noticed within the time that displays have
/// to show it.
constexpr Duration heartbeat_max(DeviceKey key) {
  const bool is_short = key == master_in(car_of(key)) || key == identification_id;
  return is_short ? Duration(500ms) : Duration(1s);
}

/// Node-ID of a device on its cable; 0 for a key of none.
NodeId id_of(const BusDesign& design, DeviceKey key);
/// Key of the device with this node-ID; 0 where the bus has none.
DeviceKey key_of(const BusDesign& design, NodeId id);
/// Name of the device with this node-ID, in files and logs; empty where the bus has none.
std::string_view name_of(const BusDesign& design, NodeId id);
/// The CAN-IDs of all messages, none of which is 0.
MessageIds message_ids(const BusDesign& design);

/// True if the bus has the device of device_places: not one of a car that it does not have; and one
/// car has no gateway to others.
constexpr bool is_there(const BusDesign& design, DeviceKey key) {
  return car_of(key) <= design.cars && (design.cars > 1 || key != train_gateway_id);
}
/// Reason why the node-ID of this device is not allowed; empty: it is.
std::string problem_of_node_id(const BusDesign& design, const DevicePlace& place);
/// Reason why a CAN-ID is not allowed for the message that `sender` sends; empty: it is allowed.
std::string problem_of_id(const BusDesign& design, std::uint32_t id, DeviceKey sender);
/// Reason why such a device cannot be added; empty: it can.
std::string problem_of(const AddedDevice& device, const BusDesign& design);
/// Reason why the whole design makes no bus; empty: it does.
std::string problem_of(const BusDesign& design);

}  // namespace canvoy::bus_line
