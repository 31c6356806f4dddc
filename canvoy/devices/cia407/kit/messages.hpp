// PDOs that the units here add to the pre-defined ones (8.1.5, application-specific configuration),
// with the mapping of sender and receiver. TPDOs are on 180h, 280h ... + node-ID. The configuration
// of the network sets their CAN-IDs in the receivers. Only the stop request has a fixed CAN-ID, in
// all data sheets.
//
//     static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<door_count_tpdo>};
#pragma once

#include "canvoy/devices/cia407/kit/bus_device.hpp"

namespace canvoy::cia407 {

/// A TPDO with this content.
constexpr PdoInfo sends(const Items<std::uint32_t>& mapping, std::string_view name) {
  return {.mapping = mapping, .name = name, .clause = "8.1.5"};
}
/// An RPDO with this content.
constexpr PdoInfo receives(const Items<std::uint32_t>& mapping, std::string_view name) {
  return {.direction = PdoInfo::Direction::receive,
          .mapping = mapping,
          .name = name,
          .clause = "8.1.5"};
}

/// A PDO with a CAN-ID that needs no configuration by the network.
constexpr PdoInfo on(std::uint32_t cob_id, PdoInfo pdo) {
  pdo.cob_id = cob_id;
  return pdo;
}

// Events.

/// Flags and information of one device.
inline constexpr std::uint32_t event_mapping[] = {mapped(events_from_virtual_devices_object, 1),
                                                  mapped(events_from_virtual_devices_object, 2)};
/// The sub-indices that are not zero, and the events of the first virtual device.
inline constexpr PdoInfo event_tpdo = sends(event_mapping, "events");
/// Flags for one device.
inline constexpr std::uint32_t command_mapping[] = {mapped(events_for_virtual_devices_object, 1)};
/// Events for the first virtual device.
inline constexpr PdoInfo command_rpdo = receives(command_mapping, "commands");
/// Of every virtual device that sends events and is commanded by them (6002h).
inline constexpr std::array event_pdos = {own_pdo<event_tpdo>, own_pdo<command_rpdo>};

// The vehicle.

/// And state of doors 1 to 8.
inline constexpr std::uint32_t motion_mapping[] = {
    mapped(wheel_based_vehicle_speed_object), mapped(drive_flag_and_direction_flag_object),
    mapped(state_of_doors_object, 1), mapped(state_of_doors_object, 2)};
inline constexpr PdoInfo motion_tpdo = sends(motion_mapping, "speed, direction, doors");
inline constexpr PdoInfo motion_rpdo = receives(motion_mapping, "speed, direction, doors");
/// Of doors 1 to 8.
inline constexpr std::uint32_t doors_only_mapping[] = {
    dummy_16, dummy_8, mapped(state_of_doors_object, 1), mapped(state_of_doors_object, 2)};
inline constexpr PdoInfo doors_rpdo = receives(doors_only_mapping, "doors");
/// And temperature of the air outside.
inline constexpr std::uint32_t mileage_mapping[] = {mapped(vehicle_mileage_object),
                                                    mapped(ambient_air_temperature_object)};
inline constexpr PdoInfo mileage_tpdo = sends(mileage_mapping, "mileage, temperature");
inline constexpr PdoInfo mileage_rpdo = receives(mileage_mapping, "mileage, temperature");
/// Of the tachograph.
inline constexpr std::uint32_t tachograph_mapping[] = {
    mapped(tachograph_speed_object), mapped(drive_recognition_and_direction_indication_object)};
inline constexpr PdoInfo tachograph_tpdo = sends(tachograph_mapping, "tachograph speed");
/// Of the tachograph.
inline constexpr std::uint32_t tachograph_distance_mapping[] = {
    mapped(high_resolution_vehicle_distance_object, 1),
    mapped(high_resolution_vehicle_distance_object, 2)};
inline constexpr PdoInfo tachograph_distance_tpdo =
    sends(tachograph_distance_mapping, "tachograph distance");

// Position and time.

inline constexpr auto position_mapping = all_of<2>(position_object);  ///< both coordinates
inline constexpr PdoInfo position_tpdo = sends(position_mapping, "position");
inline constexpr PdoInfo position_rpdo = receives(position_mapping, "position");
/// By satellites.
inline constexpr std::uint32_t movement_mapping[] = {mapped(gps_based_speed_object),
                                                     mapped(gps_mileage_object)};
inline constexpr PdoInfo movement_tpdo = sends(movement_mapping, "movement by GPS");
inline constexpr PdoInfo movement_rpdo = receives(movement_mapping, "movement by GPS");
/// UTC, date and time.
inline constexpr auto universal_time_mapping = all_of<8>(time_universal_reference_object);
inline constexpr PdoInfo universal_time_tpdo = sends(universal_time_mapping, "universal time");
inline constexpr PdoInfo universal_time_rpdo = receives(universal_time_mapping, "universal time");

// Passengers.

/// At one door, since it opened.
inline constexpr std::uint32_t door_count_mapping[] = {
    mapped(passenger_counting_in_and_out_per_door_object)};
inline constexpr PdoInfo door_count_tpdo = sends(door_count_mapping, "count of a door");
inline constexpr PdoInfo door_count_rpdo = receives(door_count_mapping, "count of a door");
/// Number and share.
inline constexpr std::uint32_t aboard_mapping[] = {mapped(counter_passenger_sum_object),
                                                   mapped(passenger_capacity_usage_object)};
inline constexpr PdoInfo aboard_tpdo = sends(aboard_mapping, "passengers aboard");
inline constexpr PdoInfo aboard_rpdo = receives(aboard_mapping, "passengers aboard");

// Diagnostics, keys, inputs and outputs.

/// 6740h, sub-index 00h.
inline constexpr std::uint32_t error_count_mapping[] = {
    mapped(short_diagnostic_error_field_object, 0)};
inline constexpr PdoInfo error_count_tpdo = sends(error_count_mapping, "number of errors");
inline constexpr std::uint32_t inputs_mapping[] = {mapped(digital_input_object)};  ///< 32 bits
inline constexpr PdoInfo inputs_tpdo = sends(inputs_mapping, "digital inputs");
/// The first two channels.
inline constexpr auto analogue_inputs_mapping = all_of<2>(analogue_input_object);
inline constexpr PdoInfo analogue_inputs_tpdo = sends(analogue_inputs_mapping, "analogue inputs");
inline constexpr std::uint32_t outputs_mapping[] = {mapped(digital_output_object)};  ///< 32 bits
inline constexpr PdoInfo outputs_rpdo = receives(outputs_mapping, "digital outputs");
/// The first two channels.
inline constexpr auto analogue_outputs_mapping = all_of<2>(analogue_output_object);
inline constexpr PdoInfo analogue_outputs_rpdo =
    receives(analogue_outputs_mapping, "analogue outputs");

/// For the main on-board computer: the events of the n-th virtual device of the network, which is
/// the first one of its own device (see event_tpdo).
template <unsigned number>
inline constexpr std::uint32_t events_of_mapping[] = {
    dummy_32, mapped(events_from_virtual_devices_object, number + 1)};
template <unsigned number>
inline constexpr PdoInfo events_of_rpdo = receives(events_of_mapping<number>, "events of a device");
/// And the events for that virtual device.
template <unsigned number>
inline constexpr std::uint32_t events_to_mapping[] = {
    mapped(events_for_virtual_devices_object, number)};
template <unsigned number>
inline constexpr PdoInfo events_to_tpdo = sends(events_to_mapping<number>, "events for a device");
/// For a display: the update and the first mapped object, to call up a text by its number (5.2).
inline constexpr std::uint32_t call_mapping[] = {mapped(display_mapping_object, 1),
                                                 mapped(display_mapping_object, 2)};
inline constexpr PdoInfo call_rpdo = receives(call_mapping, "call of a text");
/// 6204h has a separate message (8.1.5). Its sender, the main on-board computer, has no free CAN-ID
/// in the pre-defined connection set (8.1.4.3 uses all those of node 1 and further ones). The
/// message has the CAN-ID of the first TPDO of node 65, which is in the data sheets of all senders
/// and receivers. A network with a node 65 assigns another one.
inline constexpr std::uint32_t stop_request_cob_id = 0x1C1;
/// One bit.
inline constexpr std::uint32_t stop_request_mapping[] = {mapped(bus_stop_request_object)};
inline constexpr PdoInfo stop_request_tpdo =
    on(stop_request_cob_id, sends(stop_request_mapping, "bus stop request"));
inline constexpr PdoInfo stop_request_rpdo =
    on(stop_request_cob_id, receives(stop_request_mapping, "bus stop request"));

}  // namespace canvoy::cia407
