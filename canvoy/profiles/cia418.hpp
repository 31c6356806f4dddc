// CiA 418: battery modules, the partners of CiA 419 chargers.
//
// The text of CiA 418 is not at hand: this is what public sources agree upon (indices, types,
// access) and what CiA 419 mirrors (units, sentinels, PDO contents). Uncertain are the default
// COB-ID of the third RPDO, which PDOs are valid at start, their event timers, and the mapping of
// the third RPDO: a device that knows better changes them with initial(), for example
//
//     constexpr auto my_battery = describe(
//         cia418::battery({.rpdo2 = true, .tpdo2 = true})
//             .initial(cia418::tpdo2_parameter_object, 1, plus_node_id(0x8000'0280)),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
//
//     battery[cia418::status] = Readiness::ready;
//     battery[cia418::temperature] = 21.5;  // degrees Celsius
#pragma once

#include "canvoy/profiles/battery_values.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/handle.hpp"
#include "canvoy/profiles/mapping_value.hpp"

namespace canvoy::cia418 {

using canvoy::Readiness;

/// 1000h: the profile's number, without additional information.
inline constexpr std::uint32_t device_type = 418;
inline constexpr NamedValue profile_names[] = {{device_type, "CiA 418"}};
inline constexpr FieldInfo device_type_fields[] = {
    {.bits = 16, .name = "Device profile number", .value = {.names = profile_names}},
    {.first_bit = 16, .bits = 16, .name = "Additional information"},
};

/// Battery modules have a heartbeat (public description of the profile), never guarding alone.
inline constexpr ObjectInfo producer_heartbeat_object =
    cia301::refined(cia301::producer_heartbeat_object, Category::mandatory, {});

inline constexpr ObjectInfo battery_status_object = {
    .index = 0x6000,
    .name = "battery_status",
    .description = "Whether the battery can accept a charge.",
    .entry = {.type = DataType::unsigned8,
              .mapping = Mapping::by_default,
              .fields = battery_values::readiness}};
inline constexpr ObjectInfo charger_status_object = {
    .index = 0x6001,
    .name = "charger_status",
    .description = "Whether the charger can deliver a charge.",
    .entry = {.type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0,
              .fields = battery_values::readiness}};
inline constexpr ObjectInfo temperature_object = {
    .index = 0x6010,
    .name = "temperature",
    .description = "Temperature of the battery pack, measured on the battery module.",
    .entry = {.type = DataType::integer16,
              .mapping = Mapping::by_default,
              .value = battery_values::temperature}};

inline constexpr EntryInfo parameter_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .name = "battery_type",
     .value = {.notation = Notation::hexadecimal},
     .description = "A code, of which the list is not public."},
    {.sub_first = 2,
     .name = "ah_capacity",
     .type = DataType::unsigned16,
     .value = {.unit = Unit::ampere_hour}},
    {.sub_first = 3,
     .name = "maximum_charge_current",
     .type = DataType::unsigned16,
     .value = {.unit = Unit::ampere}},
    {.sub_first = 4, .name = "number_of_cells", .type = DataType::unsigned16},
};
inline constexpr ObjectInfo parameters_object = {.index = 0x6020,
                                                 .code = ObjectCode::record,
                                                 .name = "battery_parameters",
                                                 .subs = parameter_entries};

/// Characters, four in a number, the first in its lowest byte.
constexpr EntryInfo packed_characters(std::uint8_t numbers) {
  return {.sub_first = 1,
          .sub_last = numbers,
          .name = "characters",
          .type = DataType::unsigned32,
          .initial = 0,
          .value = {.notation = Notation::characters}};
}
inline constexpr EntryInfo serial_number_entries[] = {cia301::highest_sub_index,
                                                      packed_characters(3)};
inline constexpr EntryInfo id_entries[] = {cia301::highest_sub_index, packed_characters(5)};
inline constexpr ObjectInfo battery_serial_number_object = {.index = 0x6030,
                                                            .code = ObjectCode::array,
                                                            .name = "battery_serial_number",
                                                            .category = Category::optional,
                                                            .subs = serial_number_entries};
inline constexpr ObjectInfo battery_id_object = {.index = 0x6031,
                                                 .code = ObjectCode::array,
                                                 .name = "battery_id",
                                                 .category = Category::optional,
                                                 .subs = id_entries};
inline constexpr ObjectInfo vehicle_serial_number_object = {.index = 0x6040,
                                                            .code = ObjectCode::array,
                                                            .name = "vehicle_serial_number",
                                                            .category = Category::optional,
                                                            .subs = id_entries};
inline constexpr ObjectInfo vehicle_id_object = {.index = 0x6041,
                                                 .code = ObjectCode::array,
                                                 .name = "vehicle_id",
                                                 .category = Category::optional,
                                                 .subs = id_entries};

inline constexpr ObjectInfo cumulative_total_ah_charge_object = {
    .index = 0x6050,
    .name = "cumulative_total_ah_charge",
    .category = Category::optional,
    .description = "All that was ever charged into the battery.",
    .entry = {.type = DataType::unsigned32, .value = {.unit = Unit::ampere_hour}}};
inline constexpr ObjectInfo ah_expended_since_last_charge_object = {
    .index = 0x6051,
    .name = "ah_expended_since_last_charge",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned16, .value = battery_values::ampere_hours}};
inline constexpr ObjectInfo ah_returned_during_last_charge_object = {
    .index = 0x6052,
    .name = "ah_returned_during_last_charge",
    .category = Category::optional,
    .description =
        "The charger reads it before a charge, and writes it at the end (CiA 419, 7.2.4).",
    .entry = {.type = DataType::unsigned16,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .value = battery_values::ampere_hours}};
inline constexpr ObjectInfo ah_since_last_equalization_object = {
    .index = 0x6053,
    .name = "ah_since_last_equalization",
    .category = Category::optional,
    .entry = {
        .type = DataType::unsigned16, .access = Access::rw, .value = battery_values::ampere_hours}};

inline constexpr EntryInfo equalization_date_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .name = "minutes",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .initial = 0,
     .value = {.unit = Unit::minute}},
    {.sub_first = 2,
     .name = "days",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .initial = 0,
     .value = {.unit = Unit::day}},
};
inline constexpr ObjectInfo date_of_last_equalization_object = {.index = 0x6054,
                                                                .code = ObjectCode::array,
                                                                .name = "date_of_last_equalization",
                                                                .category = Category::optional,
                                                                .subs = equalization_date_entries};

inline constexpr ObjectInfo voltage_object = {
    .index = 0x6060,
    .name = "battery_voltage",
    .category = Category::optional,
    .description = "Present voltage across the terminals of the battery.",
    .entry = {.type = DataType::unsigned32,
              .mapping = Mapping::by_default,
              .value = battery_values::voltage}};
inline constexpr ObjectInfo charge_current_requested_object = {
    .index = 0x6070,
    .name = "charge_current_requested",
    .category = Category::optional,
    .description = "The current that the battery wants from the charger.",
    .entry = {.type = DataType::unsigned16,
              .mapping = Mapping::by_default,
              .value = battery_values::current}};
inline constexpr ObjectInfo charger_state_of_charge_object = {
    .index = 0x6080,
    .name = "charger_state_of_charge",
    .category = Category::optional,
    .description = "How full the battery is, as the charger estimates it.",
    .entry = {.type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0xFF,
              .value = battery_values::state_of_charge}};
inline constexpr ObjectInfo battery_state_of_charge_object = {
    .index = 0x6081,
    .name = "battery_state_of_charge",
    .category = Category::optional,
    .description = "How full the battery is, as it measures it itself.",
    .entry = {.type = DataType::unsigned8,
              .mapping = Mapping::by_default,
              .value = battery_values::state_of_charge}};
inline constexpr ObjectInfo water_level_status_object = {
    .index = 0x6090,
    .name = "water_level_status",
    .category = Category::optional,
    .entry = {.type = DataType::unsigned8, .initial = 0}};

// PDOs: what a charger receives, the battery transmits, and the other way round.

inline constexpr std::uint32_t rpdo1_can_id = 0x200;  ///< plus the node-ID, as all of these
inline constexpr std::uint32_t rpdo2_can_id = 0x300;
inline constexpr std::uint32_t rpdo3_can_id = 0x400;
inline constexpr std::uint32_t tpdo1_can_id = 0x180;
inline constexpr std::uint32_t tpdo2_can_id = 0x280;
inline constexpr std::uint32_t tpdo3_can_id = 0x380;

constexpr EntryInfo cob_id_entry(std::uint32_t can_id) {
  EntryInfo entry = cia301::pdo_cob_id_entry;
  entry.initial = plus_node_id(can_id);
  return entry;
}
/// The period of all TPDOs, as chargers have it (CiA 419, 6.2.4.2).
constexpr EntryInfo tpdo_event_timer_entry() {
  EntryInfo entry = cia301::event_timer_entry;
  entry.category = Category::mandatory;
  entry.initial = 200;
  return entry;
}

inline constexpr EntryInfo rpdo1_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(rpdo1_can_id), cia301::transmission_type_entry,
    cia301::event_timer_entry};
inline constexpr EntryInfo rpdo2_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(rpdo2_can_id), cia301::transmission_type_entry,
    cia301::event_timer_entry};
inline constexpr EntryInfo rpdo3_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(rpdo3_can_id), cia301::transmission_type_entry,
    cia301::event_timer_entry};
inline constexpr EntryInfo tpdo1_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(tpdo1_can_id), cia301::transmission_type_entry,
    cia301::inhibit_time_entry, tpdo_event_timer_entry()};
inline constexpr EntryInfo tpdo2_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(tpdo2_can_id), cia301::transmission_type_entry,
    cia301::inhibit_time_entry, tpdo_event_timer_entry()};
inline constexpr EntryInfo tpdo3_parameter_entries[] = {
    cia301::highest_sub_index, cob_id_entry(tpdo3_can_id), cia301::transmission_type_entry,
    cia301::inhibit_time_entry, tpdo_event_timer_entry()};

constexpr EntryInfo mapped_objects(std::uint8_t count) {
  EntryInfo entry = cia301::mapping_number_entry;
  entry.initial = count;
  return entry;
}
inline constexpr EntryInfo rpdo1_mapping_entries[] = {mapped_objects(1),
                                                      mapping_entry(1, charger_status_object)};
inline constexpr EntryInfo rpdo2_mapping_entries[] = {
    mapped_objects(2), mapping_entry(1, charger_status_object),
    mapping_entry(2, ah_returned_during_last_charge_object)};
inline constexpr EntryInfo rpdo3_mapping_entries[] = {
    mapped_objects(3), mapping_entry(1, charger_status_object),
    mapping_entry(2, ah_returned_during_last_charge_object),
    mapping_entry(3, charger_state_of_charge_object)};
inline constexpr EntryInfo tpdo1_mapping_entries[] = {mapped_objects(2),
                                                      mapping_entry(1, temperature_object),
                                                      mapping_entry(2, battery_status_object)};
inline constexpr EntryInfo tpdo2_mapping_entries[] = {
    mapped_objects(3), mapping_entry(1, temperature_object),
    mapping_entry(2, battery_status_object), mapping_entry(3, voltage_object)};
inline constexpr EntryInfo tpdo3_mapping_entries[] = {
    mapped_objects(2), mapping_entry(1, charge_current_requested_object),
    mapping_entry(2, battery_state_of_charge_object)};

inline constexpr ObjectInfo rpdo1_parameter_object = {.index = 0x1400,
                                                      .code = ObjectCode::record,
                                                      .name = "RPDO parameter",
                                                      .description = "Status of the charger.",
                                                      .subs = rpdo1_parameter_entries};
inline constexpr ObjectInfo rpdo2_parameter_object = {
    .index = 0x1401,
    .code = ObjectCode::record,
    .name = "RPDO parameter",
    .category = Category::optional,
    .description = "Status of the charger and charge returned.",
    .subs = rpdo2_parameter_entries};
inline constexpr ObjectInfo rpdo3_parameter_object = {
    .index = 0x1402,
    .code = ObjectCode::record,
    .name = "RPDO parameter",
    .category = Category::optional,
    .description = "Status of the charger, charge returned and estimated state of charge.",
    .subs = rpdo3_parameter_entries};
inline constexpr ObjectInfo rpdo1_mapping_object = {.index = 0x1600,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .subs = rpdo1_mapping_entries};
inline constexpr ObjectInfo rpdo2_mapping_object = {.index = 0x1601,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .category = Category::optional,
                                                    .subs = rpdo2_mapping_entries};
inline constexpr ObjectInfo rpdo3_mapping_object = {.index = 0x1602,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .category = Category::optional,
                                                    .subs = rpdo3_mapping_entries};
inline constexpr ObjectInfo tpdo1_parameter_object = {
    .index = 0x1800,
    .code = ObjectCode::record,
    .name = "TPDO parameter",
    .description = "Temperature and status of the battery.",
    .subs = tpdo1_parameter_entries};
inline constexpr ObjectInfo tpdo2_parameter_object = {
    .index = 0x1801,
    .code = ObjectCode::record,
    .name = "TPDO parameter",
    .category = Category::optional,
    .description = "The first TPDO and the voltage of the battery.",
    .subs = tpdo2_parameter_entries};
inline constexpr ObjectInfo tpdo3_parameter_object = {
    .index = 0x1802,
    .code = ObjectCode::record,
    .name = "TPDO parameter",
    .category = Category::optional,
    .description = "Requested current and state of charge of the battery.",
    .subs = tpdo3_parameter_entries};
inline constexpr ObjectInfo tpdo1_mapping_object = {.index = 0x1A00,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .subs = tpdo1_mapping_entries};
inline constexpr ObjectInfo tpdo2_mapping_object = {.index = 0x1A01,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .category = Category::optional,
                                                    .subs = tpdo2_mapping_entries};
inline constexpr ObjectInfo tpdo3_mapping_object = {.index = 0x1A02,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .category = Category::optional,
                                                    .subs = tpdo3_mapping_entries};

inline constexpr const ObjectInfo* objects[] = {
    &producer_heartbeat_object,
    &rpdo1_parameter_object,
    &rpdo2_parameter_object,
    &rpdo3_parameter_object,
    &rpdo1_mapping_object,
    &rpdo2_mapping_object,
    &rpdo3_mapping_object,
    &tpdo1_parameter_object,
    &tpdo2_parameter_object,
    &tpdo3_parameter_object,
    &tpdo1_mapping_object,
    &tpdo2_mapping_object,
    &tpdo3_mapping_object,
    &battery_status_object,
    &charger_status_object,
    &temperature_object,
    &parameters_object,
    &battery_serial_number_object,
    &battery_id_object,
    &vehicle_serial_number_object,
    &vehicle_id_object,
    &cumulative_total_ah_charge_object,
    &ah_expended_since_last_charge_object,
    &ah_returned_during_last_charge_object,
    &ah_since_last_equalization_object,
    &date_of_last_equalization_object,
    &voltage_object,
    &charge_current_requested_object,
    &charger_state_of_charge_object,
    &battery_state_of_charge_object,
    &water_level_status_object,
};
/// Of several batteries behind one node-ID, each has its objects 800h above those of the last.
inline constexpr Profile profile = {.number = 418,
                                    .name = "CiA 418",
                                    .title = "Device profile for battery modules",
                                    .objects = objects,
                                    .block_count = 8,
                                    .device_type = device_type_fields};

/// What a battery module has beyond the mandatory objects.
struct BatteryOptions {
  bool rpdo2 = false;
  bool rpdo3 = false;
  bool tpdo2 = false;
  bool tpdo3 = false;
};
/// The objects of a battery module: device type, error register, PDOs and what they map, and its
/// parameters. Others of this file are added one by one; its maker adds identity and heartbeat
/// producer.
constexpr auto battery(const BatteryOptions& options = {}) {
  DeviceDescription<24> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type));
  parts.add(cia301::error_register_object);
  parts.add_pdo(rpdo1_parameter_object, fixed_mapping(rpdo1_mapping_object));
  if (options.rpdo2) parts.add_pdo(rpdo2_parameter_object, fixed_mapping(rpdo2_mapping_object));
  if (options.rpdo3) parts.add_pdo(rpdo3_parameter_object, fixed_mapping(rpdo3_mapping_object));
  parts.add_pdo(tpdo1_parameter_object, fixed_mapping(tpdo1_mapping_object));
  if (options.tpdo2) parts.add_pdo(tpdo2_parameter_object, fixed_mapping(tpdo2_mapping_object));
  if (options.tpdo3) parts.add_pdo(tpdo3_parameter_object, fixed_mapping(tpdo3_mapping_object));
  parts.add(parameters_object);
  parts.add_mapped(profile);
  return parts;
}

// What application code uses.

inline constexpr State<Readiness, battery_status_object, "", "readiness"> status;
inline constexpr State<Readiness, charger_status_object, "", "readiness"> charger_status;
inline constexpr Quantity<temperature_object> temperature;
inline constexpr Number<parameters_object, "battery_type"> battery_type;
inline constexpr Quantity<parameters_object, "ah_capacity"> capacity;
inline constexpr Quantity<parameters_object, "maximum_charge_current"> maximum_charge_current;
inline constexpr Number<parameters_object, "number_of_cells"> number_of_cells;
inline constexpr PackedText<battery_serial_number_object> battery_serial_number;
inline constexpr PackedText<battery_id_object> battery_id;
inline constexpr PackedText<vehicle_serial_number_object> vehicle_serial_number;
inline constexpr PackedText<vehicle_id_object> vehicle_id;
inline constexpr Quantity<cumulative_total_ah_charge_object> cumulative_total_ah_charge;
inline constexpr Quantity<ah_expended_since_last_charge_object> ah_expended_since_last_charge;
inline constexpr Quantity<ah_returned_during_last_charge_object> ah_returned_during_last_charge;
inline constexpr Quantity<ah_since_last_equalization_object> ah_since_last_equalization;
inline constexpr Quantity<date_of_last_equalization_object, "minutes"> equalization_minutes;
inline constexpr Quantity<date_of_last_equalization_object, "days"> equalization_days;
inline constexpr Quantity<voltage_object> voltage;
inline constexpr Quantity<charge_current_requested_object> charge_current_requested;
inline constexpr Quantity<charger_state_of_charge_object> charger_state_of_charge;
inline constexpr Quantity<battery_state_of_charge_object> battery_state_of_charge;
inline constexpr Number<water_level_status_object> water_level_status;

}  // namespace canvoy::cia418
