// The physical devices of a bus: their node-IDs, names and cars, and the virtual devices of each.
// The node-IDs here are the usual ones. A fleet may give others (BusDesign::node_ids): then these
// are keys, by which a device is named inside, and BusDesign has the node-ID on the cable.
//
//     for (const DevicePlace& place : device_places) units_at(place.id) ...
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia407/kit/bus_kind.hpp"

namespace canvoy::bus_line {

/// Names a device inside: its usual node-ID, or added_key() of an added device.
using DeviceKey = std::uint8_t;

inline constexpr NodeId computer_id = 1;  ///< on-board computer with the line control; NMT master
inline constexpr NodeId identification_id = 2;     ///< login of driver, line, block and journey
inline constexpr NodeId front_display_id = 4;      ///< destination, at the front
inline constexpr NodeId next_stop_id = 5;          ///< next stop, with the sign "stop requested"
inline constexpr NodeId canceller_id = 6;          ///< ticket canceller
inline constexpr NodeId printer_id = 7;            ///< ticket printer of the driver
inline constexpr NodeId information_id = 8;        ///< information about the route
inline constexpr NodeId announcer_id = 9;          ///< acoustic announcer
inline constexpr NodeId side_display_id = 10;      ///< destination, at the side
inline constexpr NodeId vehicle_gateway_id = 11;   ///< drive, doors and engine
inline constexpr NodeId tachograph_id = 12;        ///< speed, distance, driving times
inline constexpr NodeId driver_display_id = 13;    ///< display of the driver
inline constexpr NodeId positioning_id = 16;       ///< positioning and time fixing
inline constexpr NodeId first_counter_id = 20;     ///< passenger counter of door 1
inline constexpr NodeId counting_manager_id = 21;  ///< sums of the counters
inline constexpr NodeId second_counter_id = 22;    ///< passenger counter of door 2
inline constexpr NodeId train_gateway_id = 30;     ///< gateway to the train bus

inline constexpr unsigned cars_max = 4;  ///< coupled to one train
// Devices in the cars behind the first one, each with a segment of its own: ten node-IDs for each
// car, none of which occurs in another, so that one list of names is right for all cables.
/// Gateway of car 2, 3 or 4 to the train bus; the NMT master there.
constexpr NodeId gateway_of(unsigned car) {
  return static_cast<NodeId>(10 * car + 11);
}
/// Destination, in car 2, 3 or 4.
constexpr NodeId destination_of(unsigned car) {
  return static_cast<NodeId>(10 * car + 14);
}
/// Next stop indicator of any car, with its sign.
constexpr NodeId next_stop_of(unsigned car) {
  return car == 1 ? next_stop_id : static_cast<NodeId>(10 * car + 15);
}
/// Acoustic announcer of any car.
constexpr NodeId announcer_of(unsigned car) {
  return car == 1 ? announcer_id : static_cast<NodeId>(10 * car + 19);
}

/// A physical device of the bus.
struct DevicePlace {
  NodeId id = 0;          ///< 1 to 127
  std::string_view name;  ///< in files and logs
  unsigned car = 1;       ///< 1 to 4
};
/// In the order of their node-IDs, and so in that of the cars.
inline constexpr std::array<DevicePlace, 29> device_places = {{
    {computer_id, "on-board-computer"},
    {identification_id, "identification"},
    {front_display_id, "destination-front"},
    {next_stop_id, "next-stop"},
    {canceller_id, "ticket-canceller"},
    {printer_id, "ticket-printer"},
    {information_id, "information"},
    {announcer_id, "announcer"},
    {side_display_id, "destination-side"},
    {vehicle_gateway_id, "vehicle-gateway"},
    {tachograph_id, "tachograph"},
    {driver_display_id, "driver-display"},
    {positioning_id, "positioning-time"},
    {first_counter_id, "counter-1"},
    {counting_manager_id, "counting-manager"},
    {second_counter_id, "counter-2"},
    {train_gateway_id, "train-gateway"},
    {gateway_of(2), "second-gateway", 2},
    {destination_of(2), "second-destination", 2},
    {next_stop_of(2), "second-next-stop", 2},
    {announcer_of(2), "second-announcer", 2},
    {gateway_of(3), "third-gateway", 3},
    {destination_of(3), "third-destination", 3},
    {next_stop_of(3), "third-next-stop", 3},
    {announcer_of(3), "third-announcer", 3},
    {gateway_of(4), "fourth-gateway", 4},
    {destination_of(4), "fourth-destination", 4},
    {next_stop_of(4), "fourth-next-stop", 4},
    {announcer_of(4), "fourth-announcer", 4},
}};
/// Cars with devices in device_places for a bus of so many: that of one car has those of a second
/// one, without power.
constexpr unsigned cars_made(unsigned cars) {
  return std::max(2U, cars);
}
/// The devices of a bus of so many cars; see cars_made().
constexpr std::span<const DevicePlace> places_of(unsigned cars) {
  const auto end = std::ranges::find_if(
      device_places, [cars](const DevicePlace& place) { return place.car > cars_made(cars); });
  return {device_places.begin(), end};
}
static_assert(places_of(2).size() == 21 && places_of(4).size() == device_places.size());
/// Car of each device by its usual node-ID; 1 for a node-ID that is none of them.
inline constexpr auto cars_of_devices = [] {
  std::array<std::uint8_t, node_id_max + 1> cars{};
  cars.fill(1);
  for (const DevicePlace& place : device_places) {
    cars.at(place.id) = static_cast<std::uint8_t>(place.car);
  }
  return cars;
}();
/// Car of a device; 1 for a node-ID that is none of them. It is asked for at each step of a world.
constexpr unsigned car_of(NodeId id) {
  return id <= node_id_max ? cars_of_devices[id] : 1U;
}
/// Node-ID of the device that starts those of a car.
constexpr NodeId master_in(unsigned car) {
  return car == 1 ? computer_id : gateway_of(car);
}
/// Key of the device that was added as the `number`-th one, 0 the first: beyond all node-IDs.
constexpr DeviceKey added_key(std::size_t number) {
  return static_cast<DeviceKey>(node_id_max + 1 + number);
}
/// The virtual devices of one of them, as the catalogue names them:
/// `geographical-positioning+time-fixing`.
std::string device_name_of(NodeId id);
/// The virtual devices of a physical device.
std::span<const cia407::BusUnit* const> units_at(NodeId id);

}  // namespace canvoy::bus_line
