// CiA 419 version 1.0.1: battery chargers. Where the text contradicts itself, `errata` gives the
// number of the finding that decided.
//
//     constexpr auto my_charger = describe(
//         cia419::charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
//
//     if (charger[cia419::battery_status].is(Readiness::ready)) ...
//     charger[cia419::charger_state_of_charge] = 80;  // percent
#pragma once

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/battery_values.hpp"
#include "canvoy/profiles/model/handle.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/model/provisions.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia419 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

using canvoy::Readiness;

/// 1000h: the profile's number; the additional information is reserved (6.2.1).
inline constexpr std::uint32_t device_type = 419;
inline constexpr NamedValue profile_names[] = {{device_type, "CiA 419"}};
inline constexpr NamedValue reserved_names[] = {{0, "0", Meaning::padding},
                                                {1, 0xFFFF, "reserved", Meaning::reserved}};
inline constexpr FieldInfo device_type_fields[] = {
    field(0, 16, "Device profile number", profile_names),
    field(16, 16, "Additional information", reserved_names),
};

// Communication objects that a charger has beyond CiA 301, or with another category.

inline constexpr ObjectInfo error_register_object = cia301::error_register_with_reserve("6.2.2");
inline constexpr auto time_cob_id_object =
    cia301::refined(cia301::time_cob_id_object, Category::optional, "4.1");
/// The sentence names the function, not the object.
inline constexpr auto producer_heartbeat_object =
    cia301::refined(cia301::producer_heartbeat_object, Category::mandatory, "4.1");
inline constexpr auto error_behavior_object =
    cia301::refined(cia301::error_behavior_object, Category::optional, "5.2");

// Application objects (clause 7).

/// What a charger takes of a status, of which the upper bits are 0 (7.2.1).
inline constexpr ValueInfo accepted_readiness = {.limits = within(0, 1)};
/// What a charger takes of a temperature: its entry has a range, which is no minimum (7.2.3).
inline constexpr ValueInfo accepted_temperature = {.unit = battery_values::temperature.unit,
                                                   .scale = battery_values::temperature.scale,
                                                   .limits = within(-320, 680),
                                                   .names = battery_values::temperature.names};

inline constexpr auto battery_status_object =
    var_object(0x6000, "battery_status", "7.2.1", "Whether the battery can accept a charge.",
               entry(unsigned8, rw, by_default, 0, accepted_readiness, battery_values::readiness),
               {.errata = "26"});
inline constexpr auto charger_status_object =
    var_object(0x6001, "charger_status", "7.2.2", "Whether the charger can deliver a charge.",
               entry(unsigned8, ro, by_default, {}, battery_values::readiness), {.errata = "26"});
inline constexpr auto battery_temperature_object = var_object(
    0x6010, "battery_temperature", "7.2.3",
    "Temperature of the battery pack, measured on the battery module.",
    entry(integer16, rw, by_default, 0xFFFF, accepted_temperature), {.errata = "1, 2, 25"});
inline constexpr auto ah_returned_during_last_charge_object =
    var_object(0x6052, "ah_returned_during_last_charge", "7.2.4",
               "Charge delivered to the battery: counts during a charge, and is kept after it.",
               entry(unsigned16, ro, by_default, {}, battery_values::ampere_hours),
               {.condition = "if TPDO2 or TPDO3 is supported", .errata = "4, 15, 16"});
inline constexpr auto battery_voltage_object = var_object(
    0x6060, "battery_voltage", "7.2.5", "Present voltage across the terminals of the battery.",
    entry(unsigned32, rw, by_default, 0xFFFF'FFFF, battery_values::voltage),
    {.condition = "if RPDO2 is supported"});
inline constexpr auto charge_current_requested_object =
    var_object(0x6070, "charge_current_requested", "7.2.6",
               "The current that the battery wants from the charger.",
               entry(unsigned16, rw, by_default, 0xFFFF, battery_values::current),
               {.condition = "if RPDO3 is supported"});
inline constexpr auto charger_state_of_charge_object =
    var_object(0x6080, "charger_state_of_charge", "7.2.7",
               "How full the battery is, as the charger estimates it.",
               entry(unsigned8, ro, by_default, {}, battery_values::state_of_charge),
               {.condition = "if TPDO3 is supported", .errata = "5, 20"});
inline constexpr auto battery_state_of_charge_object =
    var_object(0x6081, "battery_state_of_charge", "7.2.8",
               "How full the battery is, as it measures it itself.",
               entry(unsigned8, rw, by_default, 0xFF, battery_values::state_of_charge),
               {.condition = "if RPDO3 is supported", .errata = "14, 17"});

// PDOs (6.2.3 to 6.2.8). All are invalid until the charger has found its battery. The reading that
// the three of a direction have the same parameters is that of errata 3 and 6 to 13.

inline constexpr EntryInfo rpdo_parameter_entries[] = {
    sub_index(0, "highest sub-index supported", entry(unsigned8, ro, no, highest_sub()),
              {.errata = "13"}),
    sub_index(1, "COB-ID", entry(unsigned32, rw, no, cia301::invalid_cob_id, cia301::code)),
    sub_index(2, "transmission type", entry(unsigned8, ro, no, 255, cia301::transmission_types)),
    sub_index(5, "event timer", entry(unsigned16, rw, no, 0, cia301::milliseconds),
              {.category = Category::optional}),
};
inline constexpr EntryInfo tpdo_parameter_entries[] = {
    sub_index(0, "highest sub-index supported", entry(unsigned8, ro, no, highest_sub(5)),
              {.errata = "3"}),
    sub_index(1, "COB-ID", entry(unsigned32, rw, no, cia301::invalid_cob_id, cia301::code),
              {.errata = "10"}),
    sub_index(2, "transmission type", entry(unsigned8, ro, no, 255, cia301::transmission_types)),
    sub_index(3, "inhibit timer", entry(unsigned16, rw, no, 0, cia301::hundred_microseconds),
              {.category = Category::optional, .errata = "7, 8"}),
    sub_index(5, "event timer", entry(unsigned16, rw, no, 200, cia301::milliseconds),
              {.errata = "9"}),
};

/// Sub-index 00h of a mapping: rw, as printed for most of them.
constexpr EntryInfo mapped_objects(std::uint8_t count) {
  return sub_index(0, "highest sub-index supported", entry(unsigned8, rw, no, count),
                   {.errata = "6, 11, 21"});
}
inline constexpr EntryInfo rpdo1_mapping_entries[] = {mapped_objects(2),
                                                      mapping_entry(1, battery_temperature_object),
                                                      mapping_entry(2, battery_status_object)};
inline constexpr EntryInfo rpdo2_mapping_entries[] = {
    mapped_objects(3), mapping_entry(1, battery_temperature_object),
    mapping_entry(2, battery_status_object), mapping_entry(3, battery_voltage_object)};
inline constexpr EntryInfo rpdo3_mapping_entries[] = {
    mapped_objects(2), mapping_entry(1, charge_current_requested_object),
    mapping_entry(2, battery_state_of_charge_object)};
inline constexpr EntryInfo tpdo1_mapping_entries[] = {mapped_objects(1),
                                                      mapping_entry(1, charger_status_object)};
inline constexpr EntryInfo tpdo2_mapping_entries[] = {
    mapped_objects(2), mapping_entry(1, charger_status_object),
    mapping_entry(2, ah_returned_during_last_charge_object)};
inline constexpr EntryInfo tpdo3_mapping_entries[] = {
    mapped_objects(3), mapping_entry(1, charger_status_object),
    mapping_entry(2, ah_returned_during_last_charge_object),
    mapping_entry(3, charger_state_of_charge_object)};

inline constexpr auto rpdo1_parameter_object =
    record_object(0x1400, "RPDO parameter", "6.2.3.2", "Status and temperature of the battery.",
                  rpdo_parameter_entries);
inline constexpr auto rpdo2_parameter_object =
    record_object(0x1401, "RPDO parameter", "6.2.5.2",
                  "The first RPDO and the voltage of the battery: used in its place.",
                  rpdo_parameter_entries, {.category = Category::optional});
inline constexpr auto rpdo3_parameter_object = record_object(
    0x1402, "RPDO parameter", "6.2.7.2", "Requested current and state of charge of the battery.",
    rpdo_parameter_entries, {.category = Category::optional, .errata = "17"});
inline constexpr auto rpdo1_mapping_object =
    record_object(0x1600, "RPDO mapping", "6.2.3.3", "", rpdo1_mapping_entries);
inline constexpr auto rpdo2_mapping_object =
    record_object(0x1601, "RPDO mapping", "6.2.5.3", "", rpdo2_mapping_entries,
                  {.condition = "if RPDO2 is supported", .errata = "12"});
inline constexpr auto rpdo3_mapping_object = record_object(
    0x1602, "RPDO mapping", "6.2.7.3", "", rpdo3_mapping_entries, {.category = Category::optional});
inline constexpr auto tpdo1_parameter_object = record_object(
    0x1800, "TPDO parameter", "6.2.4.2", "Status of the charger.", tpdo_parameter_entries);
inline constexpr auto tpdo2_parameter_object =
    record_object(0x1801, "TPDO parameter", "6.2.6.2", "Status of the charger and charge returned.",
                  tpdo_parameter_entries, {.category = Category::optional});
inline constexpr auto tpdo3_parameter_object =
    record_object(0x1802, "TPDO parameter", "6.2.8.2",
                  "Status of the charger, charge returned and estimated state of charge.",
                  tpdo_parameter_entries, {.category = Category::optional, .errata = "18"});
inline constexpr auto tpdo1_mapping_object =
    record_object(0x1A00, "TPDO mapping", "6.2.4.3", "", tpdo1_mapping_entries);
inline constexpr auto tpdo2_mapping_object =
    record_object(0x1A01, "TPDO mapping", "6.2.6.3", "", tpdo2_mapping_entries,
                  {.category = Category::optional, .errata = "19"});
inline constexpr auto tpdo3_mapping_object =
    record_object(0x1A02, "TPDO mapping", "6.2.8.3", "", tpdo3_mapping_entries,
                  {.category = Category::optional, .errata = "20"});

inline constexpr auto objects = objects_of(
    error_register_object, time_cob_id_object, producer_heartbeat_object, error_behavior_object,
    rpdo1_parameter_object, rpdo2_parameter_object, rpdo3_parameter_object, rpdo1_mapping_object,
    rpdo2_mapping_object, rpdo3_mapping_object, tpdo1_parameter_object, tpdo2_parameter_object,
    tpdo3_parameter_object, tpdo1_mapping_object, tpdo2_mapping_object, tpdo3_mapping_object,
    battery_status_object, charger_status_object, battery_temperature_object,
    ah_returned_during_last_charge_object, battery_voltage_object, charge_current_requested_object,
    charger_state_of_charge_object, battery_state_of_charge_object);
inline constexpr BitRateProvision bit_rates[] = {{125, Category::mandatory, "4.2.2"}};
inline constexpr FailureProvision failures[] = {
    {bus_off_failure, "5.2"},
    {heartbeat_failure, "5.2"},
    {"an internal failure of the device, such as a missing pilot signal", "5.2"},
};
inline constexpr Provisions provisions = {.bit_rates = bit_rates, .failures = failures};

inline constexpr Profile profile = {.number = 419,
                                    .name = "CiA 419",
                                    .title = "Device profile for battery chargers",
                                    .objects = objects,
                                    .device_type = device_type_fields,
                                    .provisions = &provisions};

/// Optional PDOs of a charger, beyond the mandatory first RPDO and TPDO.
struct ChargerOptions {
  bool rpdo2 = false;  ///< from the battery
  bool rpdo3 = false;  ///< from the battery
  bool tpdo2 = false;  ///< to the battery
  bool tpdo3 = false;  ///< to the battery
};
/// The objects of a charger: device type, error register, PDOs and the objects that they map. The
/// maker adds identity and heartbeat producer.
constexpr auto charger(const ChargerOptions& options = {}) {
  DeviceDescription<24> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  parts.add(cia301::device_type(device_type));
  parts.add(error_register_object);
  parts.add_pdo(rpdo1_parameter_object, fixed_mapping(rpdo1_mapping_object));
  if (options.rpdo2) parts.add_pdo(rpdo2_parameter_object, fixed_mapping(rpdo2_mapping_object));
  if (options.rpdo3) parts.add_pdo(rpdo3_parameter_object, fixed_mapping(rpdo3_mapping_object));
  parts.add_pdo(tpdo1_parameter_object, fixed_mapping(tpdo1_mapping_object));
  if (options.tpdo2) parts.add_pdo(tpdo2_parameter_object, fixed_mapping(tpdo2_mapping_object));
  if (options.tpdo3) parts.add_pdo(tpdo3_parameter_object, fixed_mapping(tpdo3_mapping_object));
  parts.add_mapped(profile);
  return parts;
}

// For application code.

inline constexpr State<Readiness, battery_status_object, "", "readiness"> battery_status;
inline constexpr State<Readiness, charger_status_object, "", "readiness"> charger_status;
inline constexpr Quantity<battery_temperature_object> battery_temperature;
inline constexpr Quantity<ah_returned_during_last_charge_object> ah_returned_during_last_charge;
inline constexpr Quantity<battery_voltage_object> battery_voltage;
inline constexpr Quantity<charge_current_requested_object> charge_current_requested;
inline constexpr Quantity<charger_state_of_charge_object> charger_state_of_charge;
inline constexpr Quantity<battery_state_of_charge_object> battery_state_of_charge;

}  // namespace canvoy::cia419
