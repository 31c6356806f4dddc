// CiA 419 version 1.0.1: battery chargers. Where the text contradicts itself, `errata` is the
// number of the finding that decided.
//
//     constexpr auto my_charger = describe(
//         cia419::charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
//         cia301::identity({.vendor_id = 0x123}), cia301::heartbeat_producer(1000));
//
//     if (charger[cia419::battery_status].is(Readiness::ready)) ...
//     charger[cia419::charger_state_of_charge] = 80;  // percent
#pragma once

#include "canvoy/profiles/battery_values.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/handle.hpp"
#include "canvoy/profiles/mapping_value.hpp"
#include "canvoy/profiles/provisions.hpp"

namespace canvoy::cia419 {

using canvoy::Readiness;

/// 1000h (6.2.1): the profile's number; the additional information is reserved.
inline constexpr std::uint32_t device_type = 419;
inline constexpr NamedValue profile_names[] = {{device_type, "CiA 419"}};
inline constexpr NamedValue reserved_names[] = {{0, "0", Meaning::padding},
                                                {1, 0xFFFF, "reserved", Meaning::reserved}};
inline constexpr FieldInfo device_type_fields[] = {
    {.bits = 16, .name = "Device profile number", .value = {.names = profile_names}},
    {.first_bit = 16,
     .bits = 16,
     .name = "Additional information",
     .value = {.names = reserved_names}},
};

// Communication objects that a charger has beyond CiA 301, or with another category.

inline constexpr ObjectInfo error_register_object = cia301::error_register_with_reserve("6.2.2");
inline constexpr ObjectInfo time_cob_id_object =
    cia301::refined(cia301::time_cob_id_object, Category::optional, "4.1");
/// The sentence names the function, not the object.
inline constexpr ObjectInfo producer_heartbeat_object =
    cia301::refined(cia301::producer_heartbeat_object, Category::mandatory, "4.1");
inline constexpr ObjectInfo error_behavior_object =
    cia301::refined(cia301::error_behavior_object, Category::optional, "5.2");

// Application objects (clause 7).

inline constexpr ObjectInfo battery_status_object = {
    .index = 0x6000,
    .name = "battery_status",
    .clause = "7.2.1",
    .errata = "26",
    .description = "Whether the battery can accept a charge.",
    .entry = {.type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0,
              .fields = battery_values::readiness}};
inline constexpr ObjectInfo charger_status_object = {
    .index = 0x6001,
    .name = "charger_status",
    .clause = "7.2.2",
    .errata = "26",
    .description = "Whether the charger can deliver a charge.",
    .entry = {.type = DataType::unsigned8,
              .mapping = Mapping::by_default,
              .fields = battery_values::readiness}};
inline constexpr ObjectInfo battery_temperature_object = {
    .index = 0x6010,
    .name = "battery_temperature",
    .clause = "7.2.3",
    .errata = "1, 2, 25",
    .description = "Temperature of the battery pack, measured on the battery module.",
    .entry = {.type = DataType::integer16,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0xFFFF,
              .value = battery_values::temperature}};
inline constexpr ObjectInfo ah_returned_during_last_charge_object = {
    .index = 0x6052,
    .name = "ah_returned_during_last_charge",
    .category = Category::conditional,
    .condition = "if TPDO2 or TPDO3 is supported",
    .clause = "7.2.4",
    .errata = "4, 15, 16",
    .description = "Charge delivered to the battery: counts during a charge, and is kept after it.",
    .entry = {.type = DataType::unsigned16,
              .mapping = Mapping::by_default,
              .value = battery_values::ampere_hours}};
inline constexpr ObjectInfo battery_voltage_object = {
    .index = 0x6060,
    .name = "battery_voltage",
    .category = Category::conditional,
    .condition = "if RPDO2 is supported",
    .clause = "7.2.5",
    .description = "Present voltage across the terminals of the battery.",
    .entry = {.type = DataType::unsigned32,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0xFFFF'FFFF,
              .value = battery_values::voltage}};
inline constexpr ObjectInfo charge_current_requested_object = {
    .index = 0x6070,
    .name = "charge_current_requested",
    .category = Category::conditional,
    .condition = "if RPDO3 is supported",
    .clause = "7.2.6",
    .description = "The current that the battery wants from the charger.",
    .entry = {.type = DataType::unsigned16,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0xFFFF,
              .value = battery_values::current}};
inline constexpr ObjectInfo charger_state_of_charge_object = {
    .index = 0x6080,
    .name = "charger_state_of_charge",
    .category = Category::conditional,
    .condition = "if TPDO3 is supported",
    .clause = "7.2.7",
    .errata = "5, 20",
    .description = "How full the battery is, as the charger estimates it.",
    .entry = {.type = DataType::unsigned8,
              .mapping = Mapping::by_default,
              .value = battery_values::state_of_charge}};
inline constexpr ObjectInfo battery_state_of_charge_object = {
    .index = 0x6081,
    .name = "battery_state_of_charge",
    .category = Category::conditional,
    .condition = "if RPDO3 is supported",
    .clause = "7.2.8",
    .errata = "14, 17",
    .description = "How full the battery is, as it measures it itself.",
    .entry = {.type = DataType::unsigned8,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .initial = 0xFF,
              .value = battery_values::state_of_charge}};

// PDOs (6.2.3 to 6.2.8). They are all invalid until the charger has found its battery; that the
// three of a direction have the same parameters is the reading of errata 3 and 6 to 13.

inline constexpr EntryInfo rpdo_parameter_entries[] = {
    {.name = "highest sub-index supported", .initial = highest_sub(), .errata = "13"},
    {.sub_first = 1,
     .name = "COB-ID",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = cia301::invalid_cob_id,
     .value = cia301::code},
    {.sub_first = 2,
     .name = "transmission type",
     .initial = 255,
     .value = {.names = cia301::transmission_types}},
    {.sub_first = 5,
     .name = "event timer",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .category = Category::optional,
     .initial = 0,
     .value = cia301::milliseconds},
};
inline constexpr EntryInfo tpdo_parameter_entries[] = {
    {.name = "highest sub-index supported", .initial = highest_sub(5), .errata = "3"},
    {.sub_first = 1,
     .name = "COB-ID",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = cia301::invalid_cob_id,
     .value = cia301::code,
     .errata = "10"},
    {.sub_first = 2,
     .name = "transmission type",
     .initial = 255,
     .value = {.names = cia301::transmission_types}},
    {.sub_first = 3,
     .name = "inhibit timer",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .category = Category::optional,
     .initial = 0,
     .value = cia301::hundred_microseconds,
     .errata = "7, 8"},
    {.sub_first = 5,
     .name = "event timer",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .initial = 200,
     .value = cia301::milliseconds,
     .errata = "9"},
};

/// Sub-index 00h of a mapping: rw, as most of them are printed.
constexpr EntryInfo mapped_objects(std::uint8_t count) {
  return {.name = "highest sub-index supported",
          .access = Access::rw,
          .initial = count,
          .errata = "6, 11, 21"};
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

inline constexpr ObjectInfo rpdo1_parameter_object = {.index = 0x1400,
                                                      .code = ObjectCode::record,
                                                      .name = "RPDO parameter",
                                                      .clause = "6.2.3.2",
                                                      .description =
                                                          "Status and temperature of "
                                                          "the battery.",
                                                      .subs = rpdo_parameter_entries};
inline constexpr ObjectInfo rpdo2_parameter_object = {
    .index = 0x1401,
    .code = ObjectCode::record,
    .name = "RPDO parameter",
    .category = Category::optional,
    .clause = "6.2.5.2",
    .description = "The first RPDO and the voltage of the battery: used in its place.",
    .subs = rpdo_parameter_entries};
inline constexpr ObjectInfo rpdo3_parameter_object = {
    .index = 0x1402,
    .code = ObjectCode::record,
    .name = "RPDO parameter",
    .category = Category::optional,
    .clause = "6.2.7.2",
    .errata = "17",
    .description = "Requested current and state of charge of the battery.",
    .subs = rpdo_parameter_entries};
inline constexpr ObjectInfo rpdo1_mapping_object = {.index = 0x1600,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .clause = "6.2.3.3",
                                                    .subs = rpdo1_mapping_entries};
inline constexpr ObjectInfo rpdo2_mapping_object = {.index = 0x1601,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .category = Category::conditional,
                                                    .condition = "if RPDO2 is supported",
                                                    .clause = "6.2.5.3",
                                                    .errata = "12",
                                                    .subs = rpdo2_mapping_entries};
inline constexpr ObjectInfo rpdo3_mapping_object = {.index = 0x1602,
                                                    .code = ObjectCode::record,
                                                    .name = "RPDO mapping",
                                                    .category = Category::optional,
                                                    .clause = "6.2.7.3",
                                                    .subs = rpdo3_mapping_entries};
inline constexpr ObjectInfo tpdo1_parameter_object = {.index = 0x1800,
                                                      .code = ObjectCode::record,
                                                      .name = "TPDO parameter",
                                                      .clause = "6.2.4.2",
                                                      .description = "Status of the charger.",
                                                      .subs = tpdo_parameter_entries};
inline constexpr ObjectInfo tpdo2_parameter_object = {
    .index = 0x1801,
    .code = ObjectCode::record,
    .name = "TPDO parameter",
    .category = Category::optional,
    .clause = "6.2.6.2",
    .description = "Status of the charger and charge returned.",
    .subs = tpdo_parameter_entries};
inline constexpr ObjectInfo tpdo3_parameter_object = {
    .index = 0x1802,
    .code = ObjectCode::record,
    .name = "TPDO parameter",
    .category = Category::optional,
    .clause = "6.2.8.2",
    .errata = "18",
    .description = "Status of the charger, charge returned and estimated state of charge.",
    .subs = tpdo_parameter_entries};
inline constexpr ObjectInfo tpdo1_mapping_object = {.index = 0x1A00,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .clause = "6.2.4.3",
                                                    .subs = tpdo1_mapping_entries};
inline constexpr ObjectInfo tpdo2_mapping_object = {.index = 0x1A01,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .category = Category::optional,
                                                    .clause = "6.2.6.3",
                                                    .errata = "19",
                                                    .subs = tpdo2_mapping_entries};
inline constexpr ObjectInfo tpdo3_mapping_object = {.index = 0x1A02,
                                                    .code = ObjectCode::record,
                                                    .name = "TPDO mapping",
                                                    .category = Category::optional,
                                                    .clause = "6.2.8.3",
                                                    .errata = "20",
                                                    .subs = tpdo3_mapping_entries};

inline constexpr const ObjectInfo* objects[] = {
    &error_register_object,          &time_cob_id_object,
    &producer_heartbeat_object,      &error_behavior_object,
    &rpdo1_parameter_object,         &rpdo2_parameter_object,
    &rpdo3_parameter_object,         &rpdo1_mapping_object,
    &rpdo2_mapping_object,           &rpdo3_mapping_object,
    &tpdo1_parameter_object,         &tpdo2_parameter_object,
    &tpdo3_parameter_object,         &tpdo1_mapping_object,
    &tpdo2_mapping_object,           &tpdo3_mapping_object,
    &battery_status_object,          &charger_status_object,
    &battery_temperature_object,     &ah_returned_during_last_charge_object,
    &battery_voltage_object,         &charge_current_requested_object,
    &charger_state_of_charge_object, &battery_state_of_charge_object,
};
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

/// What a charger has beyond the mandatory first RPDO and TPDO.
struct ChargerOptions {
  bool rpdo2 = false;
  bool rpdo3 = false;
  bool tpdo2 = false;
  bool tpdo3 = false;
};
/// The objects of a charger: device type, error register, PDOs and what they map. Its maker adds
/// identity and heartbeat producer.
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

// What application code uses.

inline constexpr State<Readiness, battery_status_object, "", "readiness"> battery_status;
inline constexpr State<Readiness, charger_status_object, "", "readiness"> charger_status;
inline constexpr Quantity<battery_temperature_object> battery_temperature;
inline constexpr Quantity<ah_returned_during_last_charge_object> ah_returned_during_last_charge;
inline constexpr Quantity<battery_voltage_object> battery_voltage;
inline constexpr Quantity<charge_current_requested_object> charge_current_requested;
inline constexpr Quantity<charger_state_of_charge_object> charger_state_of_charge;
inline constexpr Quantity<battery_state_of_charge_object> battery_state_of_charge;

}  // namespace canvoy::cia419
