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
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/kit/messages.hpp"
#include "canvoy/sim/plants/bus_display.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"
#include "canvoy/worlds/bus_line/riders.hpp"

namespace canvoy::bus_line {

/// CAN-IDs beyond those of 8.1.4.3: by default, those of the pre-defined connection set. That of
/// the stop request stands in the data sheets of the devices that send and receive it.
struct MessageIds {
  std::uint32_t motion = 0x180 + vehicle_gateway_id;            ///< speed, direction, doors
  std::uint32_t mileage = 0x280 + vehicle_gateway_id;           ///< and temperature
  std::uint32_t position = 0x180 + positioning_id;              ///< longitude and latitude
  std::uint32_t movement = 0x280 + positioning_id;              ///< speed and course
  std::uint32_t universal_time = 0x380 + positioning_id;        ///< date and time
  std::uint32_t first_count = 0x280 + first_counter_id;         ///< of a door
  std::uint32_t second_count = 0x280 + second_counter_id;       ///< of the next door
  std::uint32_t aboard = 0x280 + counting_manager_id;           ///< number of people
  std::uint32_t train_stop_request = 0x180 + train_gateway_id;  ///< from the other car
  std::uint32_t stop_request = cia407::stop_request_cob_id;     ///< in both cars
};

/// A further device of the catalogue: it is started, watched and judged like the others, and has no
/// hardware around it.
struct AddedDevice {
  std::string kind{};  ///< device of CiA 407, as the catalogue names it
  NodeId id = 0;       ///< unused in that car
  unsigned car = 1;    ///< 1 or 2
  unsigned door = 0;   ///< of a passenger counter, from 1 on
};

struct BusDesign {
  unsigned cars = 2;                              ///< 1: without the second car and the train bus
  MessageIds ids{};                               ///< of all messages
  std::map<NodeId, Duration> heartbeats{};        ///< other devices keep their usual time
  std::map<NodeId, BusDisplay::Size> displays{};  ///< likewise, their usual size
  std::optional<unsigned> capacity{};             ///< of the vehicle, in people
  std::optional<std::vector<DoorUse>> doors{};    ///< from the front
  std::vector<AddedDevice> added{};               ///< beside the devices of every bus
};

/// The passenger counter of each door sends a message to the counting manager, which takes four.
inline constexpr std::size_t counted_doors_max = 4;

/// Longest heartbeat of a device: a missing one must be noticed within the time that displays have
/// to show it.
constexpr Duration heartbeat_max(NodeId id) {
  const bool is_short = id == computer_id || id == identification_id || id == second_gateway_id;
  return is_short ? Duration(500ms) : Duration(1s);
}

/// True if the bus has the device: one car has neither those of the second one, nor the gateway to
/// it.
constexpr bool is_there(const BusDesign& design, NodeId id) {
  return design.cars > 1 || (car_of(id) == 1 && id != train_gateway_id);
}
/// Reason why a CAN-ID is not allowed for the message that `sender` sends; empty: it is allowed.
std::string problem_of_id(const BusDesign& design, std::uint32_t id, NodeId sender);
/// Reason why such a device cannot be added; empty: it can.
std::string problem_of(const AddedDevice& device, const BusDesign& design);
/// Reason why the whole design makes no bus; empty: it does.
std::string problem_of(const BusDesign& design);

}  // namespace canvoy::bus_line
