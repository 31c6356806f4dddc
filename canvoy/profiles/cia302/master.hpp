// Descriptions of the objects of an NMT master, 1F80h to 1F91h, and of the NMT inhibit time, 102Ah
// (CiA 302-2; CiA 301). In arrays, the sub-index is a slave's node-ID.
//
//     constexpr auto my_master = describe(cia301::device_type(0), cia301::error_register_object,
//                                         cia302::nmt_master({.startup = 0x01}));
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia302 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

inline constexpr auto nmt_inhibit_object = var_object(
    0x102A, "NMT inhibit time", "7.5.2.32",
    "The least time between two NMT commands of the master.",
    entry(unsigned16, rw, no, 0, cia301::hundred_microseconds), {.category = Category::optional});

inline constexpr FieldInfo nmt_startup_bits[] = {
    field(0, 1, "Is the NMT master"),
    field(1, 1, "Starts all nodes by one command"),
    field(2, 1, "Does not enter operational by itself"),
    field(3, 1, "Does not start the slaves"),
    field(4, 1, "Resets all nodes when a mandatory slave fails"),
    field(5, 1, "Is a flying master"),
    field(6, 1, "Stops all nodes when a mandatory slave fails"),
};
inline constexpr auto nmt_startup_object =
    var_object(0x1F80, "NMT startup", "302-2", "",
               entry(unsigned32, rw, no, 0, {.notation = Notation::bit_mask}, nmt_startup_bits),
               {.condition = "if the device may be NMT master"});

inline constexpr FieldInfo slave_assignment_fields[] = {
    field(0, 1, "Is a slave"),
    field(2, 1, "Is booted and started"),
    field(3, 1, "Is mandatory"),
    field(4, 1, "Is kept alive"),
    field(5, 1, "Software version is checked"),
    field(6, 1, "Software may be updated"),
    field(7, 1, "Configuration is restored"),
    field(8, 8, "Retry factor"),
    field(16, 16, "Guard time", cia301::milliseconds),
};
inline constexpr EntryInfo slave_assignment_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 127, "Assignment of slave",
              entry(unsigned32, rw, no, 0, cia301::code, slave_assignment_fields)),
};
inline constexpr auto slave_assignment_object =
    array_object(0x1F81, "Slave assignment", "302-2", "", slave_assignment_entries,
                 {.condition = "if 1F80h is supported"});

inline constexpr NamedValue nmt_requests[] = {
    {0, "unknown"},           {1, "missing"},
    {4, "stop, stopped"},     {5, "start, operational"},
    {6, "reset node"},        {7, "reset communication"},
    {127, "pre-operational"},
};
inline constexpr EntryInfo request_nmt_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 127, "Request NMT service for node", entry(unsigned8, rw, no, 0, nmt_requests)),
    sub_index(128, "Request NMT service for all nodes", entry(unsigned8, wo, no, 0, nmt_requests)),
};
inline constexpr auto request_nmt_object =
    array_object(0x1F82, "Request NMT", "302-2", "Written, a command; read, the state of the node.",
                 request_nmt_entries, {.category = Category::optional});

inline constexpr NamedValue guarding_requests[] = {{0, "not guarded"}, {1, "guarded"}};
inline constexpr EntryInfo request_guarding_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 127, "Request guarding of slave", entry(unsigned8, rw, no, 0, guarding_requests)),
    sub_index(128, "Request guarding of all slaves",
              entry(unsigned8, wo, no, 0, guarding_requests)),
};
inline constexpr auto request_guarding_object =
    array_object(0x1F83, "Request node guarding", "302-2", "", request_guarding_entries,
                 {.category = Category::optional});

/// Expected answers of a slave; 0: any.
inline constexpr EntryInfo expected_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 127, "Expected of slave", entry(unsigned32, rw, no, 0, cia301::code)),
};
/// One of 1F84h to 1F88h: what the master expects of each slave; 0: not checked.
constexpr ObjectInfo expected(std::uint16_t index, std::string_view name) {
  return array_object(index, name, "302-2", "", expected_entries, {.category = Category::optional});
}
inline constexpr ObjectInfo expected_device_type_object =
    expected(0x1F84, "Device type identification");
inline constexpr ObjectInfo expected_vendor_object = expected(0x1F85, "Vendor identification");
inline constexpr ObjectInfo expected_product_object = expected(0x1F86, "Product code");
inline constexpr ObjectInfo expected_revision_object = expected(0x1F87, "Revision number");
inline constexpr ObjectInfo expected_serial_object = expected(0x1F88, "Serial number");

inline constexpr auto boot_time_object = var_object(
    0x1F89, "Boot time", "302-2", "How long mandatory slaves are waited for; 0: without end.",
    entry(unsigned32, rw, no, 0, cia301::milliseconds), {.category = Category::optional});

/// Further objects, beside nmt_master() and configuration(), for a master that restores its slaves'
/// configuration.
inline constexpr EntryInfo restore_configuration_entries[] = {
    cia301::highest_sub_index,
    sub_index(1, 127, "Sub-index of 1011h of slave", entry(unsigned8, rw, no, 0),
              {.description =
                   "By which its defaults are restored before it is configured; 0: they are not."}),
};
inline constexpr auto restore_configuration_object =
    array_object(0x1F8A, "Restore configuration", "302-2", "", restore_configuration_entries,
                 {.category = Category::optional});

/// A time of 1F90h in milliseconds, with its default.
constexpr EntryInfo flying_time(std::uint8_t sub, std::string_view name, std::uint16_t ms) {
  return sub_index(sub, name, entry(unsigned16, rw, no, ms, cia301::milliseconds));
}
inline constexpr EntryInfo flying_master_entries[] = {
    cia301::highest_sub_index,
    flying_time(1, "Time to wait for the active NMT master", 100),
    flying_time(2, "Time from reset to the detection of an NMT master", 500),
    sub_index(3, "NMT master priority", entry(unsigned16, rw, no, 1, {.limits = within(0, 2)}),
              {.description = "0 is the highest of three levels."}),
    flying_time(4, "Priority time slot", 1500),
    flying_time(5, "Node time slot", 10),
    flying_time(6, "Cycle of the detection of several NMT masters", 4000),
};
inline constexpr auto flying_master_object =
    record_object(0x1F90, "NMT flying master timing parameter", "302-2", "", flying_master_entries,
                  {.condition = "if the device may be a flying master"});

inline constexpr EntryInfo startup_capable_entries[] = {
    cia301::highest_sub_index,
    flying_time(1, "Time to wait for devices that may be NMT master", 100),
    flying_time(2, "Time from reset to the detection", 500),
    flying_time(3, "Node time slot", 15),
};
inline constexpr auto startup_capable_object =
    record_object(0x1F91, "Startup capable device timing parameter", "302-2", "",
                  startup_capable_entries, {.category = Category::optional});

/// Objects that an NMT master has beside its start-up (1F80h).
struct NmtMasterOptions {
  std::uint32_t startup = 0x01;    ///< 1F80h
  std::uint32_t boot_time_ms = 0;  ///< 1F89h; 0: waits for mandatory slaves without limit
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
/// 1F90h and 1F91h of a device that takes part in the flying master process.
constexpr auto flying_master(std::uint16_t priority) {
  DeviceDescription<2> parts;
  parts.add(Part(flying_master_object).initial(3, priority));
  parts.add(startup_capable_object);
  return parts;
}

}  // namespace canvoy::cia302
