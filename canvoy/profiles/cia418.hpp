// CiA 418: battery modules, the partners of CiA 419 chargers.
//
// The text of CiA 418 is not at hand. This description is what public sources agree upon (indices,
// types, access) and what CiA 419 mirrors (units, sentinels, PDO contents). Uncertain are the
// default COB-ID of the third RPDO, which PDOs are valid at start, their event timers, and the
// mapping of the third RPDO. A device with other values changes them with initial(), for example
//
//     constexpr auto my_battery = describe(
//         cia418::battery({.rpdo2 = true, .tpdo2 = true})
//             .initial(cia418::tpdo2_parameter_object, 1, plus_node_id(0x8000'0280)),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
//
//     battery[cia418::status] = Readiness::ready;
//     battery[cia418::temperature] = 21.5;  // degrees Celsius
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/battery_values.hpp"
#include "canvoy/profiles/model/handle.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia418 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

using canvoy::Readiness;

/// 1000h: the profile's number, without additional information.
inline constexpr std::uint32_t device_type = 418;
inline constexpr NamedValue profile_names[] = {{device_type, "CiA 418"}};
inline constexpr FieldInfo device_type_fields[] = {
    field(0, 16, "Device profile number", profile_names),
    field(16, 16, "Additional information"),
};

/// Battery modules have a heartbeat (public description of the profile), never node guarding alone.
inline constexpr auto producer_heartbeat_object =
    cia301::refined(cia301::producer_heartbeat_object, Category::mandatory, {});

inline constexpr auto battery_status_object =
    var_object(0x6000, "battery_status", "", "Whether the battery can accept a charge.",
               entry(unsigned8, ro, by_default, {}, battery_values::readiness));
inline constexpr auto charger_status_object =
    var_object(0x6001, "charger_status", "", "Whether the charger can deliver a charge.",
               entry(unsigned8, rw, by_default, 0, battery_values::readiness));
inline constexpr auto temperature_object = var_object(
    0x6010, "temperature", "", "Temperature of the battery pack, measured on the battery module.",
    entry(integer16, ro, by_default, {}, battery_values::temperature));

inline constexpr EntryInfo parameter_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, "battery_type", entry(unsigned8, ro, no, {}, {.notation = Notation::hexadecimal}),
              {.description = "A code, of which the list is not public."}),
    sub_index(2, "ah_capacity", entry(unsigned16, ro, no, {}, {.unit = Unit::ampere_hour})),
    sub_index(3, "maximum_charge_current", entry(unsigned16, ro, no, {}, {.unit = Unit::ampere})),
    sub_index(4, "number_of_cells", entry(unsigned16, ro)),
};
inline constexpr auto parameters_object =
    record_object(0x6020, "battery_parameters", "", "", parameter_entries);

/// Characters, four in a number, the first in its lowest byte.
constexpr EntryInfo packed_characters(std::uint8_t numbers) {
  return sub_index(1, numbers, "characters",
                   entry(unsigned32, ro, no, 0, {.notation = Notation::characters}));
}
inline constexpr EntryInfo serial_number_entries[] = {cia301::highest_sub_index,
                                                      packed_characters(3)};
inline constexpr EntryInfo id_entries[] = {cia301::highest_sub_index, packed_characters(5)};
inline constexpr auto battery_serial_number_object =
    array_object(0x6030, "battery_serial_number", "", "", serial_number_entries,
                 {.category = Category::optional});
inline constexpr auto battery_id_object =
    array_object(0x6031, "battery_id", "", "", id_entries, {.category = Category::optional});
inline constexpr auto vehicle_serial_number_object = array_object(
    0x6040, "vehicle_serial_number", "", "", id_entries, {.category = Category::optional});
inline constexpr auto vehicle_id_object =
    array_object(0x6041, "vehicle_id", "", "", id_entries, {.category = Category::optional});

inline constexpr auto cumulative_total_ah_charge_object = var_object(
    0x6050, "cumulative_total_ah_charge", "", "All that was ever charged into the battery.",
    entry(unsigned32, ro, no, {}, {.unit = Unit::ampere_hour}), {.category = Category::optional});
inline constexpr auto ah_expended_since_last_charge_object = var_object(
    0x6051, "ah_expended_since_last_charge", "", "",
    entry(unsigned16, ro, no, {}, battery_values::ampere_hours), {.category = Category::optional});
inline constexpr auto ah_returned_during_last_charge_object =
    var_object(0x6052, "ah_returned_during_last_charge", "",
               "The charger reads it before a charge, and writes it at the end (CiA 419, 7.2.4).",
               entry(unsigned16, rw, by_default, {}, battery_values::ampere_hours),
               {.category = Category::optional});
inline constexpr auto ah_since_last_equalization_object = var_object(
    0x6053, "ah_since_last_equalization", "", "",
    entry(unsigned16, rw, no, {}, battery_values::ampere_hours), {.category = Category::optional});

inline constexpr EntryInfo equalization_date_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, "minutes", entry(unsigned16, rw, no, 0, {.unit = Unit::minute})),
    sub_index(2, "days", entry(unsigned16, rw, no, 0, {.unit = Unit::day})),
};
inline constexpr auto date_of_last_equalization_object =
    array_object(0x6054, "date_of_last_equalization", "", "", equalization_date_entries,
                 {.category = Category::optional});

inline constexpr auto voltage_object = var_object(
    0x6060, "battery_voltage", "", "Present voltage across the terminals of the battery.",
    entry(unsigned32, ro, by_default, {}, battery_values::voltage),
    {.category = Category::optional});
inline constexpr auto charge_current_requested_object = var_object(
    0x6070, "charge_current_requested", "", "The current that the battery wants from the charger.",
    entry(unsigned16, ro, by_default, {}, battery_values::current),
    {.category = Category::optional});
inline constexpr auto charger_state_of_charge_object = var_object(
    0x6080, "charger_state_of_charge", "", "How full the battery is, as the charger estimates it.",
    entry(unsigned8, rw, by_default, 0xFF, battery_values::state_of_charge),
    {.category = Category::optional});
inline constexpr auto battery_state_of_charge_object = var_object(
    0x6081, "battery_state_of_charge", "", "How full the battery is, as it measures it itself.",
    entry(unsigned8, ro, by_default, {}, battery_values::state_of_charge),
    {.category = Category::optional});
inline constexpr auto water_level_status_object =
    var_object(0x6090, "water_level_status", "", "", entry(unsigned8, ro, no, 0),
               {.category = Category::optional});

// PDOs: what a charger receives, the battery transmits, and vice versa.

inline constexpr std::uint32_t rpdo1_can_id = 0x200;  ///< plus the node-ID, like all of these
inline constexpr std::uint32_t rpdo2_can_id = 0x300;
inline constexpr std::uint32_t rpdo3_can_id = 0x400;
inline constexpr std::uint32_t tpdo1_can_id = 0x180;
inline constexpr std::uint32_t tpdo2_can_id = 0x280;
inline constexpr std::uint32_t tpdo3_can_id = 0x380;

/// A COB-ID of the pre-defined connection set; the node-ID is added.
constexpr EntryInfo cob_id_entry(std::uint32_t can_id) {
  EntryInfo entry = cia301::pdo_cob_id_entry;
  entry.initial = plus_node_id(can_id);
  return entry;
}
/// The period of all TPDOs, as in chargers (CiA 419, 6.2.4.2).
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

/// Sub-index 00h of a mapping record.
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

inline constexpr auto rpdo1_parameter_object =
    record_object(0x1400, "RPDO parameter", "", "Status of the charger.", rpdo1_parameter_entries);
inline constexpr auto rpdo2_parameter_object =
    record_object(0x1401, "RPDO parameter", "", "Status of the charger and charge returned.",
                  rpdo2_parameter_entries, {.category = Category::optional});
inline constexpr auto rpdo3_parameter_object =
    record_object(0x1402, "RPDO parameter", "",
                  "Status of the charger, charge returned and estimated state of charge.",
                  rpdo3_parameter_entries, {.category = Category::optional});
inline constexpr auto rpdo1_mapping_object =
    record_object(0x1600, "RPDO mapping", "", "", rpdo1_mapping_entries);
inline constexpr auto rpdo2_mapping_object = record_object(
    0x1601, "RPDO mapping", "", "", rpdo2_mapping_entries, {.category = Category::optional});
inline constexpr auto rpdo3_mapping_object = record_object(
    0x1602, "RPDO mapping", "", "", rpdo3_mapping_entries, {.category = Category::optional});
inline constexpr auto tpdo1_parameter_object =
    record_object(0x1800, "TPDO parameter", "", "Temperature and status of the battery.",
                  tpdo1_parameter_entries);
inline constexpr auto tpdo2_parameter_object =
    record_object(0x1801, "TPDO parameter", "", "The first TPDO and the voltage of the battery.",
                  tpdo2_parameter_entries, {.category = Category::optional});
inline constexpr auto tpdo3_parameter_object = record_object(
    0x1802, "TPDO parameter", "", "Requested current and state of charge of the battery.",
    tpdo3_parameter_entries, {.category = Category::optional});
inline constexpr auto tpdo1_mapping_object =
    record_object(0x1A00, "TPDO mapping", "", "", tpdo1_mapping_entries);
inline constexpr auto tpdo2_mapping_object = record_object(
    0x1A01, "TPDO mapping", "", "", tpdo2_mapping_entries, {.category = Category::optional});
inline constexpr auto tpdo3_mapping_object = record_object(
    0x1A02, "TPDO mapping", "", "", tpdo3_mapping_entries, {.category = Category::optional});

inline constexpr auto objects = objects_of(
    producer_heartbeat_object, rpdo1_parameter_object, rpdo2_parameter_object,
    rpdo3_parameter_object, rpdo1_mapping_object, rpdo2_mapping_object, rpdo3_mapping_object,
    tpdo1_parameter_object, tpdo2_parameter_object, tpdo3_parameter_object, tpdo1_mapping_object,
    tpdo2_mapping_object, tpdo3_mapping_object, battery_status_object, charger_status_object,
    temperature_object, parameters_object, battery_serial_number_object, battery_id_object,
    vehicle_serial_number_object, vehicle_id_object, cumulative_total_ah_charge_object,
    ah_expended_since_last_charge_object, ah_returned_during_last_charge_object,
    ah_since_last_equalization_object, date_of_last_equalization_object, voltage_object,
    charge_current_requested_object, charger_state_of_charge_object, battery_state_of_charge_object,
    water_level_status_object);
/// With several batteries behind one node-ID, the objects of each are 800h above those of the one
/// before.
inline constexpr Profile profile = {.number = 418,
                                    .name = "CiA 418",
                                    .title = "Device profile for battery modules",
                                    .objects = objects,
                                    .block_count = 8,
                                    .device_type = device_type_fields};

/// Optional objects of a battery module.
struct BatteryOptions {
  bool rpdo2 = false;  ///< process data of the charger
  bool rpdo3 = false;  ///< process data of the charger
  bool tpdo2 = false;  ///< process data of the battery
  bool tpdo3 = false;  ///< process data of the battery
};
/// The objects of a battery module: device type, error register, PDOs and the objects that they
/// map, and its parameters. Other objects of this file are added one by one. The maker adds
/// identity and heartbeat producer.
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

// For application code.

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
