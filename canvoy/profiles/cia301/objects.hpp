// Descriptions of the communication objects 1000h to 1029h (CiA 301 version 4.2, 7.5.2.1 to
// 7.5.2.32). Those of SDO and PDO are in channels.hpp; devices pick them with the help of
// cia301.hpp.
//
//     cia301::producer_heartbeat_object.entry.value.unit  // Unit::millisecond
#pragma once

#include "canvoy/profiles/description.hpp"

namespace canvoy::cia301 {

/// Of arrays and records that have no sub-index 00h of their own kind.
inline constexpr EntryInfo highest_sub_index = {
    .name = "Highest sub-index supported", .access = Access::const_, .initial = highest_sub()};

inline constexpr ValueInfo code = {.notation = Notation::hexadecimal};
inline constexpr ValueInfo milliseconds = {.unit = Unit::millisecond};
inline constexpr ValueInfo microseconds = {.unit = Unit::microsecond};
inline constexpr ValueInfo hundred_microseconds = {.unit = Unit::microsecond,
                                                   .scale = {.numerator = 100}};

inline constexpr std::uint32_t invalid_cob_id = 0x8000'0000;

inline constexpr ObjectInfo device_type_object = {
    .index = 0x1000,
    .name = "Device type",
    .clause = "7.5.2.1",
    .description = "The device profile in the low word, and what that profile adds above it.",
    .entry = {.type = DataType::unsigned32, .initial = 0, .value = code}};

inline constexpr FieldInfo error_register_bits[] = {
    {.first_bit = 0, .name = "Generic error"},
    {.first_bit = 1, .name = "Current"},
    {.first_bit = 2, .name = "Voltage"},
    {.first_bit = 3, .name = "Temperature"},
    {.first_bit = 4, .name = "Communication error"},
    {.first_bit = 5, .name = "Device profile specific"},
    {.first_bit = 7, .name = "Manufacturer-specific"},
};
inline constexpr ObjectInfo error_register_object = {
    .index = 0x1001,
    .name = "Error register",
    .clause = "7.5.2.2",
    .description = "One bit for each kind of error that is present.",
    .entry = {.type = DataType::unsigned8,
              .mapping = Mapping::optional,
              .initial = 0,
              .value = {.notation = Notation::bit_mask},
              .fields = error_register_bits}};

/// Of profiles that keep bit 5 for later (CiA 419, 6.2.2; CiA 852, 11.3).
inline constexpr NamedValue reserved_bit_names[] = {{0, "0", Meaning::padding},
                                                    {1, "reserved", Meaning::reserved}};
inline constexpr auto error_register_bits_with_reserve = [] {
  std::array<FieldInfo, std::size(error_register_bits)> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) {
    bits[i] = error_register_bits[i];
    if (bits[i].first_bit != 5) continue;
    bits[i].name = "reserved";
    bits[i].value.names = reserved_bit_names;
  }
  return bits;
}();

/// An object of this standard as a profile has it, which gives it another category.
constexpr ObjectInfo refined(ObjectInfo object, Category category, std::string_view clause,
                             std::string_view errata = {}, std::string_view condition = {}) {
  object.category = category;
  object.condition = condition;
  object.clause = clause;
  object.errata = errata;
  return object;
}
constexpr ObjectInfo error_register_with_reserve(std::string_view clause) {
  ObjectInfo object = refined(error_register_object, Category::mandatory, clause);
  object.entry.fields = error_register_bits_with_reserve;
  return object;
}

inline constexpr ObjectInfo manufacturer_status_object = {
    .index = 0x1002,
    .name = "Manufacturer status register",
    .category = Category::optional,
    .clause = "7.5.2.3",
    .entry = {
        .type = DataType::unsigned32, .mapping = Mapping::optional, .initial = 0, .value = code}};

inline constexpr EntryInfo error_field_entries[] = {
    {.name = "Number of errors",
     .access = Access::rw,
     .initial = 0,
     .description = "Writing 0 forgets all errors; nothing else may be written."},
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Standard error field",
     .type = DataType::unsigned32,
     .initial = 0,
     .value = code,
     .description = "Error code in the low word; the newest error is the first."},
};
inline constexpr ObjectInfo error_field_object = {.index = 0x1003,
                                                  .code = ObjectCode::array,
                                                  .name = "Pre-defined error field",
                                                  .category = Category::optional,
                                                  .clause = "7.5.2.4",
                                                  .subs = error_field_entries};

inline constexpr ObjectInfo sync_cob_id_object = {
    .index = 0x1005,
    .name = "COB-ID SYNC message",
    .category = Category::optional,
    .clause = "7.5.2.5",
    .description = "Bit 30: this device produces SYNC.",
    .entry = {.type = DataType::unsigned32, .access = Access::rw, .initial = 0x80, .value = code}};
inline constexpr ObjectInfo sync_period_object = {
    .index = 0x1006,
    .name = "Communication cycle period",
    .category = Category::optional,
    .clause = "7.5.2.6",
    .entry = {
        .type = DataType::unsigned32, .access = Access::rw, .initial = 0, .value = microseconds}};
inline constexpr ObjectInfo sync_window_object = {
    .index = 0x1007,
    .name = "Synchronous window length",
    .category = Category::optional,
    .clause = "7.5.2.7",
    .entry = {
        .type = DataType::unsigned32, .access = Access::rw, .initial = 0, .value = microseconds}};

inline constexpr std::uint16_t name_capacity = 32;
inline constexpr EntryInfo name_entry = {.type = DataType::visible_string,
                                         .access = Access::const_,
                                         .capacity = name_capacity,
                                         .initial = ""};
inline constexpr ObjectInfo device_name_object = {.index = 0x1008,
                                                  .name = "Manufacturer device name",
                                                  .category = Category::optional,
                                                  .clause = "7.5.2.8",
                                                  .entry = name_entry};
inline constexpr ObjectInfo hardware_version_object = {.index = 0x1009,
                                                       .name = "Manufacturer hardware version",
                                                       .category = Category::optional,
                                                       .clause = "7.5.2.9",
                                                       .entry = name_entry};
inline constexpr ObjectInfo software_version_object = {.index = 0x100A,
                                                       .name = "Manufacturer software version",
                                                       .category = Category::optional,
                                                       .clause = "7.5.2.10",
                                                       .entry = name_entry};

inline constexpr ObjectInfo guard_time_object = {
    .index = 0x100C,
    .name = "Guard time",
    .category = Category::optional,
    .clause = "7.5.2.11",
    .entry = {
        .type = DataType::unsigned16, .access = Access::rw, .initial = 0, .value = milliseconds}};
inline constexpr ObjectInfo life_time_factor_object = {
    .index = 0x100D,
    .name = "Life time factor",
    .category = Category::optional,
    .clause = "7.5.2.12",
    .entry = {.type = DataType::unsigned8, .access = Access::rw, .initial = 0}};

/// What is written to have something done.
inline constexpr NamedValue save_signature[] = {{0x6576'6173, "save"}};
inline constexpr NamedValue load_signature[] = {{0x6461'6F6C, "load"}};

inline constexpr EntryInfo store_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Save parameters",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 1,
     .value = {.names = save_signature, .notation = Notation::hexadecimal},
     .description = "1 all, 2 communication, 3 application, 4 and above the manufacturer's."},
};
inline constexpr ObjectInfo store_object = {.index = 0x1010,
                                            .code = ObjectCode::array,
                                            .name = "Store parameters",
                                            .category = Category::optional,
                                            .clause = "7.5.2.13",
                                            .subs = store_entries};
inline constexpr EntryInfo restore_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Restore default parameters",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 1,
     .value = {.names = load_signature, .notation = Notation::hexadecimal},
     .description = "1 all, 2 communication, 3 application, 4 and above the manufacturer's."},
};
inline constexpr ObjectInfo restore_object = {.index = 0x1011,
                                              .code = ObjectCode::array,
                                              .name = "Restore default parameters",
                                              .category = Category::optional,
                                              .clause = "7.5.2.14",
                                              .subs = restore_entries};

inline constexpr ObjectInfo time_cob_id_object = {
    .index = 0x1012,
    .name = "COB-ID time stamp object",
    .category = Category::optional,
    .clause = "7.5.2.15",
    .description = "Bit 31: this device consumes TIME; bit 30: it produces it.",
    .entry = {.type = DataType::unsigned32, .access = Access::rw, .initial = 0x100, .value = code}};
inline constexpr ObjectInfo high_resolution_time_object = {.index = 0x1013,
                                                           .name = "High resolution time stamp",
                                                           .category = Category::optional,
                                                           .clause = "7.5.2.16",
                                                           .entry = {.type = DataType::unsigned32,
                                                                     .access = Access::rw,
                                                                     .mapping = Mapping::optional,
                                                                     .initial = 0,
                                                                     .value = microseconds}};

inline constexpr ObjectInfo emergency_cob_id_object = {
    .index = 0x1014,
    .name = "COB-ID emergency object",
    .category = Category::conditional,
    .condition = "if emergency is supported",
    .clause = "7.5.2.17",
    .description = "Bit 31: the device sends no emergency messages.",
    .entry = {.type = DataType::unsigned32,
              .access = Access::rw,
              .initial = plus_node_id(0x80),
              .value = code}};
inline constexpr ObjectInfo emergency_inhibit_object = {.index = 0x1015,
                                                        .name = "Inhibit time EMCY",
                                                        .category = Category::optional,
                                                        .clause = "7.5.2.18",
                                                        .entry = {.type = DataType::unsigned16,
                                                                  .access = Access::rw,
                                                                  .initial = 0,
                                                                  .value = hundred_microseconds}};

inline constexpr FieldInfo consumer_heartbeat_fields[] = {
    {.first_bit = 0, .bits = 16, .name = "Heartbeat time", .value = milliseconds},
    {.first_bit = 16, .bits = 8, .name = "Node-ID"},
};
inline constexpr EntryInfo consumer_heartbeat_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Consumer heartbeat time",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = code,
     .fields = consumer_heartbeat_fields},
};
inline constexpr ObjectInfo consumer_heartbeat_object = {.index = 0x1016,
                                                         .code = ObjectCode::array,
                                                         .name = "Consumer heartbeat time",
                                                         .category = Category::optional,
                                                         .clause = "7.5.2.19",
                                                         .subs = consumer_heartbeat_entries};
inline constexpr ObjectInfo producer_heartbeat_object = {
    .index = 0x1017,
    .name = "Producer heartbeat time",
    .category = Category::conditional,
    .condition = "if guarding is not supported",
    .clause = "7.5.2.20",
    .description = "0: no heartbeat.",
    .entry = {
        .type = DataType::unsigned16, .access = Access::rw, .initial = 0, .value = milliseconds}};

inline constexpr EntryInfo identity_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .name = "Vendor-ID",
     .type = DataType::unsigned32,
     .initial = 0,
     .value = code},
    {.sub_first = 2,
     .name = "Product code",
     .type = DataType::unsigned32,
     .category = Category::optional,
     .initial = 0,
     .value = code},
    {.sub_first = 3,
     .name = "Revision number",
     .type = DataType::unsigned32,
     .category = Category::optional,
     .initial = 0,
     .value = code},
    {.sub_first = 4,
     .name = "Serial number",
     .type = DataType::unsigned32,
     .category = Category::optional,
     .initial = 0,
     .value = code},
};
inline constexpr ObjectInfo identity_object = {.index = 0x1018,
                                               .code = ObjectCode::record,
                                               .name = "Identity object",
                                               .clause = "7.5.2.21",
                                               .subs = identity_entries};

inline constexpr ObjectInfo sync_overflow_object = {
    .index = 0x1019,
    .name = "Synchronous counter overflow value",
    .category = Category::optional,
    .clause = "7.5.2.22",
    .description = "0: SYNC without a counter; 2 to 240: the last number that it counts to.",
    .entry = {.type = DataType::unsigned8, .access = Access::rw, .initial = 0}};

/// A date and a time as 1020h and 1F52h have them, in sub-indices 1 and 2.
constexpr EntryInfo date_entry(std::string_view name) {
  return {.sub_first = 1,
          .name = name,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 0,
          .value = {.unit = Unit::day},
          .description = "Days since 1 January 1984."};
}
constexpr EntryInfo time_entry(std::string_view name) {
  return {.sub_first = 2,
          .name = name,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 0,
          .value = milliseconds,
          .description = "Since midnight."};
}
inline constexpr EntryInfo verify_configuration_entries[] = {
    highest_sub_index, date_entry("Configuration date"), time_entry("Configuration time")};
inline constexpr ObjectInfo verify_configuration_object = {.index = 0x1020,
                                                           .code = ObjectCode::array,
                                                           .name = "Verify configuration",
                                                           .category = Category::optional,
                                                           .clause = "7.5.2.23",
                                                           .subs = verify_configuration_entries};

inline constexpr ObjectInfo store_eds_object = {.index = 0x1021,
                                                .code = ObjectCode::domain,
                                                .name = "Store EDS",
                                                .category = Category::optional,
                                                .clause = "7.5.2.24",
                                                .entry = {.type = DataType::domain}};
inline constexpr NamedValue eds_formats[] = {{0, "ISO 10646, not compressed"}};
inline constexpr ObjectInfo store_format_object = {
    .index = 0x1022,
    .name = "Store format",
    .category = Category::conditional,
    .condition = "if 1021h is supported",
    .clause = "7.5.2.25",
    .entry = {.type = DataType::unsigned16, .initial = 0, .value = {.names = eds_formats}}};

inline constexpr EntryInfo module_entries[] = {
    {.name = "Number of connected modules", .initial = highest_sub()},
    {.sub_first = 1, .sub_last = 254, .name = "Module", .type = DataType::unsigned16, .initial = 0},
};
inline constexpr ObjectInfo module_list_object = {.index = 0x1027,
                                                  .code = ObjectCode::array,
                                                  .name = "Module list",
                                                  .category = Category::optional,
                                                  .clause = "7.5.2.30",
                                                  .subs = module_entries};

inline constexpr EntryInfo emergency_consumer_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Emergency consumer",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = invalid_cob_id,
     .value = code},
};
inline constexpr ObjectInfo emergency_consumer_object = {.index = 0x1028,
                                                         .code = ObjectCode::array,
                                                         .name = "Emergency consumer object",
                                                         .category = Category::optional,
                                                         .clause = "7.5.2.31",
                                                         .subs = emergency_consumer_entries};

/// What a device does when it is in state operational and an error comes (1029h).
enum class ErrorBehavior : std::uint8_t { pre_operational = 0, no_change = 1, stopped = 2 };
inline constexpr NamedValue error_behaviors[] = {
    {ErrorBehavior::pre_operational, "enter pre-operational"},
    {ErrorBehavior::no_change, "no change of state"},
    {ErrorBehavior::stopped, "enter stopped"},
};
inline constexpr EntryInfo error_behavior_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .name = "Communication error",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = error_behaviors}},
    {.sub_first = 2,
     .sub_last = 254,
     .name = "Profile- or manufacturer-specific error",
     .access = Access::rw,
     .category = Category::optional,
     .initial = 0,
     .value = {.names = error_behaviors}},
};
inline constexpr ObjectInfo error_behavior_object = {.index = 0x1029,
                                                     .code = ObjectCode::array,
                                                     .name = "Error behavior object",
                                                     .category = Category::optional,
                                                     .clause = "7.5.2.32",
                                                     .subs = error_behavior_entries};

}  // namespace canvoy::cia301
