// Indices of the objects of the communication profile; each number is written only here (CiA 301,
// 7.5.2; CiA 302 from 1F00h on).
//
//     dictionary.word(object_index::cob_id_sync, 0);
#pragma once

#include <cstdint>

namespace canvoy::object_index {

inline constexpr std::uint16_t communication_first = 0x1000;
inline constexpr std::uint16_t communication_last = 0x1FFF;

inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t error_register = 0x1001;
inline constexpr std::uint16_t error_history = 0x1003;  ///< pre-defined error field
inline constexpr std::uint16_t cob_id_sync = 0x1005;
inline constexpr std::uint16_t sync_period = 0x1006;
inline constexpr std::uint16_t sync_window = 0x1007;
inline constexpr std::uint16_t device_name = 0x1008;
inline constexpr std::uint16_t hardware_version = 0x1009;
inline constexpr std::uint16_t software_version = 0x100A;
inline constexpr std::uint16_t guard_time = 0x100C;
inline constexpr std::uint16_t life_time_factor = 0x100D;
inline constexpr std::uint16_t store_parameters = 0x1010;
inline constexpr std::uint16_t restore_parameters = 0x1011;
inline constexpr std::uint16_t cob_id_time = 0x1012;
inline constexpr std::uint16_t high_resolution_time = 0x1013;
inline constexpr std::uint16_t cob_id_emergency = 0x1014;
inline constexpr std::uint16_t emergency_inhibit_time = 0x1015;
inline constexpr std::uint16_t heartbeat_consumers = 0x1016;
inline constexpr std::uint16_t heartbeat_producer = 0x1017;
inline constexpr std::uint16_t identity = 0x1018;
inline constexpr std::uint16_t sync_counter_overflow = 0x1019;
inline constexpr std::uint16_t verify_configuration = 0x1020;
inline constexpr std::uint16_t store_eds = 0x1021;
inline constexpr std::uint16_t store_eds_format = 0x1022;
inline constexpr std::uint16_t emergency_consumers = 0x1028;
inline constexpr std::uint16_t error_behaviour = 0x1029;
inline constexpr std::uint16_t nmt_inhibit_time = 0x102A;

// For SDO channels and PDOs, the first index of many.
inline constexpr std::uint16_t sdo_server = 0x1200;
inline constexpr std::uint16_t sdo_server_last = 0x127F;
inline constexpr std::uint16_t sdo_client = 0x1280;
inline constexpr std::uint16_t sdo_client_last = 0x12FF;
inline constexpr std::uint16_t rpdo_parameter = 0x1400;
inline constexpr std::uint16_t rpdo_parameter_last = 0x15FF;
inline constexpr std::uint16_t rpdo_mapping = 0x1600;
inline constexpr std::uint16_t rpdo_mapping_last = 0x17FF;
inline constexpr std::uint16_t tpdo_parameter = 0x1800;
inline constexpr std::uint16_t tpdo_parameter_last = 0x19FF;
inline constexpr std::uint16_t tpdo_mapping = 0x1A00;
inline constexpr std::uint16_t tpdo_mapping_last = 0x1BFF;
inline constexpr std::uint16_t scanner_list = 0x1FA0;
inline constexpr std::uint16_t scanner_list_last = 0x1FCF;
inline constexpr std::uint16_t dispatching_list = 0x1FD0;
inline constexpr std::uint16_t dispatching_list_last = 0x1FFF;

inline constexpr std::uint16_t sdo_cob_ids = 0x1F02;  ///< COB-IDs of dynamic SDO connections
inline constexpr std::uint16_t dcf = 0x1F20;
inline constexpr std::uint16_t concise_dcf = 0x1F22;
inline constexpr std::uint16_t slave_eds = 0x1F23;
inline constexpr std::uint16_t configure_slave = 0x1F25;
inline constexpr std::uint16_t expected_configuration_date = 0x1F26;
inline constexpr std::uint16_t expected_configuration_time = 0x1F27;
inline constexpr std::uint16_t flying_master_timing = 0x1F90;
inline constexpr std::uint16_t capable_master_timing = 0x1F91;

}  // namespace canvoy::object_index
