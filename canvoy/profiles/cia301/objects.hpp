// Descriptions of the communication objects 1000h to 1029h (CiA 301 version 4.2, 7.5.2.1 to
// 7.5.2.32). Those of SDO and PDO are in channels.hpp; devices pick them with the help of
// cia301.hpp.
//
//     cia301::producer_heartbeat_object.entry.value.unit  // Unit::millisecond
#pragma once

#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia301 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Sub-index 00h of arrays and records that have no such entry of their own.
inline constexpr EntryInfo highest_sub_index =
    sub_index(0, "Highest sub-index supported", entry(unsigned8, const_, no, highest_sub()));

inline constexpr ValueInfo code = {.notation = Notation::hexadecimal};
inline constexpr ValueInfo milliseconds = {.unit = Unit::millisecond};
inline constexpr ValueInfo microseconds = {.unit = Unit::microsecond};
inline constexpr ValueInfo hundred_microseconds = {.unit = Unit::microsecond,
                                                   .scale = {.numerator = 100}};

inline constexpr std::uint32_t invalid_cob_id = 0x8000'0000;

inline constexpr auto device_type_object =
    var_object(0x1000, "Device type", "7.5.2.1",
               "The device profile in the low word, and what that profile adds above it.",
               entry(unsigned32, ro, no, 0, code));

inline constexpr FieldInfo error_register_bits[] = {
    field(0, 1, "Generic error"),
    field(1, 1, "Current"),
    field(2, 1, "Voltage"),
    field(3, 1, "Temperature"),
    field(4, 1, "Communication error"),
    field(5, 1, "Device profile specific"),
    field(7, 1, "Manufacturer-specific"),
};
inline constexpr auto error_register_object = var_object(
    0x1001, "Error register", "7.5.2.2", "One bit for each kind of error that is present.",
    entry(unsigned8, ro, optional, 0, {.notation = Notation::bit_mask}, error_register_bits));

/// Names of values of bit 5 in profiles that reserve it (CiA 419, 6.2.2; CiA 852, 11.3).
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

/// Makes the form that a profile gives an object of this standard: with another category.
constexpr ObjectInfo refined(ObjectInfo object, Category category, std::string_view clause,
                             std::string_view errata = {}, std::string_view condition = {}) {
  object.category = category;
  object.condition = condition;
  object.clause = clause;
  object.errata = errata;
  return object;
}
/// 1001h of profiles that reserve the bit of the device profile.
constexpr ObjectInfo error_register_with_reserve(std::string_view clause) {
  ObjectInfo object = refined(error_register_object, Category::mandatory, clause);
  object.entry.fields = error_register_bits_with_reserve;
  return object;
}

inline constexpr auto manufacturer_status_object =
    var_object(0x1002, "Manufacturer status register", "7.5.2.3", "",
               entry(unsigned32, ro, optional, 0, code), {.category = Category::optional});

inline constexpr EntryInfo error_field_entries[] = {
    sub_index(0, "Number of errors", entry(unsigned8, rw, no, 0),
              {.description = "Writing 0 forgets all errors; nothing else may be written."}),
    sub_index(1, 254, "Standard error field", entry(unsigned32, ro, no, 0, code),
              {.description = "Error code in the low word; the newest error is the first."}),
};
inline constexpr auto error_field_object =
    array_object(0x1003, "Pre-defined error field", "7.5.2.4", "", error_field_entries,
                 {.category = Category::optional});

inline constexpr auto sync_cob_id_object =
    var_object(0x1005, "COB-ID SYNC message", "7.5.2.5", "Bit 30: this device produces SYNC.",
               entry(unsigned32, rw, no, 0x80, code), {.category = Category::optional});
inline constexpr auto sync_period_object =
    var_object(0x1006, "Communication cycle period", "7.5.2.6", "",
               entry(unsigned32, rw, no, 0, microseconds), {.category = Category::optional});
inline constexpr auto sync_window_object =
    var_object(0x1007, "Synchronous window length", "7.5.2.7", "",
               entry(unsigned32, rw, no, 0, microseconds), {.category = Category::optional});

inline constexpr std::uint16_t name_capacity = 32;
inline constexpr EntryInfo name_entry = string_entry(visible_string, const_, name_capacity, "");
inline constexpr auto device_name_object =
    var_object(0x1008, "Manufacturer device name", "7.5.2.8", "", name_entry,
               {.category = Category::optional});
inline constexpr auto hardware_version_object =
    var_object(0x1009, "Manufacturer hardware version", "7.5.2.9", "", name_entry,
               {.category = Category::optional});
inline constexpr auto software_version_object =
    var_object(0x100A, "Manufacturer software version", "7.5.2.10", "", name_entry,
               {.category = Category::optional});

inline constexpr auto guard_time_object =
    var_object(0x100C, "Guard time", "7.5.2.11", "", entry(unsigned16, rw, no, 0, milliseconds),
               {.category = Category::optional});
inline constexpr auto life_time_factor_object =
    var_object(0x100D, "Life time factor", "7.5.2.12", "", entry(unsigned8, rw, no, 0),
               {.category = Category::optional});

/// Signatures that are written to start an action.
inline constexpr NamedValue save_signature[] = {{0x6576'6173, "save"}};
inline constexpr NamedValue load_signature[] = {{0x6461'6F6C, "load"}};

inline constexpr EntryInfo store_entries[] = {
    highest_sub_index,
    sub_index(
        1, 127, "Save parameters",
        entry(unsigned32, rw, no, 1, {.names = save_signature, .notation = Notation::hexadecimal}),
        {.description = "1 all, 2 communication, 3 application, 4 and above the manufacturer's."}),
};
inline constexpr auto store_object = array_object(0x1010, "Store parameters", "7.5.2.13", "",
                                                  store_entries, {.category = Category::optional});
inline constexpr EntryInfo restore_entries[] = {
    highest_sub_index,
    sub_index(
        1, 127, "Restore default parameters",
        entry(unsigned32, rw, no, 1, {.names = load_signature, .notation = Notation::hexadecimal}),
        {.description = "1 all, 2 communication, 3 application, 4 and above the manufacturer's."}),
};
inline constexpr auto restore_object =
    array_object(0x1011, "Restore default parameters", "7.5.2.14", "", restore_entries,
                 {.category = Category::optional});

inline constexpr auto time_cob_id_object =
    var_object(0x1012, "COB-ID time stamp object", "7.5.2.15",
               "Bit 31: this device consumes TIME; bit 30: it produces it.",
               entry(unsigned32, rw, no, 0x100, code), {.category = Category::optional});
inline constexpr auto high_resolution_time_object =
    var_object(0x1013, "High resolution time stamp", "7.5.2.16", "",
               entry(unsigned32, rw, optional, 0, microseconds), {.category = Category::optional});

inline constexpr auto emergency_cob_id_object =
    var_object(0x1014, "COB-ID emergency object", "7.5.2.17",
               "Bit 31: the device sends no emergency messages.",
               entry(unsigned32, rw, no, plus_node_id(0x80), code),
               {.condition = "if emergency is supported"});
inline constexpr auto emergency_inhibit_object = var_object(
    0x1015, "Inhibit time EMCY", "7.5.2.18", "", entry(unsigned16, rw, no, 0, hundred_microseconds),
    {.category = Category::optional});

inline constexpr FieldInfo consumer_heartbeat_fields[] = {
    field(0, 16, "Heartbeat time", milliseconds),
    field(16, 8, "Node-ID"),
};
inline constexpr EntryInfo consumer_heartbeat_entries[] = {
    highest_sub_index,
    sub_index(1, 127, "Consumer heartbeat time",
              entry(unsigned32, rw, no, 0, code, consumer_heartbeat_fields)),
};
inline constexpr auto consumer_heartbeat_object =
    array_object(0x1016, "Consumer heartbeat time", "7.5.2.19", "", consumer_heartbeat_entries,
                 {.category = Category::optional});
inline constexpr auto producer_heartbeat_object = var_object(
    0x1017, "Producer heartbeat time", "7.5.2.20", "0: no heartbeat.",
    entry(unsigned16, rw, no, 0, milliseconds), {.condition = "if guarding is not supported"});

inline constexpr EntryInfo identity_entries[] = {
    highest_sub_index,
    sub_index(1, "Vendor-ID", entry(unsigned32, ro, no, 0, code)),
    sub_index(2, "Product code", entry(unsigned32, ro, no, 0, code),
              {.category = Category::optional}),
    sub_index(3, "Revision number", entry(unsigned32, ro, no, 0, code),
              {.category = Category::optional}),
    sub_index(4, "Serial number", entry(unsigned32, ro, no, 0, code),
              {.category = Category::optional}),
};
inline constexpr auto identity_object =
    record_object(0x1018, "Identity object", "7.5.2.21", "", identity_entries);

inline constexpr auto sync_overflow_object =
    var_object(0x1019, "Synchronous counter overflow value", "7.5.2.22",
               "0: SYNC without a counter; 2 to 240: the last number that it counts to.",
               entry(unsigned8, rw, no, 0), {.category = Category::optional});

/// A date and a time, as in sub-indices 1 and 2 of 1020h and 1F52h.
constexpr EntryInfo date_entry(std::string_view name) {
  return sub_index(1, name, entry(unsigned32, rw, no, 0, {.unit = Unit::day}),
                   {.description = "Days since 1 January 1984."});
}
/// Time of day in milliseconds, at sub-index 02h.
constexpr EntryInfo time_entry(std::string_view name) {
  return sub_index(2, name, entry(unsigned32, rw, no, 0, milliseconds),
                   {.description = "Since midnight."});
}
inline constexpr EntryInfo verify_configuration_entries[] = {
    highest_sub_index, date_entry("Configuration date"), time_entry("Configuration time")};
inline constexpr auto verify_configuration_object =
    array_object(0x1020, "Verify configuration", "7.5.2.23", "", verify_configuration_entries,
                 {.category = Category::optional});

inline constexpr ObjectInfo store_eds_object = {.index = 0x1021,
                                                .code = ObjectCode::domain,
                                                .name = "Store EDS",
                                                .category = Category::optional,
                                                .clause = "7.5.2.24",
                                                .entry = entry(domain, ro)};
inline constexpr NamedValue eds_formats[] = {{0, "ISO 10646, not compressed"}};
inline constexpr auto store_format_object =
    var_object(0x1022, "Store format", "7.5.2.25", "", entry(unsigned16, ro, no, 0, eds_formats),
               {.condition = "if 1021h is supported"});

inline constexpr EntryInfo module_entries[] = {
    sub_index(0, "Number of connected modules", entry(unsigned8, ro, no, highest_sub())),
    sub_index(1, 254, "Module", entry(unsigned16, ro, no, 0)),
};
inline constexpr auto module_list_object = array_object(
    0x1027, "Module list", "7.5.2.30", "", module_entries, {.category = Category::optional});

inline constexpr EntryInfo emergency_consumer_entries[] = {
    highest_sub_index,
    sub_index(1, 127, "Emergency consumer", entry(unsigned32, rw, no, invalid_cob_id, code)),
};
inline constexpr auto emergency_consumer_object =
    array_object(0x1028, "Emergency consumer object", "7.5.2.31", "", emergency_consumer_entries,
                 {.category = Category::optional});

/// State change of a device on an error in NMT state operational (1029h).
enum class ErrorBehavior : std::uint8_t { pre_operational = 0, no_change = 1, stopped = 2 };
inline constexpr NamedValue error_behaviors[] = {
    {ErrorBehavior::pre_operational, "enter pre-operational"},
    {ErrorBehavior::no_change, "no change of state"},
    {ErrorBehavior::stopped, "enter stopped"},
};
inline constexpr EntryInfo error_behavior_entries[] = {
    highest_sub_index,
    sub_index(1, "Communication error", entry(unsigned8, rw, no, 0, error_behaviors)),
    sub_index(2, 254, "Profile- or manufacturer-specific error",
              entry(unsigned8, rw, no, 0, error_behaviors), {.category = Category::optional}),
};
inline constexpr auto error_behavior_object =
    array_object(0x1029, "Error behavior object", "7.5.2.32", "", error_behavior_entries,
                 {.category = Category::optional});

}  // namespace canvoy::cia301
