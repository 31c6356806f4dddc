// The communication objects of CiA 301. Each function makes the part of a device that its name
// says; each object is that part as it stands.
//
//     constexpr auto my_device = describe(cia301::device_type(0x0000'01A3),
//                                         cia301::error_register_object,
//                                         cia301::identity({.vendor_id = 0x123}),
//                                         cia301::heartbeat_producer(1000),
//                                         cia301::heartbeat_consumers(2), cia301::emergency());
#pragma once

#include "canvoy/canopen/pdo/mpdo.hpp"
#include "canvoy/profiles/cia301/channels.hpp"
#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy::cia301 {

/// 1000h.
constexpr Part device_type(std::uint32_t value) {
  return Part(device_type_object).initial(value);
}

/// Values of 1018h.
struct Identity {
  std::uint32_t vendor_id = 0;      ///< assigned by CiA; 0: none
  std::uint32_t product_code = 0;   ///< of the vendor
  std::uint32_t revision = 0;       ///< major revision in the upper half
  std::uint32_t serial_number = 0;  ///< of all devices of the kind; each device sets its own later
};
/// All of 1018h.
constexpr Part identity(const Identity& value) {
  return Part(identity_object)
      .initial(1, value.vendor_id)
      .initial(2, value.product_code)
      .initial(3, value.revision)
      .initial(4, value.serial_number);
}
/// 1008h to 100Ah.
struct Names {
  const char* device = "";            ///< 1008h
  const char* hardware_version = "";  ///< 1009h
  const char* software_version = "";  ///< 100Ah
};
/// Names 1008h to 100Ah as constant strings.
constexpr auto names(const Names& value) {
  DeviceDescription<3> parts;
  parts.add(Part(device_name_object).initial(Default(value.device)));
  parts.add(Part(hardware_version_object).initial(Default(value.hardware_version)));
  parts.add(Part(software_version_object).initial(Default(value.software_version)));
  return parts;
}

/// 1017h. With 0 ms, no heartbeat is sent until one is configured.
constexpr Part heartbeat_producer(std::uint16_t period_ms) {
  return Part(producer_heartbeat_object).initial(period_ms);
}
/// 1016h with room for `count` producers; none is watched yet.
constexpr Part heartbeat_consumers(unsigned count) {
  return Part(consumer_heartbeat_object).up_to(count);
}

/// 100Ch and 100Dh. Where both are above 0, the node monitors the master that guards it.
constexpr auto node_guarding(std::uint16_t guard_time_ms = 0, std::uint8_t life_time_factor = 0) {
  DeviceDescription<2> parts;
  parts.add(Part(guard_time_object).initial(guard_time_ms));
  parts.add(Part(life_time_factor_object).initial(life_time_factor));
  return parts;
}

/// 1014h and 1015h.
constexpr auto emergency() {
  DeviceDescription<2> parts;
  parts.add(emergency_cob_id_object);
  parts.add(emergency_inhibit_object);
  return parts;
}
/// 1003h with room for `count` errors.
constexpr Part error_history(unsigned count) {
  return Part(error_field_object).up_to(count);
}
/// 1028h with room for `count` producers.
constexpr Part emergency_consumers(unsigned count) {
  return Part(emergency_consumer_object).up_to(count);
}
/// 1029h with `classes` error classes; 1: communication errors alone.
constexpr Part error_behavior(unsigned classes = 1) {
  return Part(error_behavior_object).up_to(classes);
}

/// 1005h of a device that receives SYNC.
constexpr Part sync_consumer() {
  return sync_cob_id_object;
}
/// 1005h to 1007h and 1019h of a device that may produce SYNC.
constexpr auto sync() {
  DeviceDescription<4> parts;
  parts.add(sync_cob_id_object);
  parts.add(sync_period_object);
  parts.add(sync_window_object);
  parts.add(sync_overflow_object);
  return parts;
}
/// 1012h of a device that receives or sends the time of day from the start on.
constexpr Part time_consumer(std::uint32_t can_id = 0x100) {
  return Part(time_cob_id_object).initial(0x8000'0000 | can_id);
}
/// Object 1012h of a TIME producer; `can_id` is 100h by default.
constexpr Part time_producer(std::uint32_t can_id = 0x100) {
  return Part(time_cob_id_object).initial(0x4000'0000 | can_id);
}
/// 1010h and 1011h with sub-indices 1 to `count`, of a device with a Storage (canopen/storage).
constexpr auto storage(unsigned count) {
  DeviceDescription<2> parts;
  parts.add(Part(store_object).up_to(count));
  parts.add(Part(restore_object).up_to(count));
  return parts;
}

/// 1201h and above: `count` servers beside the default one.
constexpr Part sdo_servers(unsigned count) {
  return Part(sdo_server_object).only(0, count);
}
/// 1280h and above.
constexpr Part sdo_clients(unsigned count) {
  return Part(sdo_client_object).only(0, count);
}

/// A PDO that the device maker defines. `number` counts from 1; `entries` is the room of its
/// mapping.
struct PdoPart {
  unsigned number = 1;                    ///< of the PDO, from 1
  unsigned entries = 8;                   ///< of its mapping record
  Default cob_id = invalid_cob_id;        ///< by default invalid
  std::uint8_t transmission_type = 255;   ///< see transmission_type
  MpdoMode multiplexed = MpdoMode::none;  ///< by default
};
/// Both records of an RPDO.
constexpr auto rpdo(const PdoPart& pdo) {
  DeviceDescription<2> parts;
  parts.add(Part(rpdo_parameter_object)
                .only(pdo.number - 1)
                .initial(1, pdo.cob_id)
                .initial(2, pdo.transmission_type));
  parts.add(Part(rpdo_mapping_object)
                .only(pdo.number - 1)
                .up_to(pdo.entries)
                .initial(static_cast<std::uint8_t>(pdo.multiplexed)));
  return parts;
}
/// Both records of a TPDO.
constexpr auto tpdo(const PdoPart& pdo) {
  DeviceDescription<2> parts;
  parts.add(Part(tpdo_parameter_object)
                .only(pdo.number - 1)
                .initial(1, pdo.cob_id)
                .initial(2, pdo.transmission_type));
  parts.add(Part(tpdo_mapping_object)
                .only(pdo.number - 1)
                .up_to(pdo.entries)
                .initial(static_cast<std::uint8_t>(pdo.multiplexed)));
  return parts;
}
/// 1FA0h and above: `lists` lists with `entries` entries each, for a TPDO in source address mode.
constexpr Part scanner_lists(unsigned entries, unsigned lists = 1) {
  return Part(scanner_list_object).only(0, lists).up_to(entries);
}
/// 1FD0h and above: `lists` lists with `entries` entries each, for an RPDO in source address mode.
constexpr Part dispatching_lists(unsigned entries, unsigned lists = 1) {
  return Part(dispatching_list_object).only(0, lists).up_to(entries);
}

inline constexpr ErrorCodeInfo error_codes[] = {
    {0x0000, "error reset or no error"},
    {0x1000, "generic error"},
    {0x2000, "current"},
    {0x2100, "current, input side"},
    {0x2200, "current inside the device"},
    {0x2300, "current, output side"},
    {0x3000, "voltage"},
    {0x3100, "mains voltage"},
    {0x3200, "voltage inside the device"},
    {0x3300, "output voltage"},
    {0x4000, "temperature"},
    {0x4100, "ambient temperature"},
    {0x4200, "device temperature"},
    {0x5000, "device hardware"},
    {0x6000, "device software"},
    {0x6100, "internal software"},
    {0x6200, "user software"},
    {0x6300, "data set"},
    {0x7000, "additional modules"},
    {0x8000, "monitoring"},
    {0x8100, "communication"},
    {0x8110, "CAN overrun"},
    {0x8120, "CAN in error passive mode"},
    {0x8130, "life guard or heartbeat error"},
    {0x8140, "recovered from bus-off"},
    {0x8150, "CAN-ID collision"},
    {0x8200, "protocol error"},
    {0x8210, "PDO not processed: too short"},
    {0x8220, "PDO too long"},
    {0x8230, "destination object of a multiplexed PDO is missing"},
    {0x8240, "unexpected length of SYNC"},
    {0x8250, "RPDO timed out"},
    {0x9000, "external error"},
    {0xF000, "additional functions"},
    {0xFF00, "device specific"},
};

inline constexpr auto objects = objects_of(
    device_type_object, error_register_object, manufacturer_status_object, error_field_object,
    sync_cob_id_object, sync_period_object, sync_window_object, device_name_object,
    hardware_version_object, software_version_object, guard_time_object, life_time_factor_object,
    store_object, restore_object, time_cob_id_object, high_resolution_time_object,
    emergency_cob_id_object, emergency_inhibit_object, consumer_heartbeat_object,
    producer_heartbeat_object, identity_object, sync_overflow_object, verify_configuration_object,
    store_eds_object, store_format_object, module_list_object, emergency_consumer_object,
    error_behavior_object, default_sdo_server_object, sdo_server_object, sdo_client_object,
    rpdo_parameter_object, rpdo_mapping_object, tpdo_parameter_object, tpdo_mapping_object,
    scanner_list_object, dispatching_list_object);
inline constexpr Profile profile = {.number = 301,
                                    .name = "CiA 301",
                                    .title = "CANopen application layer and communication profile",
                                    .objects = objects,
                                    .error_codes = error_codes};

}  // namespace canvoy::cia301
