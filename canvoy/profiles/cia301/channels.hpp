// Descriptions of the communication objects of SDO and PDO, 1200h to 1BFFh and 1FA0h to 1FFFh (CiA
// 301 version 4.2, 7.5.2.33 to 7.5.2.40). Profiles that pre-define PDOs describe those themselves.
//
//     cia301::tpdo_parameter_object.count  // 512
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"

namespace canvoy::cia301 {

inline constexpr EntryInfo default_sdo_server_entries[] = {
    highest_sub_index,
    sub_index(1, "COB-ID client to server",
              entry(unsigned32, const_, no, plus_node_id(0x600), code)),
    sub_index(2, "COB-ID server to client",
              entry(unsigned32, const_, no, plus_node_id(0x580), code)),
};
inline constexpr auto default_sdo_server_object =
    record_object(0x1200, "SDO server parameter", "7.5.2.33", "", default_sdo_server_entries,
                  {.category = Category::optional});

/// COB-ID of an additional SDO channel: invalid by default.
inline constexpr EntryInfo sdo_cob_id(std::uint8_t sub, std::string_view name) {
  return sub_index(
      sub, name, entry(unsigned32, rw, no, invalid_cob_id, code),
      {.description = "Bit 31: invalid; bit 30: given out dynamically, and not stored."});
}
inline constexpr EntryInfo sdo_server_entries[] = {
    highest_sub_index,
    sdo_cob_id(1, "COB-ID client to server"),
    sdo_cob_id(2, "COB-ID server to client"),
    sub_index(3, "Node-ID of the SDO client", entry(unsigned8, rw, no, 0),
              {.category = Category::optional}),
};
inline constexpr auto sdo_server_object =
    record_object(0x1201, "SDO server parameter", "7.5.2.33", "", sdo_server_entries,
                  {.count = 127, .category = Category::optional});
inline constexpr EntryInfo sdo_client_entries[] = {
    highest_sub_index,
    sdo_cob_id(1, "COB-ID client to server"),
    sdo_cob_id(2, "COB-ID server to client"),
    sub_index(3, "Node-ID of the SDO server", entry(unsigned8, rw, no, 0)),
};
inline constexpr auto sdo_client_object =
    record_object(0x1280, "SDO client parameter", "7.5.2.34", "", sdo_client_entries,
                  {.count = 128, .category = Category::optional});

inline constexpr NamedValue transmission_types[] = {
    {0, "synchronous, acyclic"},
    {1, 240, "synchronous, every n-th SYNC", Meaning::state},
    {241, 251, "reserved", Meaning::reserved},
    {252, "synchronous, on request"},
    {253, "event-driven, on request"},
    {254, "event-driven, manufacturer"},
    {255, "event-driven, profile"},
};

/// Entries of PDO parameters. Profiles may give them other access and defaults.
inline constexpr EntryInfo pdo_cob_id_entry =
    sub_index(1, "COB-ID used by PDO", entry(unsigned32, rw, no, invalid_cob_id, code),
              {.description = "Bit 31: the PDO does not exist; bit 30 of a TPDO: not on request."});
inline constexpr EntryInfo transmission_type_entry =
    sub_index(2, "Transmission type", entry(unsigned8, rw, no, 255, transmission_types));
inline constexpr EntryInfo inhibit_time_entry =
    sub_index(3, "Inhibit time", entry(unsigned16, rw, no, 0, hundred_microseconds),
              {.category = Category::optional,
               .description = "The least time between two transmissions; 0: none."});
inline constexpr EntryInfo event_timer_entry =
    sub_index(5, "Event timer", entry(unsigned16, rw, no, 0, milliseconds),
              {.category = Category::optional,
               .description = "Of a TPDO the period, of an RPDO the deadline; 0: none."});
inline constexpr EntryInfo sync_start_entry = sub_index(
    6, "SYNC start value", entry(unsigned8, rw, no, 0),
    {.category = Category::optional,
     .description = "The number of the SYNC message with which the first period begins."});
inline constexpr EntryInfo mapping_number_entry = sub_index(
    0, "Number of mapped application objects in PDO", entry(unsigned8, rw, no, 0),
    {.description = "0 switches the mapping off, so that it can be changed; FEh and FFh make a "
                    "multiplexed PDO with source or destination addressing."});

inline constexpr EntryInfo rpdo_parameter_entries[] = {highest_sub_index, pdo_cob_id_entry,
                                                       transmission_type_entry, inhibit_time_entry,
                                                       event_timer_entry};
inline constexpr EntryInfo tpdo_parameter_entries[] = {highest_sub_index,       pdo_cob_id_entry,
                                                       transmission_type_entry, inhibit_time_entry,
                                                       event_timer_entry,       sync_start_entry};
inline constexpr EntryInfo pdo_mapping_entries[] = {
    mapping_number_entry,
    sub_index(1, 64, "Application object", entry(unsigned32, rw, no, 0, code),
              {.description = "Index, sub-index and length in bits."}),
};
inline constexpr auto rpdo_parameter_object =
    record_object(0x1400, "RPDO communication parameter", "7.5.2.35", "", rpdo_parameter_entries,
                  {.count = 512, .condition = "if the RPDO is supported"});
inline constexpr auto rpdo_mapping_object =
    record_object(0x1600, "RPDO mapping parameter", "7.5.2.36", "", pdo_mapping_entries,
                  {.count = 512, .condition = "if the RPDO is supported"});
inline constexpr auto tpdo_parameter_object =
    record_object(0x1800, "TPDO communication parameter", "7.5.2.37", "", tpdo_parameter_entries,
                  {.count = 512, .condition = "if the TPDO is supported"});
inline constexpr auto tpdo_mapping_object =
    record_object(0x1A00, "TPDO mapping parameter", "7.5.2.38", "", pdo_mapping_entries,
                  {.count = 512, .condition = "if the TPDO is supported"});

inline constexpr FieldInfo scanner_fields[] = {
    field(0, 8, "Sub-index"),
    field(8, 16, "Index", code),
    field(24, 8, "Block size"),
};
inline constexpr EntryInfo scanner_entries[] = {
    highest_sub_index,
    sub_index(
        1, 254, "Scan", entry(unsigned32, rw, no, 0, code, scanner_fields),
        {.description = "Objects that are sent by source address mode when they change; 0: none."}),
};
inline constexpr auto scanner_list_object =
    array_object(0x1FA0, "Object scanner list", "7.5.2.39", "", scanner_entries,
                 {.count = 48, .category = Category::optional});

inline constexpr FieldInfo dispatching_fields[] = {
    field(0, 8, "Node-ID of the producer"),
    field(8, 8, "Sub-index at the producer"),
    field(16, 16, "Index at the producer", code),
    field(32, 8, "Sub-index"),
    field(40, 16, "Index", code),
    field(56, 8, "Block size"),
};
inline constexpr EntryInfo dispatching_entries[] = {
    highest_sub_index,
    sub_index(1, 254, "Dispatch", entry(unsigned64, rw, no, 0, code, dispatching_fields),
              {.description = "Where values go that come by source address mode; 0: nowhere."}),
};
inline constexpr auto dispatching_list_object =
    array_object(0x1FD0, "Object dispatching list", "7.5.2.40", "", dispatching_entries,
                 {.count = 48, .category = Category::optional});

}  // namespace canvoy::cia301
