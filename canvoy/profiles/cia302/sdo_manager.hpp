// Descriptions of the objects of dynamic SDO connections, 1F00h to 1F06h and 1F10h (CiA 302-5).
//
// Names and types are public; what the bits of 1F00h, 1F01h and 1F10h say is known from devices in
// the field, and what stands in 1F03h to 1F06h is our own reading.
//
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::sdo_manager(32, 16));
//     constexpr auto my_device = describe(cia301::device_type(0), cia302::sdo_requester());
#pragma once

#include "canvoy/profiles/cia301/channels.hpp"
#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::cia302 {

inline constexpr FieldInfo sdo_request_fields[] = {
    {.first_bit = 0, .bits = 8, .name = "Node-ID of the SDO server"},
    {.first_bit = 8, .bits = 8, .name = "Node-ID of the requesting device"},
    {.first_bit = 16, .bits = 16, .name = "Index of its SDO client parameter"},
};
inline constexpr ObjectInfo request_sdo_object = {.index = 0x1F00,
                                                  .name = "Request SDO",
                                                  .category = Category::optional,
                                                  .clause = "302-5",
                                                  .entry = {.type = DataType::unsigned32,
                                                            .access = Access::wo,
                                                            .initial = 0,
                                                            .value = cia301::code,
                                                            .fields = sdo_request_fields}};
inline constexpr ObjectInfo release_sdo_object = {
    .index = 0x1F01,
    .name = "Release SDO",
    .category = Category::optional,
    .clause = "302-5",
    .description = "Index 0: all connections; server 0: the registration as well.",
    .entry = {.type = DataType::unsigned32,
              .access = Access::wo,
              .initial = 0,
              .value = cia301::code,
              .fields = sdo_request_fields}};

inline constexpr EntryInfo sdo_manager_cob_id_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "COB-ID",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = cia301::invalid_cob_id,
     .value = cia301::code,
     .description = "Bit 31: not to be given out."},
};
inline constexpr ObjectInfo sdo_manager_cob_ids_object = {
    .index = 0x1F02,
    .code = ObjectCode::array,
    .name = "SDO manager COB-IDs",
    .category = Category::optional,
    .clause = "302-5",
    .description = "What the SDO manager has to give; two for each connection.",
    .subs = sdo_manager_cob_id_entries};

inline constexpr FieldInfo sdo_connection_fields[] = {
    {.first_bit = 0, .bits = 8, .name = "SDO server parameter, from 1200h on"},
    {.first_bit = 8, .bits = 8, .name = "Node-ID of the SDO server"},
    {.first_bit = 16, .bits = 8, .name = "SDO client parameter, from 1280h on"},
    {.first_bit = 24, .bits = 8, .name = "Node-ID of the SDO client"},
};
inline constexpr EntryInfo sdo_connection_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "SDO connection",
     .type = DataType::unsigned32,
     .initial = 0,
     .value = cia301::code,
     .fields = sdo_connection_fields,
     .description = "0: none."},
};
/// 1F03h to 1F06h.
inline constexpr ObjectInfo sdo_connections_object = {
    .index = 0x1F03,
    .count = 4,
    .code = ObjectCode::array,
    .name = "SDO connections",
    .category = Category::optional,
    .clause = "302-5",
    .description = "Those that the SDO manager has given.",
    .subs = sdo_connection_entries};

inline constexpr NamedValue dynamic_sdo_states[] = {
    {0, "not connected"},
    {1, "registered"},
    {2, "all requested SDOs given"},
    {3, "connection given"},
};
inline constexpr NamedValue dynamic_sdo_requests[] = {{0, "single"}, {1, "all default SDOs"}};
inline constexpr FieldInfo dynamic_sdo_fields[] = {
    {.first_bit = 0, .name = "Request", .value = {.names = dynamic_sdo_requests}},
    {.first_bit = 1, .bits = 2, .name = "State", .value = {.names = dynamic_sdo_states}},
    {.first_bit = 8, .bits = 8, .name = "Error code"},
    {.first_bit = 16, .bits = 16, .name = "Index of the SDO client parameter"},
};
inline constexpr ObjectInfo dynamic_sdo_state_object = {.index = 0x1F10,
                                                        .name = "Dynamic SDO connection state",
                                                        .category = Category::optional,
                                                        .clause = "302-5",
                                                        .entry = {.type = DataType::unsigned32,
                                                                  .access = Access::rw,
                                                                  .initial = 0,
                                                                  .value = cia301::code,
                                                                  .fields = dynamic_sdo_fields}};

/// 1F00h to 1F03h of an SDO manager that has `cob_ids` to give, and lists `connections`.
constexpr auto sdo_manager(unsigned cob_ids, unsigned connections) {
  DeviceDescription<4> parts;
  parts.add(request_sdo_object);
  parts.add(release_sdo_object);
  parts.add(Part(sdo_manager_cob_ids_object).up_to(cob_ids));
  parts.add(Part(sdo_connections_object).only(0).up_to(connections));
  return parts;
}
/// 1F10h, and the SDO clients (1280h and above) of a device that requests SDO connections: one
/// to the SDO manager, and `connections` to servers.
constexpr auto sdo_requester(unsigned connections = 1) {
  DeviceDescription<2> parts;
  parts.add(Part(cia301::sdo_client_object).only(0, 1 + connections));
  parts.add(dynamic_sdo_state_object);
  return parts;
}

}  // namespace canvoy::cia302
