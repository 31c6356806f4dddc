// Descriptions of the objects of an NMT master, 1F80h to 1F91h, and of the NMT inhibit time (CiA
// 302-2; CiA 301 for 102Ah). Of the arrays, the sub-index is a slave's node-ID.
//
//     constexpr auto my_master = describe(cia301::device_type(0), cia301::error_register_object,
//                                         cia302::nmt_master({.startup = 0x01}));
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::cia302 {

inline constexpr ObjectInfo nmt_inhibit_object = {
    .index = 0x102A,
    .name = "NMT inhibit time",
    .category = Category::optional,
    .clause = "7.5.2.32",
    .description = "The least time between two NMT commands of the master.",
    .entry = {.type = DataType::unsigned16,
              .access = Access::rw,
              .initial = 0,
              .value = cia301::hundred_microseconds}};

inline constexpr FieldInfo nmt_startup_bits[] = {
    {.first_bit = 0, .name = "Is the NMT master"},
    {.first_bit = 1, .name = "Starts all nodes by one command"},
    {.first_bit = 2, .name = "Does not enter operational by itself"},
    {.first_bit = 3, .name = "Does not start the slaves"},
    {.first_bit = 4, .name = "Resets all nodes when a mandatory slave fails"},
    {.first_bit = 5, .name = "Is a flying master"},
    {.first_bit = 6, .name = "Stops all nodes when a mandatory slave fails"},
};
inline constexpr ObjectInfo nmt_startup_object = {
    .index = 0x1F80,
    .name = "NMT startup",
    .category = Category::conditional,
    .condition = "if the device may be NMT master",
    .clause = "302-2",
    .entry = {.type = DataType::unsigned32,
              .access = Access::rw,
              .initial = 0,
              .value = {.notation = Notation::bit_mask},
              .fields = nmt_startup_bits}};

inline constexpr FieldInfo slave_assignment_fields[] = {
    {.first_bit = 0, .name = "Is a slave"},
    {.first_bit = 2, .name = "Is booted and started"},
    {.first_bit = 3, .name = "Is mandatory"},
    {.first_bit = 4, .name = "Is kept alive"},
    {.first_bit = 5, .name = "Software version is checked"},
    {.first_bit = 6, .name = "Software may be updated"},
    {.first_bit = 7, .name = "Configuration is restored"},
    {.first_bit = 8, .bits = 8, .name = "Retry factor"},
    {.first_bit = 16, .bits = 16, .name = "Guard time", .value = cia301::milliseconds},
};
inline constexpr EntryInfo slave_assignment_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Assignment of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = cia301::code,
     .fields = slave_assignment_fields},
};
inline constexpr ObjectInfo slave_assignment_object = {.index = 0x1F81,
                                                       .code = ObjectCode::array,
                                                       .name = "Slave assignment",
                                                       .category = Category::conditional,
                                                       .condition = "if 1F80h is supported",
                                                       .clause = "302-2",
                                                       .subs = slave_assignment_entries};

inline constexpr NamedValue nmt_requests[] = {
    {0, "unknown"},           {1, "missing"},
    {4, "stop, stopped"},     {5, "start, operational"},
    {6, "reset node"},        {7, "reset communication"},
    {127, "pre-operational"},
};
inline constexpr EntryInfo request_nmt_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Request NMT service for node",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = nmt_requests}},
    {.sub_first = 128,
     .name = "Request NMT service for all nodes",
     .access = Access::wo,
     .initial = 0,
     .value = {.names = nmt_requests}},
};
inline constexpr ObjectInfo request_nmt_object = {
    .index = 0x1F82,
    .code = ObjectCode::array,
    .name = "Request NMT",
    .category = Category::optional,
    .clause = "302-2",
    .description = "Written, a command; read, the state of the node.",
    .subs = request_nmt_entries};

inline constexpr NamedValue guarding_requests[] = {{0, "not guarded"}, {1, "guarded"}};
inline constexpr EntryInfo request_guarding_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Request guarding of slave",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = guarding_requests}},
    {.sub_first = 128,
     .name = "Request guarding of all slaves",
     .access = Access::wo,
     .initial = 0,
     .value = {.names = guarding_requests}},
};
inline constexpr ObjectInfo request_guarding_object = {.index = 0x1F83,
                                                       .code = ObjectCode::array,
                                                       .name = "Request node guarding",
                                                       .category = Category::optional,
                                                       .clause = "302-2",
                                                       .subs = request_guarding_entries};

/// What a slave is expected to answer; 0: anything.
inline constexpr EntryInfo expected_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = cia301::code},
};
constexpr ObjectInfo expected(std::uint16_t index, std::string_view name) {
  return {.index = index,
          .code = ObjectCode::array,
          .name = name,
          .category = Category::optional,
          .clause = "302-2",
          .subs = expected_entries};
}
inline constexpr ObjectInfo expected_device_type_object =
    expected(0x1F84, "Device type identification");
inline constexpr ObjectInfo expected_vendor_object = expected(0x1F85, "Vendor identification");
inline constexpr ObjectInfo expected_product_object = expected(0x1F86, "Product code");
inline constexpr ObjectInfo expected_revision_object = expected(0x1F87, "Revision number");
inline constexpr ObjectInfo expected_serial_object = expected(0x1F88, "Serial number");

inline constexpr ObjectInfo boot_time_object = {
    .index = 0x1F89,
    .name = "Boot time",
    .category = Category::optional,
    .clause = "302-2",
    .description = "How long mandatory slaves are waited for; 0: without end.",
    .entry = {.type = DataType::unsigned32,
              .access = Access::rw,
              .initial = 0,
              .value = cia301::milliseconds}};

/// Beside nmt_master() and configuration(), for a master that has slaves restored.
inline constexpr EntryInfo restore_configuration_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Sub-index of 1011h of slave",
     .access = Access::rw,
     .initial = 0,
     .description = "By which its defaults are restored before it is configured; 0: they are not."},
};
inline constexpr ObjectInfo restore_configuration_object = {.index = 0x1F8A,
                                                            .code = ObjectCode::array,
                                                            .name = "Restore configuration",
                                                            .category = Category::optional,
                                                            .clause = "302-2",
                                                            .subs = restore_configuration_entries};

constexpr EntryInfo flying_time(std::uint8_t sub, std::string_view name, std::uint16_t ms) {
  return {.sub_first = sub,
          .name = name,
          .type = DataType::unsigned16,
          .access = Access::rw,
          .initial = ms,
          .value = cia301::milliseconds};
}
inline constexpr EntryInfo flying_master_entries[] = {
    cia301::highest_sub_index,
    flying_time(1, "Time to wait for the active NMT master", 100),
    flying_time(2, "Time from reset to the detection of an NMT master", 500),
    {.sub_first = 3,
     .name = "NMT master priority",
     .type = DataType::unsigned16,
     .access = Access::rw,
     .initial = 1,
     .value = {.limits = within(0, 2)},
     .description = "0 is the highest of three levels."},
    flying_time(4, "Priority time slot", 1500),
    flying_time(5, "Node time slot", 10),
    flying_time(6, "Cycle of the detection of several NMT masters", 4000),
};
inline constexpr ObjectInfo flying_master_object = {
    .index = 0x1F90,
    .code = ObjectCode::record,
    .name = "NMT flying master timing parameter",
    .category = Category::conditional,
    .condition = "if the device may be a flying master",
    .clause = "302-2",
    .subs = flying_master_entries};

inline constexpr EntryInfo startup_capable_entries[] = {
    cia301::highest_sub_index,
    flying_time(1, "Time to wait for devices that may be NMT master", 100),
    flying_time(2, "Time from reset to the detection", 500),
    flying_time(3, "Node time slot", 15),
};
inline constexpr ObjectInfo startup_capable_object = {
    .index = 0x1F91,
    .code = ObjectCode::record,
    .name = "Startup capable device timing parameter",
    .category = Category::optional,
    .clause = "302-2",
    .subs = startup_capable_entries};

struct NmtMasterOptions {
  std::uint32_t startup = 0x01;    ///< 1F80h
  std::uint32_t boot_time_ms = 0;  ///< 1F89h; 0: mandatory slaves are waited for without end
};
/// 102Ah and 1F80h to 1F89h.
constexpr auto nmt_master(const NmtMasterOptions& options = {}) {
  DeviceDescription<11> parts;
  parts.add(nmt_inhibit_object);
  parts.add(Part(nmt_startup_object).initial(options.startup));
  parts.add(slave_assignment_object);
  parts.add(request_nmt_object);
  parts.add(request_guarding_object);
  parts.add(expected_device_type_object);
  parts.add(expected_vendor_object);
  parts.add(expected_product_object);
  parts.add(expected_revision_object);
  parts.add(expected_serial_object);
  parts.add(Part(boot_time_object).initial(options.boot_time_ms));
  return parts;
}
/// 1F90h and 1F91h of a device that competes for being the NMT master.
constexpr auto flying_master(std::uint16_t priority) {
  DeviceDescription<2> parts;
  parts.add(Part(flying_master_object).initial(3, priority));
  parts.add(startup_capable_object);
  return parts;
}

}  // namespace canvoy::cia302
