// The eight pre-defined messages of CiA 407 for its minimum and its typical configuration
// (8.1.4.3). Their table has lost its header: the columns are those of 8.1.4.2, and the mappings
// belong to the messages by their order (errata 93, 94, 102).
//
// In a receiver that does not have the object, a dummy entry is mapped (errata 97, 98).
//
//     cia407::pdos[0].cob_id  // 181h: local time and date
#pragma once

#include "canvoy/profiles/cia407/events.hpp"
#include "canvoy/profiles/cia407/main_on_board_computer.hpp"
#include "canvoy/profiles/cia407/passenger_information.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::cia407 {

/// Value of a mapping entry; does not compile where the object has no such entry.
constexpr std::uint32_t mapped(const ObjectInfo& object, unsigned sub = 0) {
  const EntryInfo* entry = find_entry(object, sub);
  if (entry == nullptr) detail::description_is_wrong("the mapped entry is not there");
  return MappingValue(object.index, sub, bit_length(entry->type)).raw();
}
/// Value of a mapping entry for a gap as wide as that type.
constexpr std::uint32_t dummy(DataType type) {
  return MappingValue(static_cast<unsigned>(type), 0, bit_length(type)).raw();
}
/// `count` entries from sub-index 01h on.
template <std::size_t count>
constexpr std::array<std::uint32_t, count> all_of(const ObjectInfo& object) {
  std::array<std::uint32_t, count> values{};
  for (unsigned i = 0; i < count; ++i) values[i] = mapped(object, i + 1);
  return values;
}
inline constexpr std::uint32_t dummy_8 = dummy(DataType::unsigned8);
inline constexpr std::uint32_t dummy_16 = dummy(DataType::unsigned16);
inline constexpr std::uint32_t dummy_32 = dummy(DataType::unsigned32);

inline constexpr auto time_mapping = all_of<6>(local_time_and_date_object);
inline constexpr std::uint32_t route_mapping[] = {
    mapped(route_segment_number_object), mapped(fare_zone_object),
    mapped(blocking_of_ticket_canceller_object), mapped(journey_direction_object),
    mapped(number_of_running_in_route_representation_object)};
/// A destination indicator has the route segment alone.
inline constexpr std::uint32_t route_segment_mapping[] = {mapped(route_segment_number_object),
                                                          dummy_8, dummy_8, dummy_8, dummy_8};
/// 6001h is what the main on-board computer receives, not what it sends: open (errata 96).
inline constexpr std::uint32_t stop_point_mapping[] = {
    mapped(stop_point_id_object), mapped(events_from_virtual_devices_object, 1)};
inline constexpr std::uint32_t stop_point_only_mapping[] = {mapped(stop_point_id_object), dummy_32};
inline constexpr auto line_mapping = all_of<8>(line_short_representation_object);
inline constexpr auto stop_point_name_mapping = all_of<8>(stop_point_short_representation_object);
inline constexpr std::uint32_t driver_mapping[] = {mapped(driver_id_object)};
inline constexpr std::uint32_t block_mapping[] = {mapped(block_id_object), mapped(line_id_object),
                                                  mapped(journey_number_object)};
inline constexpr std::uint32_t block_and_line_mapping[] = {mapped(block_id_object),
                                                           mapped(line_id_object), dummy_16};
inline constexpr std::uint32_t line_only_mapping[] = {dummy_32, mapped(line_id_object), dummy_16};
inline constexpr std::uint32_t destination_mapping[] = {mapped(destination_number_object),
                                                        mapped(route_number_object)};

/// One of the eight messages.
struct PdoMessage {
  std::uint16_t cob_id;            ///< pre-defined, with the node-ID of its sender
  std::string_view name;           ///< what it carries
  std::string_view configuration;  ///< configuration of the network that has it (8.1.4.3)
  std::string_view errata;         ///< findings that concern it
};
inline constexpr std::string_view minimum_configuration = "minimum and typical configuration";
inline constexpr std::string_view typical_configuration = "typical configuration";
inline constexpr PdoMessage time_message = {0x181, "local time and date", minimum_configuration,
                                            "93, 101"};
inline constexpr PdoMessage route_message = {0x381, "route", typical_configuration, "93, 97"};
inline constexpr PdoMessage stop_point_message = {0x401, "stop point", typical_configuration,
                                                  "93, 96, 99"};
inline constexpr PdoMessage line_message = {0x481, "line", typical_configuration, "93, 94, 100"};
inline constexpr PdoMessage stop_point_name_message = {0x501, "stop point representation",
                                                       typical_configuration, "93, 94, 103"};
inline constexpr PdoMessage driver_message = {0x201, "driver", minimum_configuration, "93, 94"};
inline constexpr PdoMessage block_message = {0x281, "block, line and journey",
                                             minimum_configuration, "93, 94, 95, 98, 102"};
inline constexpr PdoMessage destination_message = {0x301, "destination and route",
                                                   typical_configuration, "93, 94"};

inline constexpr std::uint8_t main_computer_code[] = {code_of(DeviceCode::main_on_board_computer)};
inline constexpr std::uint8_t identification_code[] = {code_of(DeviceCode::identification)};
inline constexpr std::uint8_t display_code[] = {code_of(DeviceCode::passenger_information)};
inline constexpr std::uint8_t printer_code[] = {code_of(DeviceCode::ticket_printer)};
inline constexpr std::uint8_t canceller_and_printer_codes[] = {
    code_of(DeviceCode::ticket_canceller), code_of(DeviceCode::ticket_printer)};

/// All PDOs have transmission type 255, and no timer except for the time.
constexpr PdoInfo pdo(PdoInfo::Direction direction, std::uint16_t number, const PdoMessage& message,
                      const Items<std::uint32_t>& mapping, const Items<std::uint8_t>& devices) {
  return {.direction = direction,
          .number = number,
          .cob_id = message.cob_id,
          .mapping = mapping,
          .name = message.name,
          .devices = devices,
          .condition = message.configuration,
          .clause = "8.1.4.3",
          .errata = message.errata};
}
/// See pdo().
constexpr PdoInfo tpdo(std::uint16_t number, const PdoMessage& message,
                       const Items<std::uint32_t>& mapping, const Items<std::uint8_t>& devices) {
  return pdo(PdoInfo::Direction::transmit, number, message, mapping, devices);
}
/// See pdo().
constexpr PdoInfo rpdo(std::uint16_t number, const PdoMessage& message,
                       const Items<std::uint32_t>& mapping, const Items<std::uint8_t>& devices) {
  return pdo(PdoInfo::Direction::receive, number, message, mapping, devices);
}
/// An RPDO of passenger information of one class, subclass "text".
constexpr PdoInfo display_rpdo(std::uint16_t number, const PdoMessage& message,
                               const Items<std::uint32_t>& mapping, std::string_view condition) {
  PdoInfo made = rpdo(number, message, mapping, display_code);
  made.condition = condition;
  return made;
}
inline constexpr std::string_view minimum_destination =
    "minimum and typical configuration: destination indicator (class 1), text";
inline constexpr std::string_view typical_destination =
    "typical configuration: destination indicator (class 1), text";
inline constexpr std::string_view typical_next_stop =
    "typical configuration: next stop indicator (class 2), text";

/// The time has an event timer of one minute.
constexpr PdoInfo time_tpdo() {
  PdoInfo made = tpdo(1, time_message, time_mapping, main_computer_code);
  made.event_timer = 60'000;
  return made;
}
inline constexpr PdoInfo pdos[] = {
    // Main on-board computer
    rpdo(1, destination_message, destination_mapping, main_computer_code),
    rpdo(2, driver_message, driver_mapping, main_computer_code),
    rpdo(3, block_message, block_mapping, main_computer_code),
    time_tpdo(),
    tpdo(2, route_message, route_mapping, main_computer_code),
    tpdo(3, stop_point_message, stop_point_mapping, main_computer_code),
    tpdo(4, line_message, line_mapping, main_computer_code),
    tpdo(5, stop_point_name_message, stop_point_name_mapping, main_computer_code),
    // Identification
    tpdo(1, driver_message, driver_mapping, identification_code),
    tpdo(2, block_message, block_mapping, identification_code),
    tpdo(3, destination_message, destination_mapping, identification_code),
    // Passenger information
    display_rpdo(1, destination_message, destination_mapping, typical_destination),
    display_rpdo(2, route_message, route_segment_mapping, typical_destination),
    display_rpdo(3, block_message, line_only_mapping, minimum_destination),
    display_rpdo(4, stop_point_message, stop_point_only_mapping, typical_next_stop),
    // Ticket canceller, ticket printer
    rpdo(1, time_message, time_mapping, canceller_and_printer_codes),
    rpdo(2, route_message, route_mapping, canceller_and_printer_codes),
    rpdo(3, block_message, block_and_line_mapping, canceller_and_printer_codes),
    rpdo(4, stop_point_message, stop_point_only_mapping, printer_code),
    rpdo(5, line_message, line_mapping, printer_code),
    rpdo(6, stop_point_name_message, stop_point_name_mapping, printer_code),
};

}  // namespace canvoy::cia407
