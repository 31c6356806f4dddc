// The physical devices of a bus: their node-IDs, names and cars, and the virtual devices of each.
//
//     for (const DevicePlace& place : device_places) units_at(place.id) ...
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/devices/cia407/kit/bus_kind.hpp"

namespace canvoy::bus_line {

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
// Devices in the second car, which has a segment of its own: its node-IDs do not occur in the
// first.
inline constexpr NodeId second_gateway_id = 31;      ///< gateway to the train bus; NMT master there
inline constexpr NodeId second_destination_id = 34;  ///< destination
inline constexpr NodeId second_next_stop_id = 35;    ///< next stop, with the sign
inline constexpr NodeId second_announcer_id = 39;    ///< acoustic announcer

/// A physical device of the bus.
struct DevicePlace {
  NodeId id = 0;          ///< 1 to 127
  std::string_view name;  ///< in files and logs
  unsigned car = 1;       ///< 1 or 2
};
/// In the order of their node-IDs.
inline constexpr std::array<DevicePlace, 21> device_places = {{
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
    {second_gateway_id, "second-gateway", 2},
    {second_destination_id, "second-destination", 2},
    {second_next_stop_id, "second-next-stop", 2},
    {second_announcer_id, "second-announcer", 2},
}};
/// Car of a device; 1 for a node-ID that is none of them.
constexpr unsigned car_of(NodeId id) {
  const auto place = std::ranges::find(device_places, id, &DevicePlace::id);
  return place == device_places.end() ? 1 : place->car;
}
/// The virtual devices of one of them, as the catalogue names them:
/// `geographical-positioning+time-fixing`.
std::string device_name_of(NodeId id);
/// The virtual devices of a physical device.
std::span<const cia407::BusUnit* const> units_at(NodeId id);
/// Node-ID of the device that starts this one; its own, where it starts the others.
constexpr NodeId master_of(NodeId id) {
  return car_of(id) == 1 ? computer_id : second_gateway_id;
}

}  // namespace canvoy::bus_line
