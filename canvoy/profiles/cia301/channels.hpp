// Descriptions of the communication objects of SDO and PDO, 1200h to 1BFFh and 1FA0h to 1FFFh (CiA
// 301 version 4.2, 7.5.2.33 to 7.5.2.40). Profiles that pre-define PDOs describe those themselves.
//
//     cia301::tpdo_parameter_object.count  // 512
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"

namespace canvoy::cia301 {

inline constexpr EntryInfo default_sdo_server_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .name = "COB-ID client to server",
     .type = DataType::unsigned32,
     .access = Access::const_,
     .initial = plus_node_id(0x600),
     .value = code},
    {.sub_first = 2,
     .name = "COB-ID server to client",
     .type = DataType::unsigned32,
     .access = Access::const_,
     .initial = plus_node_id(0x580),
     .value = code},
};
inline constexpr ObjectInfo default_sdo_server_object = {.index = 0x1200,
                                                         .code = ObjectCode::record,
                                                         .name = "SDO server parameter",
                                                         .category = Category::optional,
                                                         .clause = "7.5.2.33",
                                                         .subs = default_sdo_server_entries};

inline constexpr EntryInfo sdo_cob_id(std::uint8_t sub, std::string_view name) {
  return {.sub_first = sub,
          .name = name,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = invalid_cob_id,
          .value = code,
          .description = "Bit 31: invalid; bit 30: given out dynamically, and not stored."};
}
inline constexpr EntryInfo sdo_server_entries[] = {
    highest_sub_index,
    sdo_cob_id(1, "COB-ID client to server"),
    sdo_cob_id(2, "COB-ID server to client"),
    {.sub_first = 3,
     .name = "Node-ID of the SDO client",
     .access = Access::rw,
     .category = Category::optional,
     .initial = 0},
};
inline constexpr ObjectInfo sdo_server_object = {.index = 0x1201,
                                                 .count = 127,
                                                 .code = ObjectCode::record,
                                                 .name = "SDO server parameter",
                                                 .category = Category::optional,
                                                 .clause = "7.5.2.33",
                                                 .subs = sdo_server_entries};
inline constexpr EntryInfo sdo_client_entries[] = {
    highest_sub_index,
    sdo_cob_id(1, "COB-ID client to server"),
    sdo_cob_id(2, "COB-ID server to client"),
    {.sub_first = 3, .name = "Node-ID of the SDO server", .access = Access::rw, .initial = 0},
};
inline constexpr ObjectInfo sdo_client_object = {.index = 0x1280,
                                                 .count = 128,
                                                 .code = ObjectCode::record,
                                                 .name = "SDO client parameter",
                                                 .category = Category::optional,
                                                 .clause = "7.5.2.34",
                                                 .subs = sdo_client_entries};

inline constexpr NamedValue transmission_types[] = {
    {0, "synchronous, acyclic"},
    {1, 240, "synchronous, every n-th SYNC", Meaning::state},
    {241, 251, "reserved", Meaning::reserved},
    {252, "synchronous, on request"},
    {253, "event-driven, on request"},
    {254, "event-driven, manufacturer"},
    {255, "event-driven, profile"},
};

/// The entries of PDO parameters, for profiles to choose from. Profiles may give them other access
/// and defaults.
inline constexpr EntryInfo pdo_cob_id_entry = {
    .sub_first = 1,
    .name = "COB-ID used by PDO",
    .type = DataType::unsigned32,
    .access = Access::rw,
    .initial = invalid_cob_id,
    .value = code,
    .description = "Bit 31: the PDO does not exist; bit 30 of a TPDO: not on request."};
inline constexpr EntryInfo transmission_type_entry = {.sub_first = 2,
                                                      .name = "Transmission type",
                                                      .access = Access::rw,
                                                      .initial = 255,
                                                      .value = {.names = transmission_types}};
inline constexpr EntryInfo inhibit_time_entry = {
    .sub_first = 3,
    .name = "Inhibit time",
    .type = DataType::unsigned16,
    .access = Access::rw,
    .category = Category::optional,
    .initial = 0,
    .value = hundred_microseconds,
    .description = "The least time between two transmissions; 0: none."};
inline constexpr EntryInfo event_timer_entry = {
    .sub_first = 5,
    .name = "Event timer",
    .type = DataType::unsigned16,
    .access = Access::rw,
    .category = Category::optional,
    .initial = 0,
    .value = milliseconds,
    .description = "Of a TPDO the period, of an RPDO the deadline; 0: none."};
inline constexpr EntryInfo sync_start_entry = {
    .sub_first = 6,
    .name = "SYNC start value",
    .access = Access::rw,
    .category = Category::optional,
    .initial = 0,
    .description = "The number of the SYNC message with which the first period begins."};
inline constexpr EntryInfo mapping_number_entry = {
    .name = "Number of mapped application objects in PDO",
    .access = Access::rw,
    .initial = 0,
    .description =
        "0 switches the mapping off, so that it can be changed; FEh and FFh make a "
        "multiplexed PDO with source or destination addressing."};

inline constexpr EntryInfo rpdo_parameter_entries[] = {highest_sub_index, pdo_cob_id_entry,
                                                       transmission_type_entry, inhibit_time_entry,
                                                       event_timer_entry};
inline constexpr EntryInfo tpdo_parameter_entries[] = {highest_sub_index,       pdo_cob_id_entry,
                                                       transmission_type_entry, inhibit_time_entry,
                                                       event_timer_entry,       sync_start_entry};
inline constexpr EntryInfo pdo_mapping_entries[] = {
    mapping_number_entry,
    {.sub_first = 1,
     .sub_last = 64,
     .name = "Application object",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = code,
     .description = "Index, sub-index and length in bits."},
};
inline constexpr ObjectInfo rpdo_parameter_object = {.index = 0x1400,
                                                     .count = 512,
                                                     .code = ObjectCode::record,
                                                     .name = "RPDO communication parameter",
                                                     .category = Category::conditional,
                                                     .condition = "if the RPDO is supported",
                                                     .clause = "7.5.2.35",
                                                     .subs = rpdo_parameter_entries};
inline constexpr ObjectInfo rpdo_mapping_object = {.index = 0x1600,
                                                   .count = 512,
                                                   .code = ObjectCode::record,
                                                   .name = "RPDO mapping parameter",
                                                   .category = Category::conditional,
                                                   .condition = "if the RPDO is supported",
                                                   .clause = "7.5.2.36",
                                                   .subs = pdo_mapping_entries};
inline constexpr ObjectInfo tpdo_parameter_object = {.index = 0x1800,
                                                     .count = 512,
                                                     .code = ObjectCode::record,
                                                     .name = "TPDO communication parameter",
                                                     .category = Category::conditional,
                                                     .condition = "if the TPDO is supported",
                                                     .clause = "7.5.2.37",
                                                     .subs = tpdo_parameter_entries};
inline constexpr ObjectInfo tpdo_mapping_object = {.index = 0x1A00,
                                                   .count = 512,
                                                   .code = ObjectCode::record,
                                                   .name = "TPDO mapping parameter",
                                                   .category = Category::conditional,
                                                   .condition = "if the TPDO is supported",
                                                   .clause = "7.5.2.38",
                                                   .subs = pdo_mapping_entries};

inline constexpr FieldInfo scanner_fields[] = {
    {.first_bit = 0, .bits = 8, .name = "Sub-index"},
    {.first_bit = 8, .bits = 16, .name = "Index", .value = code},
    {.first_bit = 24, .bits = 8, .name = "Block size"},
};
inline constexpr EntryInfo scanner_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Scan",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = code,
     .fields = scanner_fields,
     .description = "Objects that are sent by source address mode when they change; 0: none."},
};
inline constexpr ObjectInfo scanner_list_object = {.index = 0x1FA0,
                                                   .count = 48,
                                                   .code = ObjectCode::array,
                                                   .name = "Object scanner list",
                                                   .category = Category::optional,
                                                   .clause = "7.5.2.39",
                                                   .subs = scanner_entries};

inline constexpr FieldInfo dispatching_fields[] = {
    {.first_bit = 0, .bits = 8, .name = "Node-ID of the producer"},
    {.first_bit = 8, .bits = 8, .name = "Sub-index at the producer"},
    {.first_bit = 16, .bits = 16, .name = "Index at the producer", .value = code},
    {.first_bit = 32, .bits = 8, .name = "Sub-index"},
    {.first_bit = 40, .bits = 16, .name = "Index", .value = code},
    {.first_bit = 56, .bits = 8, .name = "Block size"},
};
inline constexpr EntryInfo dispatching_entries[] = {
    highest_sub_index,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Dispatch",
     .type = DataType::unsigned64,
     .access = Access::rw,
     .initial = 0,
     .value = code,
     .fields = dispatching_fields,
     .description = "Where values go that come by source address mode; 0: nowhere."},
};
inline constexpr ObjectInfo dispatching_list_object = {.index = 0x1FD0,
                                                       .count = 48,
                                                       .code = ObjectCode::array,
                                                       .name = "Object dispatching list",
                                                       .category = Category::optional,
                                                       .clause = "7.5.2.40",
                                                       .subs = dispatching_entries};

}  // namespace canvoy::cia301
