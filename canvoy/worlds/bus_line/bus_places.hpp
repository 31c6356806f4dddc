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

inline constexpr NodeId computer_id = 1;
inline constexpr NodeId identification_id = 2;
inline constexpr NodeId front_display_id = 4;
inline constexpr NodeId next_stop_id = 5;
inline constexpr NodeId canceller_id = 6;
inline constexpr NodeId printer_id = 7;
inline constexpr NodeId information_id = 8;
inline constexpr NodeId announcer_id = 9;
inline constexpr NodeId side_display_id = 10;
inline constexpr NodeId vehicle_gateway_id = 11;
inline constexpr NodeId tachograph_id = 12;
inline constexpr NodeId driver_display_id = 13;
inline constexpr NodeId positioning_id = 16;
inline constexpr NodeId first_counter_id = 20;
inline constexpr NodeId counting_manager_id = 21;
inline constexpr NodeId second_counter_id = 22;
inline constexpr NodeId train_gateway_id = 30;
// Devices in the second car, which has a segment of its own: its node-IDs do not occur in the
// first.
inline constexpr NodeId second_gateway_id = 31;
inline constexpr NodeId second_destination_id = 34;
inline constexpr NodeId second_next_stop_id = 35;
inline constexpr NodeId second_announcer_id = 39;

/// A physical device of the bus.
struct DevicePlace {
  NodeId id = 0;
  std::string_view name;
  unsigned car = 1;
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
