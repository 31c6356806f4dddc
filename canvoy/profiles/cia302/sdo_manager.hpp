// Descriptions of the objects of dynamic SDO connections, 1F00h to 1F06h and 1F10h (CiA 302-5).
//
// Names and types are public. The bits of 1F00h, 1F01h and 1F10h are known from devices in the
// field; the contents of 1F03h to 1F06h are our own reading.
//
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::sdo_manager(32, 16));
//     constexpr auto my_device = describe(cia301::device_type(0), cia302::sdo_requester());
#pragma once

#include "canvoy/profiles/cia301/channels.hpp"
#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia302 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

inline constexpr FieldInfo sdo_request_fields[] = {
    field(0, 8, "Node-ID of the SDO server"),
    field(8, 8, "Node-ID of the requesting device"),
    field(16, 16, "Index of its SDO client parameter"),
};
inline constexpr auto request_sdo_object =
    var_object(0x1F00, "Request SDO", "302-5", "",
               entry(unsigned32, wo, no, 0, cia301::code, sdo_request_fields),
               {.category = Category::optional});
inline constexpr auto release_sdo_object = var_object(
    0x1F01, "Release SDO", "302-5", "Index 0: all connections; server 0: the registration as well.",
    entry(unsigned32, wo, no, 0, cia301::code, sdo_request_fields),
    {.category = Category::optional});

inline constexpr EntryInfo sdo_manager_cob_id_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 254, "COB-ID", entry(unsigned32, rw, no, cia301::invalid_cob_id, cia301::code),
              {.description = "Bit 31: not to be given out."}),
};
inline constexpr auto sdo_manager_cob_ids_object =
    array_object(0x1F02, "SDO manager COB-IDs", "302-5",
                 "What the SDO manager has to give; two for each connection.",
                 sdo_manager_cob_id_entries, {.category = Category::optional});

inline constexpr FieldInfo sdo_connection_fields[] = {
    field(0, 8, "SDO server parameter, from 1200h on"),
    field(8, 8, "Node-ID of the SDO server"),
    field(16, 8, "SDO client parameter, from 1280h on"),
    field(24, 8, "Node-ID of the SDO client"),
};
inline constexpr EntryInfo sdo_connection_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 254, "SDO connection",
              entry(unsigned32, ro, no, 0, cia301::code, sdo_connection_fields),
              {.description = "0: none."}),
};
/// 1F03h to 1F06h.
inline constexpr auto sdo_connections_object =
    array_object(0x1F03, "SDO connections", "302-5", "Those that the SDO manager has given.",
                 sdo_connection_entries, {.count = 4, .category = Category::optional});

inline constexpr NamedValue dynamic_sdo_states[] = {
    {0, "not connected"},
    {1, "registered"},
    {2, "all requested SDOs given"},
    {3, "connection given"},
};
inline constexpr NamedValue dynamic_sdo_requests[] = {{0, "single"}, {1, "all default SDOs"}};
inline constexpr FieldInfo dynamic_sdo_fields[] = {
    field(0, 1, "Request", dynamic_sdo_requests),
    field(1, 2, "State", dynamic_sdo_states),
    field(8, 8, "Error code"),
    field(16, 16, "Index of the SDO client parameter"),
};
inline constexpr auto dynamic_sdo_state_object =
    var_object(0x1F10, "Dynamic SDO connection state", "302-5", "",
               entry(unsigned32, rw, no, 0, cia301::code, dynamic_sdo_fields),
               {.category = Category::optional});

/// 1F00h to 1F03h of an SDO manager that has `cob_ids` COB-IDs to assign, and room for
/// `connections` connections.
constexpr auto sdo_manager(unsigned cob_ids, unsigned connections) {
  DeviceDescription<4> parts;
  parts.add(request_sdo_object);
  parts.add(release_sdo_object);
  parts.add(Part(sdo_manager_cob_ids_object).up_to(cob_ids));
  parts.add(Part(sdo_connections_object).only(0).up_to(connections));
  return parts;
}
/// 1F10h and the SDO clients (1280h and above) of a device that requests SDO connections: one
/// client for the SDO manager, and `connections` for servers.
constexpr auto sdo_requester(unsigned connections = 1) {
  DeviceDescription<2> parts;
  parts.add(Part(cia301::sdo_client_object).only(0, 1 + connections));
  parts.add(dynamic_sdo_state_object);
  return parts;
}

}  // namespace canvoy::cia302
